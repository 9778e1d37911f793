// vision/mirror/profile.cpp: interpolation on the meridian.
#include "vision/mirror/profile.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/expect.hpp"

namespace teamsight::mirror {
namespace {

Node hermite(const Node& a, const Node& b, double x) {
  const double h = b.x - a.x;
  const double u = (x - a.x) / h;
  const double chord = (b.y - a.y) / h;
  // Newton form: the cubic is the tangent at `a` plus two corrections, exact where they vanish.
  const double second = chord - a.slope;
  const double third = a.slope + b.slope - 2.0 * chord;
  const double y = a.y + h * u * (a.slope + u * (second + (u - 1.0) * third));
  const double slope = a.slope + u * (2.0 * second + (3.0 * u - 2.0) * third);
  return {x, y, slope};
}

double tangent_of(const Node& node) {
  return node.x / node.y;
}

/// The x in [a.x, b.x] where x/y reaches `tan_alpha`, which the ends enclose.
Node bisect(const Node& a, const Node& b, double tan_alpha) {
  double low = a.x;
  double high = b.x;
  Node node = hermite(a, b, 0.5 * (low + high));
  for (int i = 0; i < 60 && low < high; ++i) {
    (tangent_of(node) < tan_alpha ? low : high) = node.x;
    node = hermite(a, b, 0.5 * (low + high));
  }
  return node;
}

}  // namespace

Node at(const Part& part, double x) {
  const auto& nodes = part.nodes;
  TEAMSIGHT_EXPECT(nodes.size() >= 2);
  const auto above = std::upper_bound(
      nodes.begin() + 1, nodes.end() - 1, x, [](double v, const Node& n) { return v < n.x; });
  return hermite(*(above - 1), *above, x);
}

std::optional<Hit> find_hit(const Profile& profile, double tan_alpha) {
  for (std::size_t i = 0; i < profile.parts.size(); ++i) {
    const auto& nodes = profile.parts[i].nodes;
    const auto not_less =
        std::lower_bound(nodes.begin(), nodes.end(), tan_alpha, [](const Node& n, double v) {
          return tangent_of(n) < v;
        });
    if (not_less == nodes.end()) {
      continue;
    }
    if (not_less == nodes.begin()) {
      return Hit{i, nodes.front()};
    }
    return Hit{i, bisect(*(not_less - 1), *not_less, tan_alpha)};
  }
  return std::nullopt;
}

const Node& rim(const Profile& profile) {
  TEAMSIGHT_EXPECT(!profile.parts.empty() && !profile.parts.back().nodes.empty());
  return profile.parts.back().nodes.back();
}

}  // namespace teamsight::mirror
