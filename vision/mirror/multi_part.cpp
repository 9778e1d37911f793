// vision/mirror/multi_part.cpp: the one-dimensional search that closes the multi-part mirror.
#include "vision/mirror/multi_part.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

namespace teamsight::mirror {
namespace {

constexpr std::size_t kIsometricIntervals = 600;
constexpr std::size_t kArcIntervals = 120;
constexpr std::size_t kRingIntervals = 40;

/// Everything but the apex.
struct Frame {
  IsometricParameters isometric;
  Node point_B;
  double ring_end{0.0};
};

Failure unsolvable(double amount, std::string text) {
  return {Condition::kSolution, amount, "no solution: " + std::move(text)};
}

Result<Frame, Failure> make_frame(const MultiPart& p, const Rim& rim) {
  if (!(p.ring_near < p.ring_far) || !(p.ring_near > 0.0)) {
    return failure(unsolvable(
        p.ring_near - p.ring_far,
        fmt::format("the ring's near edge, {:.3f} m, is not nearer than its far edge, {:.3f} m",
                    p.ring_near,
                    p.ring_far)));
  }
  if (!(p.ring_far > 2.0 * rim.radius)) {
    return failure(unsolvable(
        2.0 * rim.radius - p.ring_far,
        fmt::format("a ring of radius {:.4f} m that shows {:.3f} m needs the pinhole below the "
                    "floor, {:.3f} m nearer than twice the radius",
                    rim.radius,
                    p.ring_far,
                    2.0 * rim.radius - p.ring_far)));
  }
  // A flat mirror shows the floor at x (1 + height / y).
  const double y_B = rim.height / (p.ring_far / rim.radius - 1.0);
  const double x_B = rim.radius * p.ring_near / p.ring_far;
  const double t_B = x_B / y_B;
  const double reach = p.max_distance - x_B;
  if (!(reach > 0.0)) {
    return failure(unsolvable(-reach, fmt::format("max_distance lies inside the mirror")));
  }
  const double gamma_B = outer_slope_angle(t_B, x_B, rim.height, p.max_distance, p.max_height);
  const double t_A = p.isometric_share * t_B;
  const IsometricParameters isometric{p.isometric_range / t_A, rim.height - y_B, 0.0, t_A};
  return Frame{isometric, {x_B, y_B, std::tan(gamma_B)}, rim.radius};
}

std::optional<Node> end_of_isometric(IsometricParameters p, double apex, double tolerance) {
  p.apex = apex;
  const auto nodes = integrate_isometric(p, 1, tolerance);
  return nodes ? std::optional(nodes->back()) : std::nullopt;
}

/// By how much the arc from A passes above B; m. Continued by A's own height over B where A lies
/// further out, so that it is continuous and vanishes only where there is an arc.
std::optional<double> closure(const Frame& frame, double apex, double tolerance) {
  const auto end = end_of_isometric(frame.isometric, apex, tolerance);
  if (!end) {
    return std::nullopt;
  }
  if (end->x >= frame.point_B.x) {
    return end->y - frame.point_B.y;
  }
  return at(make_arc(*end, frame.point_B.x, std::atan(frame.point_B.slope)), frame.point_B.x).y -
         frame.point_B.y;
}

struct Bracket {
  std::optional<std::pair<double, double>> apex;
  double smallest_miss{std::numeric_limits<double>::infinity()};
};

/// Looks for a change of sign among apex heights up to that of B.
Bracket find_bracket(const Frame& frame) {
  constexpr int kSteps = 64;
  Bracket bracket;
  std::optional<double> before;
  double apex_before = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    const double apex = frame.point_B.y * static_cast<double>(i) / kSteps;
    const auto miss = closure(frame, apex, 1e-9);
    if (miss && std::abs(*miss) < std::abs(bracket.smallest_miss)) {
      bracket.smallest_miss = *miss;
    }
    if (before && miss && (*before < 0.0) != (*miss < 0.0)) {
      bracket.apex = {apex_before, apex};
      return bracket;
    }
    before = miss;
    apex_before = apex;
  }
  return bracket;
}

Failure no_closure(const Bracket& bracket) {
  return unsolvable(std::abs(bracket.smallest_miss),
                    fmt::format("the arc from A passes {} B by {:.3f} mm at best",
                                bracket.smallest_miss > 0.0 ? "above" : "below",
                                std::abs(bracket.smallest_miss) * 1e3));
}

}  // namespace

Result<MultiPartSolution, Failure> solve(const MultiPart& parameters, const Rim& rim) {
  const auto frame = make_frame(parameters, rim);
  if (!frame) {
    return failure(frame.error());
  }
  const Bracket bracket = find_bracket(*frame);
  if (!bracket.apex) {
    return failure(no_closure(bracket));
  }
  const auto miss = [&](double apex) {
    return closure(*frame, apex, 1e-13).value();
  };
  std::uintmax_t iterations = 60;
  const auto [low, high] =
      boost::math::tools::toms748_solve(miss,
                                        bracket.apex->first,
                                        bracket.apex->second,
                                        boost::math::tools::eps_tolerance<double>(50),
                                        iterations);
  MultiPartSolution solution;
  solution.parameters = parameters;
  solution.isometric = frame->isometric;
  solution.isometric.apex = 0.5 * (low + high);
  solution.point_A = end_of_isometric(frame->isometric, solution.isometric.apex, 1e-13).value();
  solution.arc = make_arc(solution.point_A, frame->point_B.x, std::atan(frame->point_B.slope));
  solution.point_B = frame->point_B;
  solution.point_C = {frame->ring_end, frame->point_B.y, 0.0};
  return solution;
}

Profile MultiPartSolution::profile() const {
  Part ring{.name = "ring", .nodes = {}, .kinked_start = true};
  for (std::size_t i = 0; i <= kRingIntervals; ++i) {
    const double u = static_cast<double>(i) / kRingIntervals;
    ring.nodes.push_back({i == kRingIntervals ? point_C.x : point_B.x + u * (point_C.x - point_B.x),
                          point_C.y,
                          0.0});
  }
  Part middle{.name = "constant curvature", .nodes = sample(arc, kArcIntervals)};
  return {
      {{.name = "isometric", .nodes = integrate_isometric(isometric, kIsometricIntervals).value()},
       std::move(middle),
       std::move(ring)}};
}

}  // namespace teamsight::mirror
