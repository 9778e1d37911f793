// process/hearing.hpp: joins the bus anew when somebody lives that this process does not hear.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "bus/loop.hpp"
#include "bus/messages.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "process/rejoin_rule.hpp"

namespace teamsight::process {

/// Without DDS Security one forged sequence number shuts a live writer out for good; this is the
/// way back. With security on there is nothing to mend, and it does nothing. Use from one thread.
class Hearing {
 public:
  /// @param team  must outlive it, and be the only participant of the process in its domain
  explicit Hearing(bus::Participant& team);

  /// Watches a topic whose writers speak all the time, or lose their lease.
  ///
  /// @param reader    must outlive it
  /// @param patience  a writer that lives says something new within it
  template <class Message>
  void watch(const bus::Reader<Message>& reader, Duration patience = kPatience) {
    ears_.push_back(
        {[&reader, patience](HostTime now) { return reader.unheard_writers(now, patience); },
         [&reader] {
           return reader.writer_renamed();
         }});
  }

  /// Looks from now on.
  void attach(bus::Loop& loop);

  /// Looks now; to be called a few times a second where there is no loop.
  void look(HostTime now);

  /// How often this process has joined anew.
  [[nodiscard]] std::uint64_t times() const { return times_; }

  /// Puts into a report what has happened lately, for the coach.
  void tell(bus::Diagnostics& report, HostTime now) const;

  static constexpr Duration kPatience = std::chrono::seconds(1);

 private:
  struct Ear {
    std::function<std::vector<bus::WriterName>(HostTime)> unheard;
    std::function<HostTime()> renamed;
  };

  bus::Participant* team_;
  RejoinRule rule_;
  std::vector<Ear> ears_;
  std::uint64_t times_{0};
  HostTime last_{};
  bool is_out_{false};  // it could not join; it tries again
};

}  // namespace teamsight::process
