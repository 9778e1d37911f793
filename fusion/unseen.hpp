// fusion/unseen.hpp: where obstacles may stand that nobody has seen yet.
#pragma once

#include <array>

#include <Eigen/Core>

#include "fusion/parameters.hpp"
#include "fusion/track_book.hpp"
#include "geometry/field_model.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// What the map lies over: the carpet, in F.
struct Carpet {
  Eigen::Vector2d centre_F{Eigen::Vector2d::Zero()};  ///< m
  Eigen::Vector2d size{Eigen::Vector2d::Ones()};      ///< length and width; m, above 0

  /// The field with its surround and `margin` (m) beyond that.
  [[nodiscard]] static Carpet of(const FieldModel& field, double margin);
};

/// How many obstacles are to be expected where no track is, as a share of those that would be if
/// nobody had ever looked: the intensity of undetected objects of a Poisson multi-Bernoulli filter
/// [Williams15], on a grid.
///
/// A thing that is seen for the first time in the middle of what several robots watch is hardly
/// real: nothing comes there unseen. At the edge of their sight, or behind somebody, it may be.
class UnseenMap {
 public:
  static constexpr int kColumns = 26;  ///< along x
  static constexpr int kRows = 18;

  UnseenMap();

  /// Goes on to `exposure`: obstacles wander from cell to cell, and come from outside.
  void wander_to(HostTime exposure, const Carpet& carpet, const NewcomerParameters& parameters);

  /// Takes into account that a frame shows all that it does, and nothing else.
  void watch(const Scene& scene, const Carpet& carpet, const TrackParameters& parameters);

  /// @return in (0, 1]; 1 beyond the carpet
  [[nodiscard]] double share_at(const Eigen::Vector2d& p_F, const Carpet& carpet) const;

 private:
  void wander(float share);

  HostTime time_{kNever};
  std::array<float, static_cast<std::size_t>(kColumns) * kRows> shares_{};
};

/// Log-odds that speak against a track that begins there, beyond what one robot's word can
/// outweigh.
///
/// @param share     see UnseenMap::share_at
/// @param detected  probability that the observer reports a thing that stands there
/// @return 0 or more
[[nodiscard]] double doubt_of_newcomer(double share, double detected, const Parameters& parameters);

}  // namespace teamsight::fusion
