// bench/locate_score/methods.cpp: asking, timing, the bound.
#include "bench/locate_score/methods.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <Eigen/LU>

#include "bench/locate_rivals/monte_carlo.hpp"
#include "bench/locate_rivals/rprop.hpp"

namespace teamsight::locate_score {

namespace {

constexpr double kHoughPixel = 0.025;  // m; the bird's-eye image of 480 rows and 6 m
constexpr double kHoughReach = 8.0;    // m
constexpr double kOnPaint = 0.15;      // m at the truth: beyond, a point is an outlier
constexpr double kMostBound = 0.1;     // m; poses that nobody can find say nothing of a method
constexpr int kMonteCarloLooks = 5;    // resamplings on one frame

template <class Work>
Answer timed(Work work) {
  const auto start = std::chrono::steady_clock::now();
  Answer answer = work();
  answer.time_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::optional<Eigen::Vector2d> bound_of(const vision::LineMap& map,
                                        const Look& look,
                                        const vision::HeadTilt& tilt) {
  using Information = Eigen::Matrix<double, 5, 5>;
  Information info = Information::Zero();
  std::vector<double> sizes;
  for (const vision::LinePoint& point : look.points) {
    const auto r = vision::line_residual(map, look.truth, point, {0.0, 0.0}, tilt.eye_height);
    if (std::abs(r.distance) > kOnPaint) continue;
    Eigen::Matrix<double, 5, 1> row;
    row << r.jacobian, r.tilt_jacobian;
    info += row * row.transpose() / r.var;
    sizes.push_back(std::abs(r.distance) / std::sqrt(r.var));
  }
  if (sizes.size() < 10) return std::nullopt;
  const double scale = 1.4826 * median(sizes);
  info /= scale * scale;
  info.diagonal().tail<2>() += tilt.sigma.cwiseMax(1e-6).cwiseAbs2().cwiseInverse();
  if (std::abs(info.determinant()) < 1e-6) return std::nullopt;
  const Information cov = info.inverse();
  const Eigen::Vector2d bound(cov(0, 0) + cov(1, 1), cov(2, 2));
  if (!bound.allFinite() || !(bound.x() > 0.0) || bound.x() > kMostBound * kMostBound) {
    return std::nullopt;
  }
  return bound;
}

PointHough::PointHough(const FieldModel& field)
    : field_(field),
      lines_(vision::field_lines_of(field)),
      hough_(kHoughPixel, kHoughReach) {}

Answer PointHough::locate(std::span<const vision::LinePoint> points) {
  transitions_.clear();
  for (const vision::LinePoint& point : points) transitions_.push_back(point.p_R);
  return timed([&] {
    Answer answer;
    for (const auto& found : vision::hough2001_candidates(hough_, lines_, transitions_, {})) {
      const bool is_inside = std::abs(found.X_FR.x()) < 0.5 * field_.length + 0.2 &&
                             std::abs(found.X_FR.y()) < 0.5 * field_.width + 0.2;
      if (!is_inside) continue;
      answer.X_FR = Pose<Field, Robot>(
          found.X_FR.x() + field_.centre.x, found.X_FR.y() + field_.centre.y, found.X_FR.theta());
      break;
    }
    return answer;
  });
}

Methods::Methods(const FieldModel& field,
                 const vision::LocalisationParameters& parameters,
                 const MethodChoice& choice,
                 std::uint32_t seed)
    : field_(field),
      parameters_(parameters),
      choice_(choice),
      seed_(seed),
      localiser_(field, parameters),
      begun_(localiser_.begin()),
      search_(field),
      table_(field),
      hough_(field) {
  if (is_half_turn_symmetric(field)) symmetry_ = field.centre;
}

Answer Methods::track(const Look& look) {
  vision::LocalisationState state = begun_;
  const HostTime exposure{std::chrono::seconds(10)};
  const Eigen::Vector3d sigma(kPriorSigma, kPriorSigma, kPriorSigmaTurn);
  localiser_.place(state, look.prior, sigma.cwiseAbs2().asDiagonal(), exposure);
  // As on the way, where the place was seen to be good before: not as when somebody names it.
  state.usual_support = -1.0;
  state.last_fix = exposure;
  return timed([&] {
    const vision::Located located = localiser_.see(state, {exposure, look.points});
    Answer answer;
    if (located.posture.status != PostureStatus::kLost) {
      answer.X_FR = located.posture.X_FR;
      answer.cov = located.posture.cov;
    }
    return answer;
  });
}

Answer Methods::global(const Look& look) {
  vision::SearchRequest request;
  request.points.assign(look.points.begin(), look.points.end());
  request.tilt = parameters_.tilt;
  return timed([&] {
    const vision::SearchAnswer found = search_.answer(request);
    Answer answer;
    if (!found.places.empty()) {
      answer.X_FR = found.places.front().X_FR;
      answer.cov =
          found.places.front().cov + vision::shared_part(found.places.front(), parameters_.shared);
    }
    return answer;
  });
}

Answer Methods::rprop10(const Look& look) const {
  return timed([&] {
    return Answer{locate_rivals::rprop(table_, look.points, look.prior), {}, 0};
  });
}

Answer Methods::mcl500(const Look& look) {
  locate_rivals::MonteCarlo cloud(field_, {}, ++seed_);
  cloud.gather(look.prior, {kPriorSigma, kPriorSigma, kPriorSigmaTurn});
  return timed([&] {
    for (int i = 0; i < kMonteCarloLooks; ++i) {
      cloud.move({});
      cloud.weigh(table_, look.points);
    }
    return Answer{cloud.estimate(), {}, 0};
  });
}

void Methods::ask(const Look& look, bool with_bound) {
  std::optional<Eigen::Vector2d> tilting;
  std::optional<Eigen::Vector2d> level;
  if (with_bound) {
    vision::HeadTilt known = parameters_.tilt;
    known.sigma.setZero();
    tilting = bound_of(localiser_.map(), look, parameters_.tilt);
    level = bound_of(localiser_.map(), look, known);
    if (!tilting || !level) return;
  }
  const Eigen::Vector2d none = Eigen::Vector2d::Zero();
  if (choice_.tracking) {
    const Answer answer = track(look);
    tallies_["track"].add(answer, look.truth, tilting.value_or(none), std::nullopt);
    // The same answers against the bound of a robot that knows how its head leans.
    if (level) tallies_["track_level_bound"].add(answer, look.truth, *level, std::nullopt);
  }
  if (choice_.global) {
    tallies_["global"].add(global(look), look.truth, tilting.value_or(none), symmetry_);
  }
  if (!choice_.rivals) return;
  const Eigen::Vector2d bound = level.value_or(none);
  tallies_["rprop10"].add(rprop10(look), look.truth, bound, std::nullopt);
  tallies_["mcl500"].add(mcl500(look), look.truth, bound, std::nullopt);
  if (!choice_.hough) return;
  tallies_["hough2001"].add(hough_.locate(look.points), look.truth, bound, symmetry_);
}

}  // namespace teamsight::locate_score
