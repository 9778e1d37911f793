// bus/subscription.cpp: making a DDS reader, its eventfd and its loans.
#include "bus/subscription.hpp"

#include <cerrno>
#include <string>
#include <system_error>

#include <sys/eventfd.h>
#include <unistd.h>

#include "bus/participant.hpp"
#include "bus/qos.hpp"

namespace teamsight::bus {
namespace {

// On the library's receive thread: nothing here may block or make entities.
void signal_event(void* argument) noexcept {
  const std::uint64_t one = 1;
  const int descriptor = *static_cast<int*>(argument);
  [[maybe_unused]] const ssize_t written = ::write(descriptor, &one, sizeof one);
}

void on_data(dds_entity_t /*reader*/, void* argument) noexcept {
  signal_event(argument);
}

void on_liveliness(dds_entity_t /*reader*/,
                   const dds_liveliness_changed_status_t /*status*/,
                   void* argument) noexcept {
  signal_event(argument);
}

// "" if the participant does not announce it.
std::string property_of(const dds_qos_t* qos, const char* name) {
  char* value = nullptr;
  if (!dds_qget_prop(qos, name, &value) || value == nullptr) return {};
  std::string text(value);
  dds_free(value);
  return text;
}

int make_event_fd() {
  const int descriptor = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (descriptor < 0)
    throw BusError(std::string("eventfd: ") + std::generic_category().message(errno));
  return descriptor;
}

}  // namespace

Subscription::Subscription(const Participant& participant,
                           const TopicProfile& profile,
                           const dds_topic_descriptor_t& descriptor)
    : profile_(profile),
      descriptor_(descriptor),
      membership_(participant.shared(), *this) {
  event_fd_ = make_event_fd();
  try {
    enter();
  } catch (const BusError&) {
    ::close(event_fd_);
    throw;
  }
}

Subscription::~Subscription() {
  leave();
  ::close(event_fd_);
}

void Subscription::leave() noexcept {
  reader_ = Entity();  // waits for a listener that runs
  topic_ = Entity();
}

void Subscription::enter() {
  const Participant::Impl& in = membership_.participant();
  topic_ = Entity(check(
      dds_create_topic(
          in.entity.handle(), &descriptor_, std::string(profile_.topic).c_str(), nullptr, nullptr),
      "dds_create_topic"));
  // Given at creation: one set later misses what is pending (0.10.2).
  const ListenerPointer listener(dds_create_listener(&event_fd_));
  dds_lset_data_available(listener.get(), &on_data);
  dds_lset_liveliness_changed(listener.get(), &on_liveliness);
  const QosPointer qos = reader_qos(profile_, {in.lease, in.partition});
  reader_ = Entity(
      check(dds_create_reader(in.entity.handle(), topic_.handle(), qos.get(), listener.get()),
            "dds_create_reader"));
  ++entered_;
}

void Subscription::clear_event() const noexcept {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t got = ::read(event_fd_, &count, sizeof count);
}

std::uint32_t Subscription::live_writers() const noexcept {
  dds_liveliness_changed_status_t status{};
  if (dds_get_liveliness_changed_status(reader_.handle(), &status) < 0) return 0;
  return status.alive_count;
}

Computer Subscription::computer_of(dds_instance_handle_t writer) const {
  const EndpointPointer endpoint(dds_get_matched_publication_data(handle(), writer));
  if (!endpoint) return {};
  const Entity participants(dds_create_reader(membership_.participant().entity.handle(),
                                              DDS_BUILTIN_TOPIC_DCPSPARTICIPANT,
                                              nullptr,
                                              nullptr));
  void* sample = nullptr;
  dds_sample_info_t info{};
  const auto count = dds_read_instance(
      participants.handle(), &sample, &info, 1, 1, endpoint->participant_instance_handle);
  if (count <= 0) return {};
  const auto* const participant = static_cast<const dds_builtintopic_participant_t*>(sample);
  Computer computer{property_of(participant->qos, "__Hostname"),
                    unicast_address_in(property_of(participant->qos, "__NetworkAddresses")),
                    false};
  computer.is_this = is_own_address(computer.address);
  dds_return_loan(participants.handle(), &sample, count);
  return computer;
}

Loan::Loan(dds_entity_t reader) noexcept : reader_(reader) {
  const dds_return_t count = dds_take(reader, samples_.data(), infos_.data(), kBatch, kBatch);
  count_ = count > 0 ? static_cast<std::size_t>(count) : 0;
}

Loan::~Loan() {
  if (count_ > 0) dds_return_loan(reader_, samples_.data(), static_cast<std::int32_t>(count_));
}

}  // namespace teamsight::bus
