// vision/carpet_star.hpp: where the carpet begins around something, and the disc that it leaves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

namespace teamsight::vision {

inline constexpr std::size_t kStarDirections = 24;

/// How one direction from a place ends.
enum class StarEnd : std::uint8_t {
  kCarpet,  ///< there the carpet begins
  kOpen,    ///< as far as was looked there is none
  kHidden,  ///< own body, mask or the picture's border come first
};

/// All directions from one place, evenly in angles, in order.
struct CarpetStar {
  std::array<StarEnd, kStarDirections> ends{};
  /// From the place; rad, as in a LocalView. Of those that end in carpet.
  std::array<Eigen::Vector2d, kStarDirections> places{};
};

/// Of the i-th direction; unit length.
[[nodiscard]] const Eigen::Vector2d& star_direction(std::size_t i);

/// A disc whose edge is where the carpet begins.
struct StarDisc {
  Eigen::Vector2d middle{Eigen::Vector2d::Zero()};  ///< from the star's place; rad
  double radius{0.0};                               ///< rad
  double scatter{0.0};  ///< of the ends about its edge, RMS over its radius, without those far off
  std::size_t ends{0};  ///< at its edge
};

/// The disc through most of a star's ends. What touches it on some sides (a line, a robot) leaves
/// ends that are far off, or none, and does not move it.
///
/// @param expected  its radius, about; rad
/// @return nothing if too few ends lie at the edge of one disc
[[nodiscard]] std::optional<StarDisc> disc_in(const CarpetStar& star, double expected);

}  // namespace teamsight::vision
