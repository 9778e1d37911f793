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

Loan::Loan(dds_entity_t reader) noexcept : reader_(reader) {
  const dds_return_t count = dds_take(reader, samples_.data(), infos_.data(), kBatch, kBatch);
  count_ = count > 0 ? static_cast<std::size_t>(count) : 0;
}

Loan::~Loan() {
  if (count_ > 0) dds_return_loan(reader_, samples_.data(), static_cast<std::int32_t>(count_));
}

}  // namespace teamsight::bus
