// recording/recorder.cpp: see recording/recorder.hpp.
#include "recording/recorder.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <ctime>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "bus/clock.hpp"
#include "recording/mcap_reader.hpp"
#include "recording/output_file.hpp"

namespace teamsight::recording {
namespace {

using SteadyTime = std::chrono::steady_clock::time_point;

struct Entry {
  ChannelId channel{0};
  MessageStamp stamp;
  std::string payload;
};

/// Local time of day as YYYYMMDD-HHMMSS.
std::string date_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  localtime_r(&now, &parts);
  std::array<char, 32> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", &parts);
  return {text.data(), size};
}

/// One file of the recording, being written.
struct OpenFile {
  OpenFile(const std::filesystem::path& where, const std::string& library)
      : path(where),
        file(where),
        writer([this](std::string_view bytes) { return file.write(bytes); }, library) {}

  std::filesystem::path path;
  OutputFile file;
  McapWriter writer;
  std::vector<std::uint16_t> ids;  ///< of the recorder's channels, in their order
};

}  // namespace

Duration wall_minus_host() {
  const auto wall = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<Duration>(wall) - bus::host_now().time_since_epoch();
}

struct Recorder::Impl {
  explicit Impl(RecorderSettings wanted)
      : settings(std::move(wanted)),
        date(date_now()),
        log_minus_host(settings.log_minus_host.value_or(wall_minus_host())) {
    std::error_code error;
    std::filesystem::create_directories(settings.folder, error);
    if (error) {
      throw RecordingError(settings.folder.string() + ": cannot be made: " + error.message());
    }
    open_next();
    if (!open) throw RecordingError(report.problem);
    thread = std::thread([this]() noexcept { run(); });
  }

  // ---- the caller's side

  void push(Entry entry) {
    const std::lock_guard lock(mutex);
    if (is_ending || queued_bytes + entry.payload.size() > settings.max_queued_bytes) {
      ++report.dropped;
      return;
    }
    queued_bytes += entry.payload.size();
    queue.push_back(std::move(entry));
    if (queued_bytes >= kChunkBytes) wake.notify_one();
  }

  // ---- the thread's side

  void run() noexcept {
    bool goes_on = true;
    while (goes_on) {
      std::deque<Entry> entries;
      goes_on = take_queue(entries);
      write_all(entries);
      tell();
    }
    if (!open) return;
    open->writer.finish();
    open->file.sync();
    if (!open->file.problem().empty()) give_up();
    tell();
  }

  /// Waits for a chunk's worth or the time to flush; false when this is the last.
  bool take_queue(std::deque<Entry>& entries) {
    std::unique_lock lock(mutex);
    wake.wait_for(
        lock, settings.flush_every, [this]() { return is_ending || queued_bytes >= kChunkBytes; });
    entries = std::exchange(queue, {});
    queued_bytes = 0;
    if (all_channels.size() != channels.size()) all_channels = channels;
    return !is_ending;
  }

  void write_all(const std::deque<Entry>& entries) {
    const SteadyTime now = std::chrono::steady_clock::now();
    if (!open && now - refused_at >= settings.retry_every) open_next();
    for (const Entry& entry : entries) {
      if (open && open->writer.bytes() >= settings.max_file_bytes) rotate();
      if (!open) {
        ++lost;
        continue;
      }
      write_one(entry);
    }
    if (!open) return;
    open->writer.flush();
    open->file.sync();
    if (!open->file.problem().empty()) {
      give_up();
    } else {
      unsure = 0;
    }
  }

  void write_one(const Entry& entry) {
    while (open->ids.size() <= entry.channel) {
      open->ids.push_back(open->writer.add_channel(all_channels.at(open->ids.size())));
    }
    open->writer.write(open->ids[entry.channel], entry.stamp, entry.payload);
    ++written;
    ++unsure;
    if (!open->writer.is_good()) give_up();
  }

  void rotate() {
    open->writer.finish();
    closed_bytes += open->writer.bytes();
    open.reset();
    open_next();
  }

  /// The file ends where the disk refused; every whole chunk in it can be read.
  void give_up() {
    problem = open->file.problem();
    closed_bytes += open->writer.bytes();
    written -= unsure;
    lost += std::exchange(unsure, 0);
    refused_at = std::chrono::steady_clock::now();
    open.reset();
  }

  void open_next() {
    std::array<char, 16> number{};
    do {
      std::snprintf(number.data(), number.size(), "-%03u.mcap", ++files);
      open = std::make_unique<OpenFile>(
          settings.folder / (settings.name + "-" + date + number.data()), settings.library);
    } while (open->file.exists_already());
    open->writer.add_metadata("teamsight.recording", facts());
    open->writer.flush();
    if (open->file.problem().empty()) {
      problem.clear();
      tell();
      return;
    }
    give_up();
    tell();
  }

  [[nodiscard]] std::map<std::string, std::string> facts() const {
    auto all = settings.facts;
    all["log_minus_host_ns"] = std::to_string(log_minus_host.count());
    return all;
  }

  void tell() {
    std::error_code error;
    const auto space = std::filesystem::space(settings.folder, error);
    const std::lock_guard lock(mutex);
    report.file = open ? open->path.string() : std::string();
    report.bytes = closed_bytes + (open ? open->writer.bytes() : 0);
    report.messages = written;
    report.dropped += std::exchange(lost, 0);
    report.free_bytes = error ? 0 : space.available;
    report.problem = problem;
  }

  RecorderSettings settings;
  std::string date;
  Duration log_minus_host;

  mutable std::mutex mutex;  // guards what follows, up to the thread's own
  std::condition_variable wake;
  std::deque<Entry> queue;
  std::size_t queued_bytes{0};
  std::vector<Channel> channels;
  RecorderReport report;
  bool is_ending{false};

  std::unique_ptr<OpenFile> open;  // the thread's own from here
  std::vector<Channel> all_channels;
  std::string problem;
  SteadyTime refused_at;
  unsigned files{0};
  std::uint64_t closed_bytes{0};
  std::uint64_t written{0};
  std::uint64_t unsure{0};  ///< of `written`: not known to be on the disk
  std::uint64_t lost{0};
  std::thread thread;
};

Recorder::Recorder(RecorderSettings settings)
    : impl_(std::make_unique<Impl>(std::move(settings))) {}

Recorder::~Recorder() {
  finish();
}

void Recorder::finish() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->is_ending = true;
  }
  impl_->wake.notify_one();
  if (impl_->thread.joinable()) impl_->thread.join();
}

ChannelId Recorder::add_channel(Channel channel) {
  const std::lock_guard lock(impl_->mutex);
  impl_->channels.push_back(std::move(channel));
  return impl_->channels.size() - 1;
}

void Recorder::write(ChannelId channel, HostTime received, PeerTime stamp, std::string payload) {
  Entry entry;
  entry.channel = channel;
  entry.stamp.log_ns = (received.time_since_epoch() + impl_->log_minus_host).count();
  entry.stamp.publish_ns = stamp.time_since_epoch().count();
  entry.payload = std::move(payload);
  impl_->push(std::move(entry));
}

Duration Recorder::log_minus_host() const {
  return impl_->log_minus_host;
}

RecorderReport Recorder::report() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->report;
}

}  // namespace teamsight::recording
