// sim/render/renderer.cpp: see renderer.hpp.
#include "sim/render/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/angle.hpp"
#include "geometry/expect.hpp"

namespace teamsight::sim {
namespace {

constexpr Paint kHolder{14, 13, 15};  // what is beside the mirror, and its struts
constexpr Paint kBlack{24, 23, 25};
constexpr Paint kMetal{92, 94, 98};
constexpr Paint kSkin{196, 150, 126};
constexpr Paint kNet{210, 210, 210};
constexpr double kNetShare = 0.2;     // of what is behind that a net hides
constexpr double kPostRadius = 0.06;  // m
constexpr float kHidden = 0.995F;

Paint goal_paint(GoalColour colour) {
  switch (colour) {
    case GoalColour::kBlue:
      return {30, 60, 200};
    case GoalColour::kYellow:
      return {230, 210, 30};
    default:
      return {230, 230, 230};
  }
}

Pose<Field, Robot> moved(const Scene& scene, double seconds) {
  return {scene.X_FR.x() + seconds * scene.v_FR.x,
          scene.X_FR.y() + seconds * scene.v_FR.y,
          scene.X_FR.theta() + seconds * scene.omega};
}

// Where the i-th of robots, balls and people is, so long after the middle of the exposure.
Point3<Field> place_of(const Scene& scene, std::size_t i, double seconds) {
  const std::size_t robots = scene.robots.size();
  const std::size_t balls = scene.balls.size();
  if (i < robots) {
    const SceneRobot& robot = scene.robots[i];
    return {robot.p_F.x + seconds * robot.v_F.x, robot.p_F.y + seconds * robot.v_F.y, 0.0};
  }
  if (i < robots + balls) {
    const SceneBall& ball = scene.balls[i - robots];
    return Point3<Field>::from(ball.p_FB.vector() + seconds * ball.v_FB.vector());
  }
  const Point<Field>& p_F = scene.people[i - robots - balls].p_F;
  return {p_F.x, p_F.y, 0.0};
}

Eigen::Quaternionf turn_in(const Pose<Robot, Field>& X_RF, const BallLook& look) {
  const Eigen::AngleAxisd about(X_RF.theta(), Eigen::Vector3d::UnitZ());
  return (about * look.turn_F).cast<float>();
}

}  // namespace

Renderer::Renderer(const vision::CameraParameters& camera,
                   const FieldModel& field,
                   const PictureParameters& parameters,
                   std::shared_ptr<const FloorTexture> floor)
    : camera_(camera),
      parameters_(parameters),
      optics_(camera),
      sights_(optics_, camera.width_px, camera.height_px, parameters.fineness),
      floor_(floor ? std::move(floor)
                   : std::make_shared<const FloorTexture>(
                         field, parameters.unevenness, parameters.hall_seed)),
      hall_(field, parameters.hall_seed),
      sensor_(parameters.sensor, camera, optics_.centre()),
      fine_(std::size_t{sights_.width()} * sights_.height(), Light(0.0F, 0.0F, 0.0F, 1.0F)) {
  TEAMSIGHT_EXPECT(parameters.fineness >= 1 && parameters.fineness <= 8);
  TEAMSIGHT_EXPECT(parameters.moments >= 1);
  make_overlay();
  make_floor_views();
  for (const Wall& wall : field.walls) {
    panels_.push_back({wall.from, wall.to, {{}, {}, 0.0, wall.height, {225, 225, 225}, 1.0}});
  }
  for (const Goal& goal : field.goals) {
    add_goal(goal, field.centre);
  }
}

// Own body, struts and what is beside the mirror never change: they are drawn once.
void Renderer::make_overlay() {
  Canvas overlay(fine_.size(), Light(0.0F, 0.0F, 0.0F, 0.0F));
  std::vector<bool> is_seen(fine_.size(), false);
  for (const Sight& sight : sights_.all()) {
    is_seen[sight.pixel] = true;
  }
  for (const BodyPart& part : parameters_.body) {
    paint_cylinder(
        overlay, sights_, {{0.0, 0.0}, part.radius, 0.0, part.height, part.side, part.lid});
  }
  const Light holder = light_of(kHolder);
  for (std::size_t pixel = 0; pixel < overlay.size(); ++pixel) {
    if (!is_seen[pixel]) {
      overlay[pixel] = holder;
    }
  }
  add_struts(overlay);
  std::vector<bool> hidden(overlay.size(), false);
  for (std::uint32_t pixel = 0; pixel < overlay.size(); ++pixel) {
    hidden[pixel] = overlay[pixel][3] > kHidden;
    if (hidden[pixel]) {
      fine_[pixel] = overlay[pixel];
    } else if (overlay[pixel][3] > 0.0F) {
      overlay_.push_back({pixel, overlay[pixel]});
    }
  }
  sights_.forget(hidden);
}

// Rods close to the lens: wedges with edges as soft as their lack of focus makes them.
void Renderer::add_struts(Canvas& overlay) const {
  constexpr double kSoft = 3.0;  // px
  const Light holder = light_of(kHolder);
  for (std::size_t pixel = 0; pixel < overlay.size() && !parameters_.struts.empty(); ++pixel) {
    const std::size_t column = pixel % sights_.width();
    const std::size_t row = pixel / sights_.width();
    const double n = parameters_.fineness;
    const double du = (static_cast<double>(column) + 0.5) / n - 0.5 - optics_.centre().u;
    const double dv = (static_cast<double>(row) + 0.5) / n - 0.5 - optics_.centre().v;
    const double radius = std::hypot(du, dv);
    for (const Strut& strut : parameters_.struts) {
      const double off = std::abs(angle_difference(std::atan2(-dv, du), strut.direction));
      const double inside = (strut.half_width - off) * radius;
      lay_over(
          overlay[pixel], holder, static_cast<float>(std::clamp(0.5 + inside / kSoft, 0.0, 1.0)));
    }
  }
}

// A pixel's patch of floor is as long along the line of sight as its height makes it: where it is
// longer than wide, several samples in a row.
void Renderer::make_floor_views() {
  for (const Sight& sight : sights_.all()) {
    FloorView view;
    view.pixel = sight.pixel;
    view.x = sight.floor_x;
    view.y = sight.floor_y;
    if (sight.sees_floor()) {
      const float range = sight.origin_z / -sight.direction_z;
      const float across = std::max(range * sight.width, 1e-4F);
      const float along = std::max(range * sight.height / -sight.direction_z, across);
      const double level =
          std::round(std::log2(static_cast<double>(across) / FloorTexture::kFinest));
      view.level = static_cast<std::uint8_t>(std::clamp(level, 0.0, FloorTexture::kLevels - 1.0));
      const float square = static_cast<float>(FloorTexture::kFinest * std::exp2(view.level));
      view.samples = static_cast<std::uint8_t>(
          std::clamp(std::lround(along / std::max(square, across)), 1L, 16L));
      const float step = along / static_cast<float>(view.samples) / std::max(sight.flat, 1e-6F);
      view.step_x = step * sight.direction_x;
      view.step_y = step * sight.direction_y;
      const float before = -0.5F * static_cast<float>(view.samples - 1);
      view.x += before * view.step_x;
      view.y += before * view.step_y;
    }
    floor_views_.push_back(view);
  }
}

void Renderer::add_goal(const Goal& goal, const Point<Field>& centre) {
  const Eigen::Vector2d left = goal.left_post.vector();
  const Eigen::Vector2d right = goal.right_post.vector();
  Eigen::Vector2d back(-(right - left).y(), (right - left).x());
  back *= goal.depth / std::max(back.norm(), 1e-6);
  if (back.dot(left - centre.vector()) < 0.0) {
    back = -back;
  }
  const bool is_solid = goal.colour == GoalColour::kBlue || goal.colour == GoalColour::kYellow;
  const Paint frame = goal_paint(goal.colour);
  const Paint net = is_solid ? frame : kNet;
  const double share = is_solid ? 1.0 : kNetShare;
  const auto add = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Panel& shape) {
    panels_.push_back({Point<Field>::from(from), Point<Field>::from(to), shape});
  };
  if (goal.depth > 0.0) {
    add(left + back, right + back, {{}, {}, 0.0, goal.height, net, share});
    add(left, left + back, {{}, {}, 0.0, goal.height, net, share});
    add(right, right + back, {{}, {}, 0.0, goal.height, net, share});
  }
  add(left, right, {{}, {}, goal.height - kPostRadius, goal.height + kPostRadius, frame, 1.0});
  posts_.push_back({goal.left_post, goal.height, frame});
  posts_.push_back({goal.right_post, goal.height, frame});
}

void Renderer::draw(const Scene& scene, Random& random, std::vector<std::uint8_t>& out) {
  if (parameters_.fineness == 1 && parameters_.moments == 1) {
    paint_moment(scene, 0.0);
    sensor_.develop(fine_, random, out);
    return;
  }
  light_.assign(std::size_t{camera_.width_px} * camera_.height_px, Light(0.0F, 0.0F, 0.0F, 0.0F));
  for (int i = 0; i < parameters_.moments; ++i) {
    const double share = (i + 0.5) / parameters_.moments - 0.5;
    paint_moment(scene, share * parameters_.exposure);
    add_moment();
  }
  sensor_.develop(light_, random, out);
}

// The mean of a pixel's fine pixels, and of the moments.
void Renderer::add_moment() {
  const auto n = static_cast<std::size_t>(parameters_.fineness);
  const float share = 1.0F / static_cast<float>(n * n) / static_cast<float>(parameters_.moments);
  const auto add_row = [&](const Light* from, Light* to) {
    for (std::size_t i = 0; i < sights_.width(); ++i) {
      to[i / n] += share * from[i];
    }
  };
  for (std::size_t row = 0; row < sights_.height(); ++row) {
    add_row(fine_.data() + row * sights_.width(), light_.data() + row / n * camera_.width_px);
  }
}

void Renderer::paint_moment(const Scene& scene, double seconds) {
  const Pose<Field, Robot> X_FR = moved(scene, seconds);
  paint_ground(X_FR);
  paint_standing(scene, X_FR, seconds);
  for (const Covered& covered : overlay_) {
    Light& light = fine_[covered.pixel];
    light = (1.0F - covered.light[3]) * light + covered.light;
  }
}

void Renderer::paint_ground(const Pose<Field, Robot>& X_FR) {
  const Turn turn{static_cast<float>(std::cos(X_FR.theta())),
                  static_cast<float>(std::sin(X_FR.theta())),
                  static_cast<float>(X_FR.x()),
                  static_cast<float>(X_FR.y())};
  const Light carpet = light_of(parameters_.carpet);
  const Light line = light_of(parameters_.line) - carpet;
  const std::span<const Sight> sights = sights_.all();
  for (std::size_t i = 0; i < floor_views_.size(); ++i) {
    const FloorView& view = floor_views_[i];
    FloorTexture::Sum floor;
    if (view.samples > 0) {
      floor = floor_->sum_of({turn.x + turn.c * view.x - turn.s * view.y,
                              turn.y + turn.s * view.x + turn.c * view.y,
                              turn.c * view.step_x - turn.s * view.step_y,
                              turn.s * view.step_x + turn.c * view.step_y,
                              view.samples},
                             view.level);
    }
    Light sum = floor.brightness * carpet + floor.painted * line;
    const int all = std::max<int>(view.samples, 1);
    if (floor.on_carpet < all) {
      sum += static_cast<float>(all - floor.on_carpet) * beyond_carpet(sights[i], turn);
    }
    fine_[view.pixel] = all == 1 ? sum : Light(sum / static_cast<float>(all));
  }
}

Light Renderer::beyond_carpet(const Sight& sight, const Turn& turn) const {
  const Eigen::Vector3f origin(turn.x + turn.c * sight.origin_x - turn.s * sight.origin_y,
                               turn.y + turn.s * sight.origin_x + turn.c * sight.origin_y,
                               sight.origin_z);
  const Eigen::Vector3f direction(turn.c * sight.direction_x - turn.s * sight.direction_y,
                                  turn.s * sight.direction_x + turn.c * sight.direction_y,
                                  sight.direction_z);
  return hall_.look(origin, direction, sight.height);
}

void Renderer::paint_fixed(const Pose<Robot, Field>& X_RF) {
  for (const FieldPanel& panel : panels_) {
    Panel shape = panel.shape;
    shape.from = X_RF * panel.from;
    shape.to = X_RF * panel.to;
    paint_panel(fine_, sights_, shape);
  }
  for (const FieldPost& post : posts_) {
    paint_cylinder(
        fine_, sights_, {X_RF * post.p_F, kPostRadius, 0.0, post.height, post.paint, post.paint});
  }
}

// From far to near: what is nearer is painted over what is behind it.
void Renderer::paint_standing(const Scene& scene, const Pose<Field, Robot>& X_FR, double seconds) {
  const Pose<Robot, Field> X_RF = X_FR.inverse();
  paint_fixed(X_RF);
  const std::size_t robots = scene.robots.size();
  const std::size_t balls = scene.balls.size();
  order_.clear();
  for (std::size_t i = 0; i < robots + balls + scene.people.size(); ++i) {
    const Point3<Robot> p_R = X_RF * place_of(scene, i, seconds);
    order_.emplace_back(-std::hypot(p_R.x, p_R.y), i);
    if (i < robots || p_R.z < 0.2) {
      shade_floor(fine_, sights_, p_R.on_floor(), i < robots ? scene.robots[i].radius : 0.06);
    }
  }
  std::sort(order_.begin(), order_.end());
  for (const auto& [distance, i] : order_) {
    const Point3<Robot> p_R = X_RF * place_of(scene, i, seconds);
    if (i < robots) {
      paint_robot(scene.robots[i], p_R.on_floor());
    } else if (i < robots + balls) {
      const SceneBall& ball = scene.balls[i - robots];
      const BallLook& look = ball.look;
      paint_ball(fine_,
                 sights_,
                 {p_R, ball.radius, look.paint, look.pattern, look.panels, turn_in(X_RF, look)});
    } else {
      paint_person(scene.people[i - robots - balls], p_R.on_floor());
    }
  }
}

// A black base with wheels, a shirt around the electronics, a thin tower and the mirror.
void Renderer::paint_robot(const SceneRobot& robot, const Point<Robot>& p_R) {
  const double h = robot.height;
  const double r = robot.radius;
  paint_cylinder(fine_, sights_, {p_R, r, 0.02, 0.4 * h, kBlack, kMetal});
  if (robot.markers) paint_markers(*robot.markers, r, p_R);
  paint_cylinder(fine_, sights_, {p_R, 0.8 * r, 0.38 * h, 0.75 * h, robot.shirt, kBlack});
  paint_cylinder(fine_, sights_, {p_R, 0.2 * r, 0.7 * h, 0.93 * h, kBlack, kBlack});
  paint_cylinder(fine_, sights_, {p_R, 0.35 * r, 0.92 * h, h, kBlack, kBlack});
}

void Renderer::paint_markers(const Paint& paint, double radius, const Point<Robot>& p_R) {
  constexpr double kHalf = 0.05;  // m
  constexpr double kApart = 0.7;  // rad
  const double towards_eye = std::atan2(-p_R.y, -p_R.x);
  for (const double aside : {-kApart, 0.0, kApart}) {
    const double side = towards_eye + aside;
    const double out = radius - kHalf + 0.005;  // they show in front of the base
    const Point<Robot> middle{p_R.x + out * std::cos(side), p_R.y + out * std::sin(side)};
    paint_cylinder(fine_, sights_, {middle, kHalf, 0.05, 0.15, paint, paint});
  }
}

void Renderer::paint_person(const ScenePerson& person, const Point<Robot>& p_R) {
  for (const double side : {-0.11, 0.11}) {
    const Point<Robot> leg{p_R.x, p_R.y + side};
    paint_cylinder(fine_, sights_, {leg, 0.08, 0.0, 0.9, person.trousers, person.trousers});
  }
  paint_cylinder(fine_, sights_, {p_R, 0.2, 0.85, 1.45, person.shirt, person.shirt});
  paint_cylinder(fine_, sights_, {p_R, 0.1, 1.45, 1.75, kSkin, kBlack});
}

}  // namespace teamsight::sim
