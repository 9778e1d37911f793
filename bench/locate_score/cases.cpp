// bench/locate_score/cases.cpp: single looks: noise, hardware, faults.
#include "bench/locate_score/cases.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "bench/locate_score/methods.hpp"
#include "bench/locate_score/rendered_view.hpp"

namespace teamsight::locate_score {

namespace {

constexpr double kMargin = 0.3;  // m, of the poses from the outer lines
constexpr std::size_t kRobots = 10;
constexpr double kGlareRadius = 60.0 / 640.0;  // shares of the picture's width

Pose<Field, Robot> draw_prior(const Pose<Field, Robot>& truth, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {truth.x() + kPriorSigma * normal(random),
          truth.y() + kPriorSigma * normal(random),
          truth.theta() + kPriorSigmaTurn * normal(random)};
}

struct Plan {
  std::size_t poses{0};
  int robots{0};
  bool has_glare{false};
  bool with_bound{false};
  Spoil spoil{};
  PointErrors* errors{nullptr};  ///< nothing: they are not wanted
};

std::vector<Point<Field>> draw_robots(const Plan& plan,
                                      const Pose<Field, Robot>& truth,
                                      std::mt19937& random) {
  std::uniform_real_distribution<double> distance(0.7, 4.0);
  std::uniform_real_distribution<double> azimuth(-std::numbers::pi, std::numbers::pi);
  std::vector<Point<Field>> robots;
  for (int i = 0; i < plan.robots; ++i) {
    const double r = distance(random);
    const double a = azimuth(random);
    robots.push_back(truth * Point<Robot>{r * std::cos(a), r * std::sin(a)});
  }
  return robots;
}

void play(const Plan& plan,
          RenderedView& view,
          const FieldModel& field,
          Methods& methods,
          std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const vision::LineMap map(field);
  std::vector<vision::LinePoint> points;
  for (std::size_t i = 0; i < plan.poses; ++i) {
    const Pose<Field, Robot> truth = draw_pose(field, kMargin, random);
    view.draw(truth, draw_robots(plan, truth, random));
    if (plan.has_glare) {
      const auto image = view.image();
      view.blind({unit(random) * image.width_px,
                  unit(random) * image.height_px,
                  kGlareRadius * image.width_px});
    }
    const auto seen = view.line_points();
    points.assign(seen.begin(), seen.end());
    if (plan.errors != nullptr) plan.errors->add(map, truth, points, view.head().eye_height);
    if (plan.spoil) plan.spoil(points, truth, random);
    methods.ask({truth, draw_prior(truth, random), points}, plan.with_bound);
  }
}

// The camera file is the truth, and the tracker is told so.
constexpr vision::SharedError kExact{.share = 0.0, .sigma_place = 1e-5, .sigma_heading = 1e-5};

// The same with line points that were found in a picture: what finding them makes all of them
// share, measured on frames of seed 101.
constexpr vision::SharedError kExactEye{
    .share = 0.0, .sigma_place = 0.0006, .sigma_heading = 0.00015};

vision::LocalisationParameters parameters_for(const RenderedView& view,
                                              const vision::SharedError& shared) {
  vision::LocalisationParameters parameters;
  parameters.tilt = view.head();
  parameters.shared = shared;
  return parameters;
}

// First what happens on the field, then the eye.
Spoil through_some_eye(const Spoil& spoil,
                       const CalibrationRemainder& remainder,
                       double eye_height) {
  return [=](auto& points, const Pose<Field, Robot>& truth, std::mt19937& random) {
    if (spoil) spoil(points, truth, random);
    Eye(remainder, eye_height, random).look(points);
  };
}

}  // namespace

CaseResult run_drawn_noise(const CaseOptions& options) {
  std::mt19937 random(options.seed + 50);
  vision::LocalisationParameters parameters;
  parameters.shared = kExact;
  Methods methods(options.field, parameters, {.rivals = options.rivals}, options.seed);
  for (std::size_t i = 0; i < options.poses; ++i) {
    const Pose<Field, Robot> truth = draw_pose(options.field, kMargin, random);
    const auto points = look_at_lines(options.field, truth, {}, {}, random);
    methods.ask({truth, draw_prior(truth, random), points}, true);
  }
  return {"noise", "drawn points, independent errors", methods.tallies()};
}

CaseResult run_noise(const CaseOptions& options) {
  RenderedView view(options.camera, options.camera, options.field, options.pixel_noise_sigma);
  std::mt19937 random(options.seed);
  Methods methods(
      options.field, parameters_for(view, kExactEye), {.rivals = options.rivals}, options.seed);
  Plan plan;
  plan.poses = options.poses;
  plan.with_bound = true;
  PointErrors errors;
  plan.errors = &errors;
  play(plan, view, options.field, methods, random);
  return {"noise", "rendered frames", methods.tallies(), errors};
}

CaseResult run_hardware(const CaseOptions& options, const CalibrationRemainder& remainder) {
  RenderedView view(options.camera, options.camera, options.field, options.pixel_noise_sigma);
  std::mt19937 random(options.seed + 1);
  Methods methods(
      options.field, parameters_for(view, {}), {.rivals = options.rivals}, options.seed);
  for (std::size_t robot = 0; robot < kRobots; ++robot) {
    Plan plan;
    plan.poses = options.poses / kRobots;
    const Eye eye(remainder, view.head().eye_height, random);
    plan.spoil = [eye](
                     auto& points, const Pose<Field, Robot>& /*truth*/, std::mt19937& /*random*/) {
      eye.look(points);
    };
    play(plan, view, options.field, methods, random);
  }
  return {"hardware", "remainder of a calibration", methods.tallies()};
}

std::vector<CaseResult> run_faults(const CaseOptions& options,
                                   const CalibrationRemainder& remainder) {
  RenderedView view(options.camera, options.camera, options.field, options.pixel_noise_sigma);
  std::vector<CaseResult> results;
  const auto part = [&](const std::string& detail, const Plan& given) {
    Plan plan = given;
    plan.poses = options.poses;
    plan.spoil = through_some_eye(given.spoil, remainder, view.head().eye_height);
    const auto number = static_cast<std::uint32_t>(results.size());
    std::mt19937 random(options.seed + 10 + number);
    Methods methods(
        options.field, parameters_for(view, {}), {.rivals = options.rivals}, options.seed);
    play(plan, view, options.field, methods, random);
    results.push_back({"faults", detail, methods.tallies()});
  };
  part("30 % of the lines hidden", {.spoil = hide(0.3)});
  part("70 % of the lines hidden", {.spoil = hide(0.7)});
  part("10 % false white", {.spoil = falsify(0.1)});
  part("30 % false white", {.spoil = falsify(0.3)});
  part("50 % false white", {.spoil = falsify(0.5)});
  part("6 robots around", {.robots = 6});
  part("head leans, sigma 0.4 degrees", {.spoil = lean(view.head().eye_height)});
  part(fmt::format("glare, {:.0f} px", kGlareRadius * options.camera.width_px),
       {.has_glare = true});
  RenderedView elsewhere(
      options.camera, options.camera, options.other_field, options.pixel_noise_sigma);
  std::mt19937 random(options.seed + 30);
  Methods methods(
      options.other_field, parameters_for(elsewhere, {}), {.rivals = options.rivals}, 5);
  Plan plan;
  plan.poses = options.poses;
  plan.spoil = through_some_eye({}, remainder, elsewhere.head().eye_height);
  play(plan, elsewhere, options.other_field, methods, random);
  results.push_back({"faults", "field " + options.other_field.name, methods.tallies()});
  return results;
}

}  // namespace teamsight::locate_score
