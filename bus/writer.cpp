// bus/writer.cpp: convert, check, write.
#include "bus/writer.hpp"

#include "bus/entity.hpp"
#include "bus/participant_impl.hpp"
#include "bus/qos.hpp"
#include "bus/topics.hpp"
#include "bus/wire.hpp"

namespace teamsight::bus {

template <class Message>
struct Writer<Message>::Impl final : Endpoint {
  Impl(const Participant& participant, std::int32_t ownership_strength)
      : membership(participant.shared(), *this),
        strength(ownership_strength) {
    enter();
  }

  void leave() noexcept override {
    writer = Entity();
    topic = Entity();
  }

  void enter() override {
    const Participant::Impl& in = membership.participant();
    topic = Entity(check(dds_create_topic(in.entity.handle(),
                                          &topic_descriptor<Message>(),
                                          std::string(topic_profile<Message>().topic).c_str(),
                                          nullptr,
                                          nullptr),
                         "dds_create_topic"));
    const QosPointer qos = writer_qos(topic_profile<Message>(), strength, {in.lease, in.partition});
    writer = Entity(check(dds_create_writer(in.entity.handle(), topic.handle(), qos.get(), nullptr),
                          "dds_create_writer"));
  }

  Membership membership;
  std::int32_t strength;
  Entity topic;
  Entity writer;
  WireSample<Message> wire;
  WriteCounters counters;
};

template <class Message>
Writer<Message>::Writer(const Participant& participant, std::int32_t ownership_strength)
    : impl_(std::make_unique<Impl>(participant, ownership_strength)) {}

template <class Message>
Writer<Message>::Writer(Writer&&) noexcept = default;
template <class Message>
Writer<Message>& Writer<Message>::operator=(Writer&&) noexcept = default;
template <class Message>
Writer<Message>::~Writer() = default;

template <class Message>
WriteStatus Writer<Message>::write(const Message& message) noexcept {
  WriteCounters& counters = impl_->counters;
  if (to_wire(message, impl_->wire)) {
    ++counters.invalid;
    return WriteStatus::kInvalid;
  }
  const dds_return_t code = dds_write(impl_->writer.handle(), &impl_->wire.sample);
  if (code == DDS_RETCODE_OK) {
    ++counters.written;
    return WriteStatus::kWritten;
  }
  ++counters.failed;
  return code == DDS_RETCODE_TIMEOUT ? WriteStatus::kTimedOut : WriteStatus::kFailed;
}

template <class Message>
std::uint32_t Writer<Message>::live_readers() const noexcept {
  dds_publication_matched_status_t status{};
  if (dds_get_publication_matched_status(impl_->writer.handle(), &status) < 0) return 0;
  return status.current_count;
}

template <class Message>
const WriteCounters& Writer<Message>::counters() const noexcept {
  return impl_->counters;
}

template class Writer<RobotState>;
template class Writer<Sightings>;
template class Writer<VirtualSensors>;
template class Writer<Odometry>;
template class Writer<WorldModel>;
template class Writer<Explanation>;
template class Writer<ClockProbe>;
template class Writer<ClockEcho>;
template class Writer<GameState>;
template class Writer<Command>;
template class Writer<Diagnostics>;
template class Writer<LinePoints>;
template class Writer<Thumbnail>;
template class Writer<Truth>;

}  // namespace teamsight::bus
