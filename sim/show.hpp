// sim/show.hpp: a moment of the match as one of its robots could see it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/field_model.hpp"
#include "sim/match/match.hpp"
#include "sim/render/renderer.hpp"
#include "sim/render/scene.hpp"

namespace teamsight::sim {

/// How large everybody is, and who stands around the field.
struct Bodies {
  double ball_radius{0.11};   ///< m
  double robot_radius{0.25};  ///< m
  double robot_height{0.8};   ///< m
  std::vector<ScenePerson> people;
  BallLook ball{};  ///< of every ball; its turn is the match's
};

/// A low base, a tower and a camera: what hides no floor beyond 0.32 m from a mirror at 0.75 m.
[[nodiscard]] std::vector<BodyPart> low_body();

/// Spectators behind the boards along the side lines; the same for the same seed.
[[nodiscard]] std::vector<ScenePerson> people_around(const FieldModel& field, std::uint32_t seed);

/// Fills `scene` with what is around one player.
///
/// @param player  index in the match's players
void show(const MatchState& state, std::size_t player, const Bodies& bodies, Scene& scene);

}  // namespace teamsight::sim
