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
  Duration lease{0};
};

}  // namespace teamsight::bus
