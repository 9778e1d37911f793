// bus/subscription.hpp: the part of a reader that is the same for every topic. For bus/ only.
#pragma once

#include <array>
#include <memory>

#include "bus/computer.hpp"
#include "bus/entity.hpp"
#include "bus/participant_impl.hpp"
#include "bus/topics.hpp"

namespace teamsight::bus {

/// One topic and one DDS reader whose listener does nothing but signal an eventfd.
class Subscription final : public Endpoint {
 public:
  /// @throws BusError if the library refuses
  Subscription(const Participant& participant,
               const TopicProfile& profile,
               const dds_topic_descriptor_t& descriptor);
  ~Subscription() override;
  Subscription(const Subscription&) = delete;
  Subscription& operator=(const Subscription&) = delete;

  void leave() noexcept override;
  void enter() override;

  /// Readable when something changed since the last `clear_event`.
  [[nodiscard]] int event_fd() const noexcept { return event_fd_; }

  void clear_event() const noexcept;

  [[nodiscard]] dds_entity_t handle() const noexcept { return reader_.handle(); }

  [[nodiscard]] std::uint32_t live_writers() const noexcept;

  /// How often it has entered: with each time the library's handles are new ones.
  [[nodiscard]] std::uint32_t entered() const noexcept { return entered_; }

  /// See Reader::computer_of.
  [[nodiscard]] Computer computer_of(dds_instance_handle_t writer) const;

  [[nodiscard]] const TopicProfile& profile() const noexcept { return profile_; }

 private:
  const TopicProfile& profile_;
  const dds_topic_descriptor_t& descriptor_;
  int event_fd_{-1};
  std::uint32_t entered_{0};
  Membership membership_;
  Entity topic_;
  Entity reader_;  // last: it goes first, and its listener with it
};

/// One batch of samples on loan from the library; given back when it goes, whatever happens.
class Loan {
 public:
  static constexpr std::size_t kBatch = 32;

  explicit Loan(dds_entity_t reader) noexcept;
  ~Loan();
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;

  [[nodiscard]] std::size_t size() const noexcept { return count_; }

  [[nodiscard]] const void* data(std::size_t i) const noexcept { return samples_[i]; }

  [[nodiscard]] const dds_sample_info_t& info(std::size_t i) const noexcept { return infos_[i]; }

 private:
  dds_entity_t reader_;
  std::size_t count_{0};
  std::array<void*, kBatch> samples_{};
  std::array<dds_sample_info_t, kBatch> infos_{};
};

}  // namespace teamsight::bus
