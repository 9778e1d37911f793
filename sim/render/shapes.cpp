// sim/render/shapes.cpp: see shapes.hpp.
#include "sim/render/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::sim {
namespace {

// Share of a pixel of width `pixel` whose middle lies `inside` an edge (negative: outside).
inline float share_inside(float inside, float pixel) {
  return std::clamp(0.5F + inside / pixel, 0.0F, 1.0F);
}

// Share of a pixel at `place` that lies between two edges.
inline float share_between(float place, float low, float high, float pixel) {
  return share_inside(high - place, pixel) - share_inside(low - place, pixel);
}

// Light comes from above and a little from one side of the hall, so that round things look round.
float lit(float across, float up) {
  return 0.78F + 0.2F * across + 0.35F * up;
}

// A sight against a vertical axis: how far it passes aside, and where.
struct Passing {
  float aside{0.0F};  // signed, to the left as one looks; m
  float along{0.0F};  // horizontal way to the nearest point; m
  float flat{0.0F};   // horizontal share of the direction
};

Passing pass(const Sight& sight, float x, float y) {
  const float flat = std::max(sight.flat, 1e-6F);
  const float ex = sight.direction_x / flat;
  const float ey = sight.direction_y / flat;
  const float dx = x - sight.origin_x;
  const float dy = y - sight.origin_y;
  return {ex * dy - ey * dx, ex * dx + ey * dy, flat};
}

Light shaded(const Light& light, float by) {
  Light result = light * by;
  result[3] = 1.0F;
  return result;
}

// What a pixel of that width, a share of the ball's radius, shows of its paints.
Light painted(const Sphere& ball, const Eigen::Vector3f& normal_R, float pixel) {
  Light light = light_of(ball.paint);
  if (ball.pattern == BallPattern::kPlain) return light;
  const float depth = depth_in_panels(ball.pattern, ball.turn_R.conjugate() * normal_R);
  lay_over(light, light_of(ball.panels), share_inside(depth, pixel));
  return light;
}

}  // namespace

void paint_cylinder(Canvas& canvas, const Sights& sights, const Cylinder& cylinder) {
  const auto x = static_cast<float>(cylinder.p_R.x);
  const auto y = static_cast<float>(cylinder.p_R.y);
  const auto radius = static_cast<float>(cylinder.radius);
  const auto low = static_cast<float>(cylinder.low);
  const auto high = static_cast<float>(cylinder.high);
  const Light side = light_of(cylinder.side);
  const Light lid = light_of(cylinder.lid);
  sights.visit_sector(x, y, radius + 0.05F, [&](const Sight& sight) {
    const Passing passing = pass(sight, x, y);
    const float sideways = std::max(sight.width * passing.along / passing.flat, 1e-5F);
    const float across = share_between(passing.aside, -radius, radius, sideways);
    if (passing.flat < 1e-3F || across <= 0.0F || passing.along <= -radius) {
      return;
    }
    const float half_chord =
        std::sqrt(std::max(radius * radius - passing.aside * passing.aside, 0.0F));
    const float rise = sight.direction_z / passing.flat;
    const float near = passing.along - half_chord;
    const float far = passing.along + half_chord;
    const float range = std::max(near, 0.02F) / passing.flat;
    // One pixel up or down moves the sight so much on an upright surface.
    const float upright = std::max(sight.height * range / passing.flat, 1e-5F);
    const float z_near = sight.origin_z + near * rise;
    const float front = near > 0.0F ? share_between(z_near, low, high, upright) : 0.0F;
    float top = 0.0F;
    if (rise < 0.0F && sight.origin_z > high) {
      const float there = (high - sight.origin_z) / rise;  // horizontal way to the lid's plane
      const float level = std::max(upright / -rise, 1e-5F);
      top = share_between(there, near, far, level);
    }
    const float total = std::min(front + top, 1.0F);
    if (total <= 0.0F) {
      return;
    }
    const float turn = std::clamp(passing.aside / radius, -1.0F, 1.0F);
    const float facing = std::sqrt(1.0F - turn * turn);
    const Light seen = (shaded(side, lit(0.4F * turn, 0.3F * facing)) * front +
                        shaded(lid, lit(0.0F, 0.9F)) * top) /
                       (front + top);
    lay_over(canvas[sight.pixel], seen, across * total);
  });
}

void paint_ball(Canvas& canvas, const Sights& sights, const Sphere& ball) {
  const Eigen::Vector3f centre = ball.p_R.vector().cast<float>();
  const auto r = static_cast<float>(ball.radius);
  const Light gloss(0.5F, 0.5F, 0.5F, 0.0F);
  sights.visit_sector(centre.x(), centre.y(), r + 0.05F, [&](const Sight& sight) {
    const Eigen::Vector3f origin(sight.origin_x, sight.origin_y, sight.origin_z);
    const Eigen::Vector3f direction(sight.direction_x, sight.direction_y, sight.direction_z);
    const Eigen::Vector3f way = centre - origin;
    const float along = way.dot(direction);
    if (along <= 0.0F) {
      return;
    }
    const Eigen::Vector3f off = along * direction - way;  // from the centre to the sight
    const float miss = off.norm();
    const float flat = std::max(direction.head<2>().norm(), 1e-6F);
    const Eigen::Vector3f side(-direction.y() / flat, direction.x() / flat, 0.0F);
    const float sideways = miss > 1e-6F ? off.dot(side) / miss : 1.0F;
    const float pixel =
        along * std::sqrt(sideways * sideways * sight.width * sight.width +
                          (1.0F - sideways * sideways) * sight.height * sight.height);
    const float share = share_between(miss, -r, r, pixel);
    if (share <= 0.0F) {
      return;
    }
    const float depth = std::sqrt(std::max(r * r - miss * miss, 0.0F));
    const Eigen::Vector3f normal = (off - depth * direction) / r;
    const float shine = std::max(normal.z() + 0.25F * normal.x(), 0.0F);
    const float glint = std::pow(std::min(shine, 1.0F), 40.0F);
    Light seen =
        shaded(painted(ball, normal, pixel / r), 0.55F + 0.5F * std::max(normal.z(), -0.5F)) +
        glint * gloss;
    seen[3] = 1.0F;
    lay_over(canvas[sight.pixel], seen, share);
  });
}

void paint_panel(Canvas& canvas, const Sights& sights, const Panel& panel) {
  const Eigen::Vector2f from = panel.from.vector().cast<float>();
  const Eigen::Vector2f to = panel.to.vector().cast<float>();
  const Eigen::Vector2f middle = 0.5F * (from + to);
  const float length = (to - from).norm();
  const Eigen::Vector2f along = (to - from) / length;
  const Eigen::Vector2f normal(-along.y(), along.x());
  const auto low = static_cast<float>(panel.low);
  const auto high = static_cast<float>(panel.high);
  const Light light = light_of(panel.paint);
  const auto share = static_cast<float>(panel.share);
  sights.visit_sector(middle.x(), middle.y(), 0.5F * length + 0.05F, [&](const Sight& sight) {
    const Eigen::Vector2f origin(sight.origin_x, sight.origin_y);
    const Eigen::Vector2f direction(sight.direction_x, sight.direction_y);
    const float closing = direction.dot(normal);
    if (std::abs(closing) < 1e-4F) {
      return;
    }
    const float t = (from - origin).dot(normal) / closing;
    if (t <= 0.0F) {
      return;
    }
    const float flat = sight.flat;
    const float upright = std::max(sight.height * t / flat, 1e-5F);
    const float z = sight.origin_z + t * sight.direction_z;
    if (z > high + upright || z < low - upright) {
      return;  // most sights in its sector pass above or below
    }
    const float place = (origin + t * direction - from).dot(along);
    const float slant = std::max(std::abs(closing) / flat, 0.05F);
    const float across =
        share_between(place, 0.0F, length, std::max(sight.width * t / slant, 1e-5F));
    const float total = across * share_between(z, low, high, upright);
    if (total > 0.0F) {
      lay_over(canvas[sight.pixel], shaded(light, lit(0.1F, 0.25F * slant)), share * total);
    }
  });
}

void shade_floor(Canvas& canvas, const Sights& sights, const Point<Robot>& p_R, double radius) {
  constexpr float kFade = 0.12F;  // m
  constexpr float kDark = 0.45F;
  const auto x = static_cast<float>(p_R.x);
  const auto y = static_cast<float>(p_R.y);
  const auto r = static_cast<float>(radius);
  const float widest = r + 3.0F * kFade;
  const float reach = std::hypot(x, y) + widest;
  const auto darken = [&](const Sight& sight) {
    const float dx = sight.floor_x - x;
    const float dy = sight.floor_y - y;
    const float square = dx * dx + dy * dy;
    if (square < widest * widest) {
      const float distance = std::sqrt(square);
      const float dark = kDark * std::exp(-std::max(distance - r, 0.0F) / kFade);
      Light& light = canvas[sight.pixel];
      light.head<3>() *= 1.0F - dark;
    }
  };
  sights.visit_sector(x, y, widest, darken, reach);
}

}  // namespace teamsight::sim
