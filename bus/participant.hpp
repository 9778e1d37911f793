// bus/participant.hpp: joining a DDS domain from a checked configuration.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace teamsight::bus {

/// The process cannot join: one line that names the file, what was found and what was expected.
class BusError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which domain to join, and how.
struct DomainSettings {
  std::uint32_t domain_id{0};
  std::string profile_path;  ///< a Cyclone DDS XML file (config/dds)
  std::string tag;           ///< participants with different tags never meet; empty = none
};

/// One DDS participant. All readers and writers of a process are made at start, before any
/// traffic, and destroyed before it. Move-only. Use from one thread.
class Participant {
 public:
  /// Reads the profile, makes the domain from it and joins; while no network interface is up it
  /// tries again every second for as long as `keep_trying()` is true.
  ///
  /// The profile replaces the environment: CYCLONEDDS_URI is not consulted, and a profile that
  /// does not parse never falls back to defaults.
  ///
  /// @throws BusError if the file cannot be read, does not parse, or names a missing interface
  ///         (the library's own reason is in the message), or when keep_trying() turned false
  [[nodiscard]] static Participant join(const DomainSettings& settings,
                                        const std::function<bool()>& keep_trying = [] {
                                          return false;
                                        });

  Participant(Participant&&) noexcept;
  Participant& operator=(Participant&&) noexcept;
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;
  ~Participant();

  /// Cyclone's handle, for bus/ only.
  [[nodiscard]] std::int32_t handle() const noexcept;

 private:
  struct Impl;
  explicit Participant(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::bus
