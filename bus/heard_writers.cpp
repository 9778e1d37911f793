// bus/heard_writers.cpp: see heard_writers.hpp.
#include "bus/heard_writers.hpp"

#include <algorithm>

namespace teamsight::bus {

HeardWriters::HeardWriters() {
  entries_.reserve(kMost);
}

void HeardWriters::note(std::uint64_t writer,
                        const ObservationId& maker,
                        bool repeated,
                        HostTime now) {
  auto found = std::find_if(
      entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.writer == writer; });
  if (found == entries_.end()) {
    const bool is_known = std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.boot != 0 && entry.robot == maker.robot && entry.boot == maker.boot;
    });
    if (is_known && !repeated) renamed_ = now;
    found = make_room();
  }
  found->writer = writer;
  found->robot = maker.robot;
  found->boot = maker.boot;
  found->any = now;
  if (!repeated) found->news = now;
}

std::vector<HeardWriters::Entry>::iterator HeardWriters::make_room() {
  if (entries_.size() < kMost) return entries_.insert(entries_.end(), Entry{});
  const auto oldest =
      std::min_element(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return a.any < b.any;
      });
  *oldest = Entry{};
  return oldest;
}

bool HeardWriters::has(std::uint64_t writer, HostTime now, Duration patience) const {
  const auto is_recent = [&](HostTime then) {
    return then != HostTime{} && now - then <= patience;
  };
  const auto found = std::find_if(
      entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.writer == writer; });
  if (found == entries_.end()) return false;
  if (is_recent(found->news)) return true;
  if (!is_recent(found->any)) return false;
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.writer != writer && entry.robot == found->robot && is_recent(entry.news);
  });
}

}  // namespace teamsight::bus
