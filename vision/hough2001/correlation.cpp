// vision/hough2001/correlation.cpp: steps 4 to 8: the relevant pair, four correlations, eq. (7).
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "vision/hough2001/hough2001.hpp"

namespace teamsight::vision {

namespace {

constexpr double kRightAngle = 0.5 * std::numbers::pi;

/// One way of laying image lines over field lines.
struct Shift {
  double robot{0.0};  // the robot's coordinate along the axis; m
  int matches{0};
  int votes{0};
};

/// How image lines are laid over field lines.
struct AxisRules {
  double sign{1.0};  // of the axis along the image's normal
  double same{0.0};  // lines this near are the same; m
};

bool is_better(const Shift& a, const Shift& b) {
  return a.matches != b.matches ? a.matches > b.matches : a.votes > b.votes;
}

// Steps 4 and 5: how well two lines' difference of angle and distance suits the field; nothing if
// their angle alone rules them out.
std::optional<double> grade_of(const HoughLine& a, const HoughLine& b, const FieldLines& lines) {
  const double delta_phi = std::abs(a.phi - b.phi);
  const double angle = relevance_of_angle(delta_phi);
  if (angle <= 0.0) return std::nullopt;
  // Parallel across 180 degrees: the second distance counts the other way.
  const double delta_rho = std::abs(delta_phi > kRightAngle ? a.rho + b.rho : a.rho - b.rho);
  return angle + relevance_of_distance(lines, delta_rho);
}

// Step 6: the normal of the most relevant pair, by grade, then votes. One line alone still gives a
// direction; nothing if there is none.
std::optional<double> relevant_direction(const std::vector<HoughLine>& found,
                                         const FieldLines& lines) {
  if (found.empty()) return std::nullopt;
  std::pair<double, int> best{0.0, 0};
  double direction = found.front().phi;
  for (std::size_t j = 0; j < found.size(); ++j) {
    for (std::size_t k = 0; k < j; ++k) {
      const auto grade = grade_of(found[j], found[k], lines);
      if (!grade) continue;
      const std::pair<double, int> merit{*grade, found[j].votes + found[k].votes};
      if (merit <= best) continue;
      best = merit;
      // The stronger line of the two knows its direction better.
      direction = found[j].votes > found[k].votes ? found[j].phi : found[k].phi;
    }
  }
  return direction;
}

// The strongest image line within `same` of a distance; null if there is none.
const HoughLine* line_at(double rho, const std::vector<HoughLine>& image, double same) {
  const HoughLine* met = nullptr;
  for (const HoughLine& candidate : image) {
    if (std::abs(candidate.rho - rho) > same) continue;
    if (met == nullptr || candidate.votes > met->votes) met = &candidate;
  }
  return met;
}

// What meets if the robot's coordinate is `robot`, and the coordinate by all that met.
Shift shift_at(double robot,
               const std::vector<double>& model,
               const std::vector<HoughLine>& image,
               const AxisRules& rules) {
  Shift shift;
  double sum = 0.0;
  for (const double line : model) {
    const HoughLine* met = line_at(rules.sign * (line - robot), image, rules.same);
    if (met == nullptr) continue;
    ++shift.matches;
    shift.votes += met->votes;
    sum += met->votes * (line - rules.sign * met->rho);
  }
  // The reference point is where the matched lines put it, each by its votes.
  shift.robot = shift.votes > 0 ? sum / shift.votes : robot;
  return shift;
}

bool is_known(const std::vector<Shift>& shifts, double robot, double same) {
  return std::ranges::any_of(
      shifts, [&](const Shift& known) { return std::abs(known.robot - robot) < same; });
}

// Step 8: shifts one array over the other and counts what meets. Best first.
std::vector<Shift> correlate(const std::vector<double>& model,
                             const std::vector<HoughLine>& image,
                             const AxisRules& rules) {
  std::vector<Shift> shifts;
  for (const double line : model) {
    for (const HoughLine& reference : image) {
      const Shift shift = shift_at(line - rules.sign * reference.rho, model, image, rules);
      if (!is_known(shifts, shift.robot, rules.same)) shifts.push_back(shift);
    }
  }
  std::ranges::stable_sort(shifts, is_better);
  return shifts;
}

struct Candidate {
  Hough2001Result result;
  int votes{0};
};

// The candidates if phi is the normal of the vertical lines (along x), or else of the horizontal.
void add_candidates(const std::array<std::vector<HoughLine>, 2>& image,
                    const FieldLines& lines,
                    bool phi_is_x,
                    const Hough2001Parameters& parameters,
                    std::vector<Candidate>& candidates) {
  const double phi = image[0].empty() ? image[1].front().phi - kRightAngle : image[0].front().phi;
  // phi along x: y is the image's second normal. phi along y: x is the second normal turned round.
  const auto& along_x = phi_is_x ? image[0] : image[1];
  const auto& along_y = phi_is_x ? image[1] : image[0];
  const double sign_x = phi_is_x ? 1.0 : -1.0;
  const double theta = phi_is_x ? -phi : kRightAngle - phi;
  const auto x = correlate(lines.vertical, along_x, {sign_x, parameters.same_distance});
  const auto y = correlate(lines.horizontal, along_y, {1.0, parameters.same_distance});
  constexpr std::size_t kOfEach = 4;
  for (std::size_t i = 0; i < std::min(x.size(), kOfEach); ++i) {
    for (std::size_t j = 0; j < std::min(y.size(), kOfEach); ++j) {
      Candidate candidate;
      candidate.result.X_FR = {x[i].robot, y[j].robot, theta};
      candidate.result.matches = x[i].matches + y[j].matches;
      candidate.votes = x[i].votes + y[j].votes;
      candidates.push_back(candidate);
    }
  }
}

}  // namespace

std::vector<Hough2001Result> hough2001_candidates(LineHough& hough,
                                                  const FieldLines& lines,
                                                  std::span<const Point<Robot>> transitions,
                                                  const Hough2001Parameters& parameters) {
  hough.vote(transitions);
  const auto found = hough.strongest(parameters.lines);
  const auto phi = relevant_direction(found, lines);
  if (!phi) return {};
  std::array<std::vector<HoughLine>, 2> image{
      hough.strongest_around(*phi, parameters.columns, parameters.lines),
      hough.strongest_around(*phi + kRightAngle, parameters.columns, parameters.lines)};
  if (image[0].empty() || image[1].empty()) return {};
  std::vector<Candidate> candidates;
  add_candidates(image, lines, true, parameters, candidates);
  add_candidates(image, lines, false, parameters, candidates);
  std::ranges::stable_sort(candidates, [](const Candidate& a, const Candidate& b) {
    return a.result.matches != b.result.matches ? a.result.matches > b.result.matches
                                                : a.votes > b.votes;
  });
  std::vector<Hough2001Result> results;
  for (const Candidate& candidate : candidates) {
    if (results.size() == static_cast<std::size_t>(parameters.maxima)) break;
    results.push_back(candidate.result);
    results.back().maximum = static_cast<int>(results.size()) - 1;
  }
  return results;
}

}  // namespace teamsight::vision
