// bus/participant_impl.hpp: what a Participant owns. For bus/ only.
#pragma once

#include <memory>

#include "bus/entity.hpp"
#include "bus/participant.hpp"

namespace teamsight::bus {

struct Domain;

struct Participant::Impl {
  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl();

  std::shared_ptr<Domain> domain;
  Entity entity;
  std::uint32_t domain_id{0};
  Duration lease{0};
  std::string partition;  ///< in which this speaker writes; empty: security is off
};

}  // namespace teamsight::bus
