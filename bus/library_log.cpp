// bus/library_log.cpp: the sink for the library's messages.
#include "bus/library_log.hpp"

#include <cstdio>
#include <mutex>
#include <string_view>

#include <dds/ddsrt/log.h>

#include "bus/clock.hpp"

namespace teamsight::bus {
namespace {

constexpr std::uint32_t kLinesPerWindow = 10;
constexpr Duration kWindow = std::chrono::seconds(10);
constexpr std::size_t kMaxCaptured = 2000;

// The library has one sink per process, called on any of its threads; so this is one, too.
struct Sink {
  std::mutex mutex;
  LibraryLogCounters counters;
  HostTime window_start{};
  std::uint32_t printed{0};
  bool capturing{false};
  std::string captured;
};

// Never destroyed: the library's threads may still speak while the process ends.
Sink& sink() {
  static Sink* const instance = new Sink;
  return *instance;
}

std::string_view trimmed(const dds_log_data_t& data) {
  std::string_view text(data.message, data.size);
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.remove_suffix(1);
  return text;
}

void print_limited(Sink& s, std::string_view text) {
  const HostTime now = host_now();
  if (now - s.window_start >= kWindow) {
    s.window_start = now;
    s.printed = 0;
  }
  if (s.printed >= kLinesPerWindow) {
    ++s.counters.suppressed;
    return;
  }
  ++s.printed;
  const auto length = static_cast<int>(text.size());
  std::fprintf(stderr,
               "dds: %.*s%s\n",
               length,
               text.data(),
               s.printed == kLinesPerWindow ? " (more is counted, not printed)" : "");
}

void receive(void* /*unused*/, const dds_log_data_t* data) noexcept {
  Sink& s = sink();
  const std::lock_guard lock(s.mutex);
  ++s.counters.lines;
  const std::string_view text = trimmed(*data);
  if (!s.capturing) return print_limited(s, text);
  if (s.captured.size() + text.size() > kMaxCaptured) return;
  if (!s.captured.empty()) s.captured += "; ";
  s.captured += text;
}

}  // namespace

LibraryLogCounters library_log_counters() noexcept {
  Sink& s = sink();
  const std::lock_guard lock(s.mutex);
  return s.counters;
}

void install_library_log() noexcept {
  dds_set_log_sink(&receive, nullptr);
}

LibraryLogCapture::LibraryLogCapture() {
  install_library_log();
  const std::lock_guard lock(sink().mutex);
  sink().capturing = true;
  sink().captured.clear();
}

LibraryLogCapture::~LibraryLogCapture() {
  const std::lock_guard lock(sink().mutex);
  sink().capturing = false;
}

std::string LibraryLogCapture::text() {
  const std::lock_guard lock(sink().mutex);
  return sink().captured;
}

}  // namespace teamsight::bus
