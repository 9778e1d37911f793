// sim/render/ball_look.cpp: see ball_look.hpp.
#include "sim/render/ball_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace teamsight::sim {
namespace {

constexpr float kGolden = 1.618034F;
// Of a truncated icosahedron with edges of one: from its middle to the faces.
constexpr float kToPentagon = 2.32744F;
constexpr float kToHexagon = 2.26728F;

// How far along the outermost of some normals, of which each stands for its opposite as well.
template <std::size_t kSize>
float outermost(const std::array<Eigen::Vector3f, kSize>& normals, const Eigen::Vector3f& place) {
  float most = 0.0F;
  for (const Eigen::Vector3f& normal : normals) most = std::max(most, std::abs(normal.dot(place)));
  return most;
}

// Of the corners of an icosahedron, where the pentagons are, and of a dodecahedron: the hexagons.
const std::array<Eigen::Vector3f, 6>& pentagon_normals() {
  static const std::array<Eigen::Vector3f, 6> normals = [] {
    std::array<Eigen::Vector3f, 6> all{Eigen::Vector3f(0.0F, 1.0F, kGolden),
                                       Eigen::Vector3f(0.0F, 1.0F, -kGolden),
                                       Eigen::Vector3f(1.0F, kGolden, 0.0F),
                                       Eigen::Vector3f(1.0F, -kGolden, 0.0F),
                                       Eigen::Vector3f(kGolden, 0.0F, 1.0F),
                                       Eigen::Vector3f(-kGolden, 0.0F, 1.0F)};
    for (Eigen::Vector3f& normal : all) normal.normalize();
    return all;
  }();
  return normals;
}

const std::array<Eigen::Vector3f, 10>& hexagon_normals() {
  static const std::array<Eigen::Vector3f, 10> normals = [] {
    constexpr float kSmall = 1.0F / kGolden;
    std::array<Eigen::Vector3f, 10> all{Eigen::Vector3f(1.0F, 1.0F, 1.0F),
                                        Eigen::Vector3f(1.0F, 1.0F, -1.0F),
                                        Eigen::Vector3f(1.0F, -1.0F, 1.0F),
                                        Eigen::Vector3f(-1.0F, 1.0F, 1.0F),
                                        Eigen::Vector3f(kSmall, 0.0F, kGolden),
                                        Eigen::Vector3f(kSmall, 0.0F, -kGolden),
                                        Eigen::Vector3f(0.0F, kGolden, kSmall),
                                        Eigen::Vector3f(0.0F, -kGolden, kSmall),
                                        Eigen::Vector3f(kGolden, kSmall, 0.0F),
                                        Eigen::Vector3f(-kGolden, kSmall, 0.0F)};
    for (Eigen::Vector3f& normal : all) normal.normalize();
    return all;
  }();
  return normals;
}

}  // namespace

float depth_in_panels(BallPattern pattern, const Eigen::Vector3f& place) {
  switch (pattern) {
    case BallPattern::kPlain:
      break;
    case BallPattern::kFootball: {
      // The face that a ray from the middle meets first; the sum falls so fast across an edge.
      constexpr float kSlope = 0.2795F;
      return (outermost(pentagon_normals(), place) / kToPentagon -
              outermost(hexagon_normals(), place) / kToHexagon) /
             kSlope;
    }
    case BallPattern::kOctants: {
      const float edge = place.cwiseAbs().minCoeff();
      return place.prod() > 0.0F ? edge : -edge;
    }
  }
  return -1.0F;
}

}  // namespace teamsight::sim
