// sim/setup.cpp: see setup.hpp.
#include "sim/setup.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "sim/match/scenario.hpp"
#include "sim/render/defects.hpp"

namespace teamsight::sim {
namespace {

constexpr Paint kBodySide{24, 23, 25};
constexpr Paint kBodyLid{46, 46, 50};

std::string known_scenarios() {
  std::string names;
  for (const ScenarioName& name : scenario_names()) {
    names += (names.empty() ? "" : ", ") + std::string(name.name);
  }
  return names;
}

MatchParameters parameters_of(const Setup& setup,
                              const std::filesystem::path& file,
                              std::optional<std::uint32_t> seed) {
  MatchParameters base;
  base.seed = seed.value_or(setup.match.seed);
  base.own = setup.match.robots;
  base.opponents = setup.match.opponents;
  if (setup.match.team.has_value()) {
    base.ball.radius = setup.match.team->ball_radius;
    base.body.radius = setup.match.team->robot_radius;
  }
  auto parameters = make_scenario(setup.match.scenario, std::move(base), setup.field);
  if (!parameters.has_value()) {
    throw std::runtime_error(file.string() + ": scenario: found \"" + setup.match.scenario +
                             "\", expected one of " + known_scenarios());
  }
  return *std::move(parameters);
}

PictureParameters look_of(const settings::MatchSettings& match) {
  const settings::PictureSettings& picture = match.picture;
  PictureParameters look;
  look.fineness = picture.samples_per_axis;
  look.moments = picture.moments;
  look.exposure = picture.exposure;
  look.sensor.exposure = picture.gain;
  look.sensor.red_gain = picture.red_gain;
  look.sensor.green_gain = picture.green_gain;
  look.sensor.blue_gain = picture.blue_gain;
  look.sensor.vignetting = picture.vignetting;
  look.sensor.defocus_px = picture.defocus_px;
  look.sensor.rim_defocus_px = picture.rim_defocus_px;
  look.sensor.noise_sigma = match.pixel_noise_sigma;
  look.unevenness = picture.unevenness;
  for (const settings::PictureSettings::Body& part : picture.body) {
    look.body.push_back({part.radius, part.height, kBodySide, kBodyLid});
  }
  if (look.body.empty()) {
    look.body = low_body();
  }
  for (const settings::PictureSettings::Strut& strut : picture.struts) {
    look.struts.push_back({strut.direction, strut.half_width});
  }
  return look;
}

Paint paint_of(const settings::BallPaintSettings::Rgb& rgb) {
  return {rgb[0], rgb[1], rgb[2]};
}

BallPattern pattern_of(settings::BallPaintSettings::Pattern pattern) {
  using Pattern = settings::BallPaintSettings::Pattern;
  switch (pattern) {
    case Pattern::kFootball:
      return BallPattern::kFootball;
    case Pattern::kOctants:
      return BallPattern::kOctants;
    case Pattern::kPlain:
      break;
  }
  return BallPattern::kPlain;
}

BallLook ball_of(const settings::BallPaintSettings& ball) {
  BallLook look;
  look.paint = paint_of(ball.paint);
  look.pattern = pattern_of(ball.pattern);
  look.panels = paint_of(ball.panels);
  return look;
}

}  // namespace

std::string scenario_help() {
  std::string lines = "Scenarios, as a match file may name them:";
  for (const ScenarioName& name : scenario_names()) {
    lines += "\n  " + std::string(name.name) + ": " + std::string(name.purpose);
  }
  return lines;
}

Setup load_setup(const std::filesystem::path& match,
                 const std::filesystem::path& team,
                 std::optional<std::uint32_t> seed) {
  Setup setup;
  setup.match = settings::load_match(match);
  if (!team.empty()) {
    setup.match.team = settings::load_team(team);
  }
  setup.field = settings::load_field(setup.match.field);
  setup.camera = settings::load_camera(setup.match.camera);
  setup.parameters = parameters_of(setup, match, seed);
  const bool is_table = std::holds_alternative<vision::RadialTable>(setup.camera.mirror);
  if (is_table && setup.match.picture.defect_seed != 0) {
    throw std::runtime_error(match.string() +
                             ": picture.defect_seed: found a camera with a radial table, expected "
                             "one with a profile: only a mirror can be put together badly");
  }
  return setup;
}

Eye make_eye(const Setup& setup, std::size_t player, vision::PixelFormat format) {
  vision::CameraParameters camera = setup.camera;
  camera.format = format;
  const std::uint32_t seed = setup.match.picture.defect_seed;
  if (seed != 0) {
    camera = with_defects(camera, draw_defects(100 * seed + static_cast<std::uint32_t>(player)));
  }
  return {Renderer(camera, setup.field, look_of(setup.match)),
          {setup.parameters.ball.radius,
           setup.parameters.body.radius,
           setup.parameters.body.height,
           people_around(setup.field, setup.parameters.seed),
           ball_of(setup.match.ball)}};
}

}  // namespace teamsight::sim
