// tools/rendered_field.cpp: see tools/rendered_field.hpp.
#include "tools/rendered_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/angle.hpp"
#include "vision/camera_model.hpp"

namespace teamsight::tools {

namespace {

constexpr double kTouching = 0.6;      // m between middles
constexpr double kPersonRadius = 0.3;  // m: two legs apart
constexpr double kHeldApart = 0.05;    // rad between what hides and what is hidden
constexpr double kFoundWithin = 0.5;   // m
constexpr sim::Paint kOwnShirt{40, 190, 210};
constexpr sim::Paint kTheirShirt{220, 40, 180};

/// Something that stands there, as the eye sees it.
struct Standing {
  Point<Robot> p_R;
  double radius{0.0};
};

double distance_of(const Point<Robot>& p_R) {
  return p_R.vector().norm();
}

// On the carpet, away from everything that is there already.
Point<Field> free_place(const FieldModel& field,
                        sim::Random& random,
                        std::vector<Point<Field>>& taken) {
  for (;;) {
    const Point<Field> place{field.centre.x + random.uniform(-0.5, 0.5) * field.length,
                             field.centre.y + random.uniform(-0.5, 0.5) * field.width};
    const bool is_free = std::ranges::all_of(taken, [&](const Point<Field>& other) {
      return (other.vector() - place.vector()).norm() > kTouching;
    });
    if (!is_free) continue;
    taken.push_back(place);
    return place;
  }
}

std::vector<Standing> standing_in(const sim::Scene& scene) {
  const Pose<Robot, Field> X_RF = scene.X_FR.inverse();
  std::vector<Standing> all;
  for (const sim::SceneRobot& robot : scene.robots) all.push_back({X_RF * robot.p_F, robot.radius});
  for (const sim::ScenePerson& person : scene.people) {
    all.push_back({X_RF * person.p_F, kPersonRadius});
  }
  return all;
}

// Whether something nearer stands before it, at least in part.
bool is_hidden(const Standing& thing, const std::vector<Standing>& all) {
  const double distance = distance_of(thing.p_R);
  const double azimuth = std::atan2(thing.p_R.y, thing.p_R.x);
  return std::ranges::any_of(all, [&](const Standing& other) {
    const double nearer = distance_of(other.p_R);
    if (nearer >= distance) return false;
    const double apart = std::abs(angle_difference(std::atan2(other.p_R.y, other.p_R.x), azimuth));
    return apart < std::asin(std::min(1.0, other.radius / nearer)) +
                       std::asin(std::min(1.0, thing.radius / distance)) + kHeldApart;
  });
}

Point<Robot> foot_of(const Standing& thing) {
  const Eigen::Vector2d p = thing.p_R.vector();
  return Point<Robot>::from(p * (1.0 - thing.radius / p.norm()));
}

std::optional<LabelledFoot> foot_label(const Standing& thing,
                                       const sim::Renderer& renderer,
                                       bool counts) {
  const Point<Robot> foot = foot_of(thing);
  const auto place = renderer.find({foot.x, foot.y, 0.0});
  if (!place) return std::nullopt;
  return LabelledFoot{place->u, place->v, counts};
}

std::optional<LabelledBall> ball_label(const Point3<Robot>& p_RB,
                                       double radius,
                                       const sim::Renderer& renderer,
                                       bool counts) {
  const auto middle = renderer.find(p_RB);
  const auto top = renderer.find({p_RB.x, p_RB.y, p_RB.z + radius});
  if (!middle || !top) return std::nullopt;
  const double radius_px = std::hypot(top->u - middle->u, top->v - middle->v);
  return LabelledBall{middle->u, middle->v, radius_px, counts};
}

Point3<Robot> ball_in(const sim::Scene& scene, const sim::SceneBall& ball) {
  const Point<Robot> p_R = scene.X_FR.inverse() * Point<Field>{ball.p_FB.x, ball.p_FB.y};
  return {p_R.x, p_R.y, ball.p_FB.z};
}

template <class Places>
void add_nearest(const Eigen::Vector2d& truth, const Places& places, std::vector<double>& errors) {
  double nearest = kFoundWithin;
  for (const Eigen::Vector2d& place : places) nearest = std::min(nearest, (place - truth).norm());
  if (nearest < kFoundWithin) errors.push_back(nearest);
}

}  // namespace

sim::Scene random_scene(const FieldModel& field, sim::Random& random) {
  std::vector<Point<Field>> taken;
  sim::Scene scene;
  const Point<Field> own = free_place(field, random, taken);
  scene.X_FR = {own.x, own.y, random.uniform(-std::numbers::pi, std::numbers::pi)};
  if (random.chance(0.75)) {
    const Point<Field> place = free_place(field, random, taken);
    sim::SceneBall ball;
    ball.p_FB = {place.x, place.y, ball.radius};
    scene.balls.push_back(ball);
  }
  for (int i = 0; i < 5; ++i) {
    sim::SceneRobot robot;
    robot.p_F = free_place(field, random, taken);
    robot.shirt = i % 2 == 0 ? kOwnShirt : kTheirShirt;
    scene.robots.push_back(robot);
  }
  for (int i = 0; i < 2; ++i) scene.people.push_back({free_place(field, random, taken)});
  return scene;
}

ImageLabels labels_of(const sim::Scene& scene, const sim::Renderer& renderer, const Reach& reach) {
  const std::vector<Standing> all = standing_in(scene);
  ImageLabels labels;
  for (const sim::SceneBall& ball : scene.balls) {
    const Point3<Robot> p_RB = ball_in(scene, ball);
    const Standing where{{p_RB.x, p_RB.y}, ball.radius};
    const bool counts = distance_of(where.p_R) < reach.ball && !is_hidden(where, all);
    if (const auto label = ball_label(p_RB, ball.radius, renderer, counts)) {
      labels.balls.push_back(*label);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_robot = i < scene.robots.size();
    const bool counts = distance_of(all[i].p_R) < reach.robot && !is_hidden(all[i], all);
    const auto label = foot_label(all[i], renderer, counts);
    if (label) (is_robot ? labels.robots : labels.people).push_back(*label);
  }
  return labels;
}

void add_floor_errors(const sim::Scene& scene,
                      const ImageLabels& labels,
                      const vision::FrameObservation& seen,
                      FloorErrors& errors) {
  const std::vector<Standing> all = standing_in(scene);
  std::vector<Eigen::Vector2d> feet;
  for (const ObstacleSighting& obstacle : seen.obstacles) feet.push_back(obstacle.p_RO.vector());
  for (std::size_t i = 0; i < scene.robots.size() && i < labels.robots.size(); ++i) {
    if (labels.robots[i].counts) add_nearest(foot_of(all[i]).vector(), feet, errors.robots);
  }
  for (std::size_t i = 0; i < scene.balls.size() && i < labels.balls.size(); ++i) {
    if (!labels.balls[i].counts) continue;
    std::vector<Eigen::Vector2d> places;
    for (const BallRay& ball : seen.balls) {
      const auto place = vision::meet_plane(ball.ray_R, scene.balls[i].radius);
      if (place) places.push_back(place->vector());
    }
    const Point3<Robot> p_RB = ball_in(scene, scene.balls[i]);
    add_nearest({p_RB.x, p_RB.y}, places, errors.balls);
  }
}

}  // namespace teamsight::tools
