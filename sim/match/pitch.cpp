// sim/match/pitch.cpp: see pitch.hpp.
#include "sim/match/pitch.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::sim {
namespace {

constexpr double kBoards = 0.5;  // share of its speed that boards leave a ball
constexpr double kPosts = 0.6;
constexpr double kOuterNet = 0.3;
constexpr double kInnerNet = 0.05;

// A ball whose coordinate passed a limit is set back to it and keeps a share of its speed.
void throw_back(double& place, double& speed, double limit, double share) {
  if (std::abs(place) > limit) {
    const double side = place > 0.0 ? 1.0 : -1.0;
    place = side * limit;
    speed = -share * side * std::abs(speed);
  }
}

}  // namespace

Eigen::Vector3d Pitch::Net::local(const Eigen::Vector3d& vector, bool is_point) const {
  const Eigen::Vector2d flat =
      is_point ? Eigen::Vector2d(vector.head<2>() - middle) : Eigen::Vector2d(vector.head<2>());
  const Eigen::Vector2d sideways(-outwards.y(), outwards.x());
  return {flat.dot(outwards), flat.dot(sideways), vector.z()};
}

Eigen::Vector3d Pitch::Net::global(const Eigen::Vector3d& local, bool is_point) const {
  const Eigen::Vector2d sideways(-outwards.y(), outwards.x());
  const Eigen::Vector2d flat = local.x() * outwards + local.y() * sideways;
  const Eigen::Vector2d from = is_point ? middle : Eigen::Vector2d(0.0, 0.0);
  return {flat.x() + from.x(), flat.y() + from.y(), local.z()};
}

Pitch::Pitch(const FieldModel& field)
    : half_length_(field.length / 2.0),
      half_width_(field.width / 2.0),
      surround_(field.surround),
      centre_(field.centre) {
  for (const Goal& goal : field.goals) {
    const Eigen::Vector2d left = goal.left_post.vector();
    const Eigen::Vector2d right = goal.right_post.vector();
    const Eigen::Vector2d along = right - left;
    Net net;
    net.middle = (left + right) / 2.0;
    net.outwards = Eigen::Vector2d(-along.y(), along.x()).normalized();
    if (net.outwards.dot(net.middle - centre_.vector()) < 0.0) {
      net.outwards = -net.outwards;
    }
    net.half_width = along.norm() / 2.0;
    net.depth = goal.depth;
    net.height = goal.height;
    nets_.push_back(net);
  }
}

bool Pitch::is_inside(const Point<Field>& p_F, double margin) const {
  return std::abs(p_F.x - centre_.x) <= half_length_ - margin &&
         std::abs(p_F.y - centre_.y) <= half_width_ - margin;
}

Point<Field> Pitch::clamped(const Point<Field>& p_F, double margin) const {
  const double x = half_length_ - margin;
  const double y = half_width_ - margin;
  return {std::clamp(p_F.x, centre_.x - x, centre_.x + x),
          std::clamp(p_F.y, centre_.y - y, centre_.y + y)};
}

Ball Pitch::kept(const Point3<Field>& before, Ball ball, double radius) const {
  for (const Net& net : nets_) {
    meet_net(net, before, ball, radius);
  }
  meet_boards(ball, radius);
  return ball;
}

void Pitch::meet_boards(Ball& ball, double radius) const {
  double x = ball.p_FB.x - centre_.x;
  double y = ball.p_FB.y - centre_.y;
  throw_back(x, ball.v_FB.x, half_length_ + surround_ - radius, kBoards);
  throw_back(y, ball.v_FB.y, half_width_ + surround_ - radius, kBoards);
  ball.p_FB.x = centre_.x + x;
  ball.p_FB.y = centre_.y + y;
}

void Pitch::meet_net(const Net& net, const Point3<Field>& before, Ball& ball, double radius) {
  const Eigen::Vector3d from = net.local(before.vector(), true);
  Eigen::Vector3d p = net.local(ball.p_FB.vector(), true);
  Eigen::Vector3d v = net.local(ball.v_FB.vector(), false);
  const auto is_within = [&](const Eigen::Vector3d& q, double more) {
    return q.x() > -more && q.x() < net.depth + more && std::abs(q.y()) < net.half_width + more &&
           q.z() < net.height + more;
  };
  const bool through_mouth =
      from.x() <= 0.0 && std::abs(p.y()) <= net.half_width - radius && p.z() <= net.height - radius;
  const bool enters = (is_within(p, radius) && !is_within(from, radius)) ||
                      (is_within(p, 0.0) && !is_within(from, 0.0));
  if (is_within(from, 0.0)) {
    if (p.x() > net.depth - radius) {
      p.x() = net.depth - radius;
      v *= kInnerNet;
    }
    throw_back(p.y(), v.y(), net.half_width - radius, kInnerNet);
    p.z() = std::min(p.z(), std::max(net.height - radius, radius));
  } else if (enters && !through_mouth) {
    // From the field it is a post or the bar; from elsewhere the outside of the net.
    v *= from.x() <= 0.0 ? -kPosts : -kOuterNet;
    p = from;
  } else {
    return;
  }
  ball.p_FB = Point3<Field>::from(net.global(p, true));
  const Eigen::Vector3d v_F = net.global(v, false);
  ball.v_FB = {v_F.x(), v_F.y(), v_F.z()};
}

}  // namespace teamsight::sim
