// bus/reader.cpp: loan, check, convert, hand over.
#include "bus/reader.hpp"

#include <utility>

#include "bus/history.hpp"
#include "bus/speakers.hpp"
#include "bus/subscription.hpp"
#include "bus/topics.hpp"
#include "bus/wire.hpp"

namespace teamsight::bus {
namespace {

Presence presence_of(const dds_sample_info_t& info) noexcept {
  switch (info.instance_state) {
    case DDS_IST_NOT_ALIVE_DISPOSED:
      return Presence::kGone;
    case DDS_IST_NOT_ALIVE_NO_WRITERS:
      return Presence::kSilent;
    default:
      return Presence::kAlive;
  }
}

// The stamp that moves with the sender's clock from sample to sample; commands carry none.
template <class Message>
std::optional<PeerTime> stamp_in(const Message& message) noexcept {
  if constexpr (requires { message.exposure; }) {
    return message.exposure;
  } else if constexpr (requires { message.stamp; }) {
    return message.stamp;
  } else if constexpr (requires { message.sent; }) {
    return message.sent;
  } else {
    return std::nullopt;
  }
}

}  // namespace

template <class Message>
struct Reader<Message>::Impl {
  explicit Impl(const Participant& participant)
      : subscription(participant, topic_profile<Message>(), topic_descriptor<Message>()),
        speakers(participant.is_secured()) {}

  // What a late joiner gets of an event is old by design, and one writer counts over several keys:
  // only state has stamps that are judged and gaps that are losses.
  std::optional<Message> accept(const void* data, const dds_sample_info_t& info, HostTime now) {
    const bool state = subscription.profile().delivery == Delivery::kState;
    auto message = from_wire<Message>(*static_cast<const typename WireForm<Message>::Type*>(data));
    if (!message) return refuse(message.error());
    if (!speakers.may_speak(subscription.handle(), info.publication_handle, message->id.robot)) {
      return refuse(Reject::kForeignIdentity);
    }
    const auto lost = history.judge(
        info.instance_handle, message->id, state ? stamp_in(*message) : std::nullopt, now);
    if (!lost) return refuse(lost.error());
    ++counters.accepted;
    if (state) counters.lost += *lost;
    return std::move(*message);
  }

  std::nullopt_t refuse(Reject reason) noexcept {
    ++counters.rejected[static_cast<std::size_t>(reason)];
    return std::nullopt;
  }

  Subscription subscription;
  Speakers speakers;
  History history;
  ReadCounters counters;
};

template <class Message>
Reader<Message>::Reader(const Participant& participant)
    : impl_(std::make_unique<Impl>(participant)) {}

template <class Message>
Reader<Message>::Reader(Reader&&) noexcept = default;
template <class Message>
Reader<Message>& Reader<Message>::operator=(Reader&&) noexcept = default;
template <class Message>
Reader<Message>::~Reader() = default;

template <class Message>
std::size_t Reader<Message>::take(HostTime now,
                                  const std::function<void(const Sample<Message>&)>& use) {
  impl_->subscription.clear_event();  // before the take: what comes meanwhile signals again
  std::size_t handed_over = 0;
  for (bool more = true; more;) {
    const Loan loan(impl_->subscription.handle());
    more = loan.size() == Loan::kBatch;
    for (std::size_t i = 0; i < loan.size(); ++i) {
      const dds_sample_info_t& info = loan.info(i);
      Sample<Message> sample;
      // Leaving right after a write shows on the valid sample, without one of its own.
      sample.presence = presence_of(info);
      sample.instance = info.instance_handle;
      sample.writer = info.publication_handle;
      sample.received = now;
      if (info.valid_data) sample.message = impl_->accept(loan.data(i), info, now);
      if (!sample.message && sample.presence == Presence::kAlive) continue;
      use(sample);
      ++handed_over;
    }
  }
  return handed_over;
}

template <class Message>
int Reader<Message>::event_fd() const noexcept {
  return impl_->subscription.event_fd();
}

template <class Message>
std::uint32_t Reader<Message>::live_writers() const noexcept {
  return impl_->subscription.live_writers();
}

template <class Message>
const ReadCounters& Reader<Message>::counters() const noexcept {
  return impl_->counters;
}

template class Reader<RobotState>;
template class Reader<Sightings>;
template class Reader<VirtualSensors>;
template class Reader<Odometry>;
template class Reader<WorldModel>;
template class Reader<Explanation>;
template class Reader<ClockProbe>;
template class Reader<ClockEcho>;
template class Reader<GameState>;
template class Reader<Command>;
template class Reader<Diagnostics>;
template class Reader<LinePoints>;
template class Reader<Thumbnail>;
template class Reader<Truth>;

}  // namespace teamsight::bus
