// tools/patterned_scenes.cpp: see tools/patterned_scenes.hpp.
#include "tools/patterned_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/rendered_field.hpp"

namespace teamsight::tools {

namespace {

using vision::ColourClass;

constexpr double kNearest = 0.5;   // m
constexpr double kFarthest = 6.0;  // m
constexpr double kBeside = 0.02;   // m, between a ball and the robot that it lies at
constexpr sim::Paint kWhite{230, 230, 230};
constexpr sim::Paint kBlack{20, 20, 20};
constexpr sim::Paint kOrange{240, 110, 20};
constexpr std::array<sim::Paint, 4> kShirts{
    {{40, 190, 210}, {220, 40, 180}, {225, 225, 225}, {24, 24, 24}}};
constexpr std::array<PatternedBall, 3> kBalls{{{"football, white and black",
                                                sim::BallPattern::kFootball,
                                                kWhite,
                                                kBlack,
                                                {ColourClass::kWhite, ColourClass::kBlack}},
                                               {"octants, white and black",
                                                sim::BallPattern::kOctants,
                                                kWhite,
                                                kBlack,
                                                {ColourClass::kWhite, ColourClass::kBlack}},
                                               {"octants, white and orange",
                                                sim::BallPattern::kOctants,
                                                kWhite,
                                                kOrange,
                                                {ColourClass::kWhite, ColourClass::kBall}}}};

Eigen::Quaterniond any_turn(sim::Random& random) {
  Eigen::Quaterniond turn(
      random.normal(1.0), random.normal(1.0), random.normal(1.0), random.normal(1.0));
  return turn.normalized();
}

Point<Field> anywhere(const FieldModel& field, sim::Random& random) {
  return {field.centre.x + random.uniform(-0.5, 0.5) * field.length,
          field.centre.y + random.uniform(-0.5, 0.5) * field.width};
}

Point<Field> on_a_line(const FieldModel& field, sim::Random& random) {
  const FieldLine& line = field.lines[random.below(static_cast<std::uint32_t>(field.lines.size()))];
  const double share = random.uniform(0.0, 1.0);
  return Point<Field>::from((1.0 - share) * line.from.vector() + share * line.to.vector());
}

// On the side from which it is seen, or at the robot's flank.
Point<Field> beside_a_robot(const sim::Scene& scene, double ball_radius, sim::Random& random) {
  const auto i = random.below(static_cast<std::uint32_t>(scene.robots.size()));
  const sim::SceneRobot& robot = scene.robots[i];
  const Eigen::Vector2d way = scene.X_FR.origin().vector() - robot.p_F.vector();
  const double side = std::atan2(way.y(), way.x()) + random.uniform(-1.0, 1.0);
  const double apart = robot.radius + ball_radius + kBeside;
  return {robot.p_F.x + apart * std::cos(side), robot.p_F.y + apart * std::sin(side)};
}

double distance_to(const sim::Scene& scene, const Point<Field>& p_F) {
  return (scene.X_FR.origin().vector() - p_F.vector()).norm();
}

bool is_free(const sim::Scene& scene, const Point<Field>& place, double radius) {
  return std::ranges::all_of(scene.robots, [&](const sim::SceneRobot& robot) {
    return (robot.p_F.vector() - place.vector()).norm() > robot.radius + radius;
  });
}

// All distances alike: of places drawn at random the near ones are rare.
Point<Field> ball_place(const FieldModel& field,
                        const sim::Scene& scene,
                        double radius,
                        sim::Random& random) {
  const std::uint32_t kind = random.below(3);
  const double band = kNearest + 0.5 * random.below(11);
  for (int tries = 0;; ++tries) {
    Point<Field> place = anywhere(field, random);
    if (kind == 1) place = on_a_line(field, random);
    if (kind == 2 && tries < 50) place = beside_a_robot(scene, radius, random);
    const double distance = distance_to(scene, place);
    const bool is_in_band = distance >= band && distance < band + 0.5;
    const bool is_in_reach = distance >= kNearest && distance < kFarthest;
    if ((tries < 500 ? is_in_band : is_in_reach) && is_free(scene, place, radius)) return place;
  }
}

vision::CameraParameters with_pattern(vision::CameraParameters camera, const PatternedBall& ball) {
  camera.colours.pattern.assign(ball.classes.begin(), ball.classes.end());
  return camera;
}

sim::PictureParameters fine_picture() {
  sim::PictureParameters picture;
  picture.fineness = 2;
  return picture;
}

}  // namespace

std::span<const PatternedBall> patterned_balls() {
  return kBalls;
}

PatternedScene patterned_scene(const FieldModel& field,
                               const PatternedBall& ball,
                               sim::Random& random) {
  PatternedScene made;
  made.scene = random_scene(field, random);
  made.scene.balls.clear();
  for (sim::SceneRobot& robot : made.scene.robots) {
    robot.shirt = kShirts[random.below(static_cast<std::uint32_t>(kShirts.size()))];
    if (random.chance(0.5)) robot.markers = kWhite;
  }
  const double kind = random.uniform(0.0, 1.0);
  if (kind >= 0.75) return made;
  sim::SceneBall painted;
  painted.look = {ball.paint, ball.pattern, ball.panels, any_turn(random)};
  if (kind >= 0.5) painted.look.pattern = sim::BallPattern::kPlain;
  const Point<Field> place = ball_place(field, made.scene, painted.radius, random);
  painted.p_FB = {place.x, place.y, painted.radius};
  made.scene.balls.push_back(painted);
  if (kind < 0.5) made.distance = distance_to(made.scene, place);
  return made;
}

PatternedViews::PatternedViews(const vision::CameraParameters& camera,
                               const FieldModel& field,
                               const PatternedBall& ball,
                               const vision::PerceptionParameters& parameters)
    : camera_(with_pattern(camera, ball)),
      field_(field),
      ball_(ball),
      perception_(camera_, field, parameters),
      renderer_(camera_, field, fine_picture()) {}

PatternedViews::View PatternedViews::look(sim::Random& random) {
  const PatternedScene made = patterned_scene(field_, ball_, random);
  renderer_.draw(made.scene, random, bytes_);
  vision::MotionPrior prior;
  prior.X_FR = made.scene.X_FR;
  View view;
  view.distance = made.distance;
  view.seen =
      *perception_.see({bytes_, camera_.width_px, camera_.height_px, camera_.format}, prior);
  if (made.distance) view.labels = labels_of(made.scene, renderer_, {});
  return view;
}

}  // namespace teamsight::tools
