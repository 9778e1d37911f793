// bus/reader.cpp: loan, check, convert, hand over.
#include "bus/reader.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

#include "bus/heard_writers.hpp"
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

// Nothing: it has left meanwhile.
std::optional<WriterName> name_of(dds_entity_t reader, dds_instance_handle_t writer) {
  const EndpointPointer endpoint(dds_get_matched_publication_data(reader, writer));
  if (!endpoint) return std::nullopt;
  WriterName name{};
  std::copy_n(std::begin(endpoint->key.v), name.size(), name.begin());
  return name;
}

// The writers that the library has matched with a reader, at most as many as are remembered.
class Matched {
 public:
  explicit Matched(dds_entity_t reader) : reader_(reader) {
    const auto count = dds_get_matched_publications(reader, writers_.data(), writers_.size());
    size_ = std::min(writers_.size(), static_cast<std::size_t>(std::max(count, 0)));
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// Those of whom the claim is true come first; how many they are.
  std::size_t bring_forward(const std::function<bool(dds_instance_handle_t)>& claim) {
    const auto end = writers_.begin() + static_cast<std::ptrdiff_t>(size_);
    return static_cast<std::size_t>(std::partition(writers_.begin(), end, claim) -
                                    writers_.begin());
  }

  [[nodiscard]] std::vector<WriterName> names(std::size_t from, std::size_t to) const {
    std::vector<WriterName> names;
    for (std::size_t i = from; i < to; ++i) {
      if (const auto name = name_of(reader_, writers_.at(i))) names.push_back(*name);
    }
    return names;
  }

 private:
  dds_entity_t reader_;
  std::array<dds_instance_handle_t, HeardWriters::kMost> writers_{};
  std::size_t size_{0};
};

// In which order to hand a batch over. The library hands it out key by key; what one writer says to
// all and to one must not change places, so that events go by when their writer wrote them.
std::array<std::size_t, Loan::kBatch> order_of(const Loan& loan, Delivery delivery) {
  std::array<std::size_t, Loan::kBatch> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (delivery != Delivery::kEvent) return order;
  const std::span filled(order.data(), loan.size());
  std::ranges::stable_sort(filled, {}, [&](std::size_t i) {
    return std::pair(loan.info(i).publication_handle, loan.info(i).source_timestamp);
  });
  return order;
}

// What one writer counts apart: commands, by their target. Not the library's handle, which is
// another one after joining anew; what was heard before must not be new then.
template <class Message>
std::uint64_t instance_in(const Message& message) noexcept {
  if constexpr (requires { message.target; }) {
    return message.target;
  } else {
    return 0;
  }
}

}  // namespace

template <class Message>
struct Reader<Message>::Impl {
  explicit Impl(const Participant& participant)
      : subscription(participant, topic_profile<Message>(), topic_descriptor<Message>()),
        speakers(participant.is_secured()) {}

  std::optional<Message> take(const void* data, const dds_sample_info_t& info, HostTime now) {
    auto message = from_wire<Message>(*static_cast<const typename WireForm<Message>::Type*>(data));
    const ObservationId maker = message ? message->id : ObservationId{};
    const auto judged = message ? judge(*message, info, now) : failure(message.error());
    const bool repeats = !judged && judged.error() == Reject::kDuplicate;
    if (heard_since != subscription.entered()) heard.forget_writers();
    heard_since = subscription.entered();
    heard.note(info.publication_handle, maker, repeats, now);
    if (!judged) {
      ++counters.rejected[static_cast<std::size_t>(judged.error())];
      return std::nullopt;
    }
    ++counters.accepted;
    counters.lost += *judged;
    return std::move(*message);
  }

  // How many were lost before it, or why it must be dropped. What a late joiner gets of an event is
  // old by design, and one writer counts over several keys: only state has stamps that are judged
  // and gaps that are losses.
  Result<std::uint32_t, Reject> judge(const Message& message,
                                      const dds_sample_info_t& info,
                                      HostTime now) {
    if (!speakers.may_speak(subscription.handle(), info.publication_handle, message.id.robot)) {
      return failure(Reject::kForeignIdentity);
    }
    const bool state = subscription.profile().delivery == Delivery::kState;
    const auto lost = history.judge(
        instance_in(message), message.id, state ? stamp_in(message) : std::nullopt, now);
    if (!lost || state) return lost;
    return 0U;
  }

  [[nodiscard]] std::vector<WriterName> unheard(HostTime now, Duration patience) const {
    Matched matched(subscription.handle());
    const auto heard_of =
        matched.bring_forward([&](auto writer) { return heard.has(writer, now, patience); });
    // The library tells only how many are alive; those that are not may be among the unheard.
    const std::size_t alive = subscription.live_writers();
    const bool all_are_heard =
        subscription.profile().exclusive ? heard_of > 0 || alive == 0 : heard_of >= alive;
    if (all_are_heard) return {};
    return matched.names(heard_of, matched.size());
  }

  [[nodiscard]] std::vector<WriterName> heard_of_late(HostTime now, Duration patience) const {
    Matched matched(subscription.handle());
    const auto heard_of =
        matched.bring_forward([&](auto writer) { return heard.has(writer, now, patience); });
    return matched.names(0, heard_of);
  }

  Subscription subscription;
  Speakers speakers;
  History history;
  HeardWriters heard;
  std::uint32_t heard_since{0};
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
    const auto order = order_of(loan, impl_->subscription.profile().delivery);
    for (std::size_t turn = 0; turn < loan.size(); ++turn) {
      const std::size_t i = order.at(turn);
      const dds_sample_info_t& info = loan.info(i);
      Sample<Message> sample;
      // Leaving right after a write shows on the valid sample, without one of its own.
      sample.presence = presence_of(info);
      sample.instance = info.instance_handle;
      sample.writer = info.publication_handle;
      sample.received = now;
      if (info.valid_data) sample.message = impl_->take(loan.data(i), info, now);
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
std::vector<WriterName> Reader<Message>::unheard_writers(HostTime now, Duration patience) const {
  return impl_->unheard(now, patience);
}

template <class Message>
std::vector<WriterName> Reader<Message>::heard_writers(HostTime now, Duration patience) const {
  return impl_->heard_of_late(now, patience);
}

template <class Message>
Computer Reader<Message>::computer_of(std::uint64_t writer) const {
  return impl_->subscription.computer_of(writer);
}

template <class Message>
HostTime Reader<Message>::writer_renamed() const noexcept {
  return impl_->heard.renamed();
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
