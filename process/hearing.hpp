// process/hearing.hpp: joins the bus anew when somebody lives that this process does not hear.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "bus/loop.hpp"
#include "bus/messages.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "geometry/identity.hpp"
#include "process/rejoin_rule.hpp"

namespace teamsight::process {

/// Without DDS Security one forged sequence number shuts a live writer out for good; this is the
/// way back. With security on there is nothing to mend, and it does nothing. Use from one thread.
class Hearing {
 public:
  /// @param team  must outlive it, and be the only participant of the process in its domain
  explicit Hearing(bus::Participant& team, const RejoinParameters& parameters = {});

  /// Watches a topic whose writers speak all the time, or lose their lease.
  ///
  /// @param reader  must outlive it
  template <class Message>
  void watch(const bus::Reader<Message>& reader) {
    ears_.push_back(ear_of(reader, {}, Sign::kLeased));
  }

  /// Watches a topic that is told of about once a second and has no lease: a writer may live and
  /// be unheard there only while its process is heard on another topic.
  ///
  /// @param reader     must outlive it, as must the others
  /// @param witnesses  of topics on which the same processes speak
  template <class Message, class... Witness>
  void watch_beside(const bus::Reader<Message>& reader, const bus::Reader<Witness>&... witnesses) {
    ears_.push_back(ear_of(reader, {names_of(witnesses)...}, std::nullopt));
  }

  /// The same for a topic on which whoever may write it does so every few seconds: a writer that is
  /// there and heard nowhere is doubtful.
  template <class Message, class... Witness>
  void watch_always(const bus::Reader<Message>& reader, const bus::Reader<Witness>&... witnesses) {
    ears_.push_back(ear_of(reader, {names_of(witnesses)...}, Sign::kDoubtful));
  }

  /// A robot that is heard has not done what this process asked of it: perhaps it does not hear.
  void note_unanswered(RobotId robot) { unanswered_.push_back(robot); }

  /// Looks from now on.
  void attach(bus::Loop& loop);

  /// Looks now; to be called a few times a second where there is no loop.
  void look(HostTime now);

  /// How often this process has joined anew.
  [[nodiscard]] std::uint64_t times() const { return times_; }

  /// Puts into a report what has happened lately, for the coach.
  void tell(bus::Diagnostics& report, HostTime now) const;

  static constexpr Duration kPatience = std::chrono::seconds(1);
  static constexpr Duration kWitnessPatience = std::chrono::seconds(10);

 private:
  using Names = std::function<std::vector<bus::WriterName>(HostTime)>;

  struct Ear {
    Names unheard;
    std::vector<Names> witnesses;
    std::optional<Sign> unwitnessed;  // what being unheard says by itself
    std::function<HostTime()> renamed;
  };

  template <class Message>
  static Names names_of(const bus::Reader<Message>& witness) {
    return [&witness](HostTime now) {
      return witness.heard_writers(now, kWitnessPatience);
    };
  }

  template <class Message>
  static Ear ear_of(const bus::Reader<Message>& reader,
                    std::vector<Names> witnesses,
                    std::optional<Sign> unwitnessed) {
    return {[&reader](HostTime now) { return reader.unheard_writers(now, kPatience); },
            std::move(witnesses),
            unwitnessed,
            [&reader] {
              return reader.writer_renamed();
            }};
  }

  static void listen(const Ear& ear, HostTime now, std::vector<Unheard>& unheard);

  bus::Participant* team_;
  RejoinRule rule_;
  std::vector<Ear> ears_;
  std::vector<RobotId> unanswered_;
  std::uint64_t times_{0};
  HostTime last_{};
  bool is_out_{false};  // it could not join; it tries again
};

}  // namespace teamsight::process
