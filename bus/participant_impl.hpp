// bus/participant_impl.hpp: what a Participant owns. For bus/ only.
#pragma once

#include <memory>
#include <vector>

#include "bus/entity.hpp"
#include "bus/participant.hpp"

namespace teamsight::bus {

struct Domain;

/// A reader or a writer: it leaves and enters with its participant.
class Endpoint {
 public:
  Endpoint() = default;
  Endpoint(const Endpoint&) = delete;
  Endpoint& operator=(const Endpoint&) = delete;
  virtual ~Endpoint() = default;

  /// Deletes its entities; until it enters again it writes and hears nothing.
  virtual void leave() noexcept = 0;

  /// Makes its entities.
  /// @throws BusError if the library refuses
  virtual void enter() = 0;
};

struct Participant::Impl {
  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl();

  void leave() noexcept;

  DomainSettings settings;
  std::string configuration;  ///< the profile, complete
  std::shared_ptr<Domain> domain;
  Entity entity;
  Duration lease{0};
  std::string partition;  ///< in which this speaker writes; empty: security is off
  std::vector<Endpoint*> endpoints;
};

/// Keeps an endpoint in its participant's list while both live.
class Membership {
 public:
  Membership(std::shared_ptr<Participant::Impl> participant, Endpoint& endpoint);
  ~Membership();
  Membership(const Membership&) = delete;
  Membership& operator=(const Membership&) = delete;

  [[nodiscard]] const Participant::Impl& participant() const noexcept { return *participant_; }

 private:
  std::shared_ptr<Participant::Impl> participant_;
  Endpoint* endpoint_;
};

}  // namespace teamsight::bus
