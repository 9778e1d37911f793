// sim/render/hall.cpp: see hall.hpp.
#include "sim/render/hall.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/match/random.hpp"

namespace teamsight::sim {
namespace {

constexpr double kSquare = 0.05;  // of the walls' picture; m
constexpr double kHeight = 4.5;   // of the walls; m
constexpr int kRows = 90;
constexpr float kBoards = 0.18F;  // height of the boards; m
constexpr float kNever = 1e9F;
constexpr Paint kBoard{34, 33, 36};
constexpr Paint kFloor{112, 98, 84};

}  // namespace

Hall::Hall(const FieldModel& field, std::uint32_t seed) {
  Random random(seed);
  const Eigen::Vector2f centre = field.centre.vector().cast<float>();
  const Eigen::Vector2f half(static_cast<float>(field.length / 2.0 + field.surround),
                             static_cast<float>(field.width / 2.0 + field.surround));
  carpet_ = {centre - half, centre + half};
  const auto gap = [&random] {
    return static_cast<float>(random.uniform(1.2, 4.0));
  };
  hall_ = {carpet_.low - Eigen::Vector2f(gap(), gap()),
           carpet_.high + Eigen::Vector2f(gap(), gap())};
  const Eigen::Vector2f size = hall_.high - hall_.low;
  columns_ = static_cast<int>(std::ceil(2.0 * static_cast<double>(size.sum()) / kSquare));
  furnish(seed + 1);
}

void Hall::fill(double from, double to, double low, double high, const Paint& paint) {
  const int first = std::max(static_cast<int>(low / kSquare), 0);
  const int last = std::min(static_cast<int>(high / kSquare), kRows);
  for (int row = first; row < last; ++row) {
    for (int column = static_cast<int>(from / kSquare); column < static_cast<int>(to / kSquare);
         ++column) {
      walls_[index_of(column % columns_, row)] = paint;
    }
  }
}

void Hall::furnish(std::uint32_t seed) {
  Random random(seed);
  const std::array<Paint, 4> plaster{
      Paint{176, 178, 174}, {158, 156, 146}, {186, 182, 170}, {140, 146, 152}};
  walls_.assign(index_of(0, kRows), plaster[random.below(4)]);
  const double around = columns_ * kSquare;
  for (double along = 0.0; along < around;) {
    const double width = random.uniform(0.5, 3.0);
    const double end = std::min(along + width, around);
    const auto shade = static_cast<std::uint8_t>(random.uniform(20.0, 120.0));
    switch (random.below(8)) {
      case 0:  // a window
        fill(along, end, 1.0, 2.4, {236, 240, 244});
        break;
      case 1:  // a wooden door
        fill(along, std::min(end, along + 1.0), 0.0, 2.1, {150, 112, 62});
        break;
      case 2:  // a cupboard
        fill(along, end, 0.0, 1.8, {shade, shade, static_cast<std::uint8_t>(shade + 8)});
        break;
      case 3:  // a bench with bags
        fill(along, end, 0.3, 0.5, {92, 74, 56});
        fill(along + 0.2, along + 0.5, 0.5, 0.8, {shade, 40, 52});
        break;
      case 4:  // a spectator
        fill(along, along + 0.4, 0.0, 0.85, {38, 40, 58});
        fill(along - 0.0,
             along + 0.45,
             0.85,
             1.45,
             {shade, static_cast<std::uint8_t>(140 - shade), 90});
        fill(along + 0.1, along + 0.3, 1.45, 1.7, {190, 150, 128});
        break;
      case 5:  // another wall
        fill(along, end, 0.0, kHeight, plaster[random.below(4)]);
        break;
      case 6:  // tables, cables and monitors
        fill(along, end, 0.65, 0.75, {170, 168, 160});
        fill(along + 0.1, end - 0.1, 0.0, 0.65, {52, 52, 56});
        fill(along + 0.1, along + 0.5, 0.75, 1.1, {24, 26, 30});
        break;
      default:
        break;
    }
    along = end + random.uniform(0.0, 1.0);
  }
}

Hall::Exit Hall::leave(const Box& box,
                       const Eigen::Vector3f& origin,
                       const Eigen::Vector3f& direction) {
  std::array<float, 2> t{kNever, kNever};
  for (int axis = 0; axis < 2; ++axis) {
    const float speed = direction[axis];
    if (std::abs(speed) > 1e-6F) {
      const float wall = speed > 0.0F ? box.high[axis] : box.low[axis];
      t[static_cast<std::size_t>(axis)] = (wall - origin[axis]) / speed;
    }
  }
  const bool through_x = t[0] < t[1];
  const float first = through_x ? t[0] : t[1];
  const Eigen::Vector2f size = box.high - box.low;
  const Eigen::Vector2f p =
      origin.head<2>() + first * direction.head<2>() - box.low;  // from the box' low corner
  // Around the box: along y = 0, up x = max, back along y = max, down x = 0.
  if (through_x) {
    return {first,
            direction.x() > 0.0F ? size.x() + p.y() : 2.0F * size.x() + 2.0F * size.y() - p.y()};
  }
  return {first, direction.y() > 0.0F ? 2.0F * size.x() + size.y() - p.x() : p.x()};
}

Light Hall::wall(float along, float z) const {
  const int column =
      std::clamp(static_cast<int>(along / static_cast<float>(kSquare)), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>(z / static_cast<float>(kSquare)), 0, kRows - 1);
  return light_of(walls_[index_of(column, row)]);
}

// Dark, with rows of lamps.
Light Hall::ceiling(const Eigen::Vector3f& p_F) {
  const float across = p_F.y() - 3.0F * std::floor(p_F.y() / 3.0F);
  const float along = p_F.x() - 2.0F * std::floor(p_F.x() / 2.0F);
  const bool is_lamp = across < 0.25F && along < 1.5F;
  return is_lamp ? Light(1.6F, 1.6F, 1.5F, 1.0F) : light_of({70, 70, 74});
}

Light Hall::look(const Eigen::Vector3f& origin_F,
                 const Eigen::Vector3f& direction_F,
                 float pixel_height) const {
  const Exit out = leave(hall_, origin_F, direction_F);
  const float z = origin_F.z() + out.t * direction_F.z();
  const float flat = direction_F.head<2>().norm();
  const auto share_below = [&](float edge, float height, float t) {
    return std::clamp(
        0.5F + (edge - height) * flat / std::max(pixel_height * t, 1e-6F), 0.0F, 1.0F);
  };
  Light seen(0.0F, 0.0F, 0.0F, 1.0F);
  const float rise = std::max(direction_F.z(), 1e-6F);
  if (out.t <= 0.0F || flat < 1e-3F) {
    seen = light_of(kFloor);
  } else if (z > static_cast<float>(kHeight)) {
    seen = ceiling(origin_F + direction_F * ((static_cast<float>(kHeight) - origin_F.z()) / rise));
  } else {
    seen = wall(out.along, z);
    lay_over(seen, light_of(kFloor), share_below(0.0F, z, out.t));
  }
  const Exit carpet = leave(carpet_, origin_F, direction_F);
  if (carpet.t > 0.0F) {
    const float height = origin_F.z() + carpet.t * direction_F.z();
    const float share =
        share_below(kBoards, height, carpet.t) - share_below(0.0F, height, carpet.t);
    lay_over(seen, light_of(kBoard), share);
  }
  return seen;
}

}  // namespace teamsight::sim
