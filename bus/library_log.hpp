// bus/library_log.hpp: what the DDS library wants to print, counted and at a limited rate.
#pragma once

#include <cstdint>
#include <string>

namespace teamsight::bus {

/// How much the DDS library of this process had to say: malformed packets, above all.
struct LibraryLogCounters {
  std::uint64_t lines{0};
  std::uint64_t suppressed{0};  ///< of these, not printed
};

/// Since the process started. From any thread.
[[nodiscard]] LibraryLogCounters library_log_counters() noexcept;

/// Takes the library's messages away from stderr: from now on at most 10 of them in 10 seconds are
/// printed there, the rest is counted. Participant::join does this. From any thread, any number of
/// times.
void install_library_log() noexcept;

/// While it lives, the library's messages are kept here and not printed. One at a time.
class LibraryLogCapture {
 public:
  LibraryLogCapture();
  ~LibraryLogCapture();
  LibraryLogCapture(const LibraryLogCapture&) = delete;
  LibraryLogCapture& operator=(const LibraryLogCapture&) = delete;

  /// The messages so far, "; " between them; empty if there was none.
  [[nodiscard]] static std::string text();
};

}  // namespace teamsight::bus
