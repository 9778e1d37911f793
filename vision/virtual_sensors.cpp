// vision/virtual_sensors.cpp: counting colours in windows.
#include "vision/virtual_sensors.hpp"

#include <algorithm>
#include <cmath>

#include "vision/ball_detector.hpp"
#include "vision/polygon.hpp"

namespace teamsight::vision {

namespace {

constexpr double kMostPlaces =
    500.0;                       // per window, on a grid: its share is then known to some percent
constexpr double kAround = 2.0;  // of the window's size: where a displaced lens is looked for

struct Box {
  double left{0.0};
  double right{0.0};
  double top{0.0};
  double bottom{0.0};
};

Box box_of(const Polygon& polygon) {
  const auto [left, right] = std::ranges::minmax_element(polygon, {}, &Corner::u);
  const auto [top, bottom] = std::ranges::minmax_element(polygon, {}, &Corner::v);
  return {left->u, right->u, top->v, bottom->v};
}

Box grown(const Box& box, double factor) {
  const double u = 0.5 * (box.left + box.right);
  const double v = 0.5 * (box.top + box.bottom);
  const double half_width = 0.5 * factor * (box.right - box.left);
  const double half_height = 0.5 * factor * (box.bottom - box.top);
  return {u - half_width, u + half_width, v - half_height, v + half_height};
}

// Calls `visit(u, v)` on a grid of pixels in the box and the image.
template <class Visit>
void for_grid(const Box& box, std::uint32_t width, std::uint32_t height, Visit visit) {
  const double area = (box.right - box.left) * (box.bottom - box.top);
  const double step = std::max(1.0, std::sqrt(area / kMostPlaces));
  for (double v = std::max(0.0, std::ceil(box.top)); v <= box.bottom && v < height; v += step) {
    for (double u = std::max(0.0, std::ceil(box.left)); u <= box.right && u < width; u += step) {
      visit(std::floor(u), std::floor(v));
    }
  }
}

bool is_in_any(const std::vector<Polygon>& windows, const Corner& place) {
  return std::ranges::any_of(windows,
                             [&](const Polygon& window) { return is_inside(window, place); });
}

ColourClass class_at(const PixelReader& pixels, const ColourClasses& colours, std::size_t pixel) {
  return colours.of(pixels.luminance(pixel), pixels.chroma(pixel));
}

bool asks_for_balls(SensorKind kind) {
  return kind == SensorKind::kBall || kind == SensorKind::kKick;
}

}  // namespace

VirtualSensors::VirtualSensors(const std::vector<SensorWindows>& sensors,
                               std::uint32_t width_px,
                               std::uint32_t height_px)
    : sensors_(sensors) {
  for (const SensorWindows& sensor : sensors_) {
    places_.push_back(places_of(sensor, width_px, height_px));
    values_.push_back({sensor.name, 0.0, false});
  }
}

VirtualSensors::Places VirtualSensors::places_of(const SensorWindows& sensor,
                                                 std::uint32_t width_px,
                                                 std::uint32_t height_px) {
  Places places;
  for (const ColourClass colour : sensor.colours) {
    places.wanted |= 1U << static_cast<unsigned>(colour);
  }
  const bool looks_around = sensor.kind == SensorKind::kCalibration;
  for (const Polygon& window : sensor.windows) {
    const Box box = looks_around ? grown(box_of(window), kAround) : box_of(window);
    for_grid(box, width_px, height_px, [&](double u, double v) {
      const bool inside = is_inside(window, {u, v});
      if (!inside && !looks_around) return;
      auto& where = inside ? places.inside : places.around;
      where.push_back(static_cast<std::uint32_t>(v) * width_px + static_cast<std::uint32_t>(u));
    });
  }
  return places;
}

double VirtualSensors::value_of(std::size_t sensor,
                                const PixelReader& pixels,
                                const ColourClasses& colours,
                                std::span<const BallCandidate> balls) const {
  const SensorWindows& windows = sensors_[sensor];
  const Places& places = places_[sensor];
  if (asks_for_balls(windows.kind)) {
    double best = 0.0;
    for (const BallCandidate& ball : balls) {
      if (!is_in_any(windows.windows, {ball.pixels.u_px, ball.pixels.v_px})) continue;
      best = std::max(best, ball.ray.confidence);
    }
    return best;
  }
  const auto count = [&](const std::vector<std::uint32_t>& where, std::uint32_t wanted) {
    return static_cast<double>(std::ranges::count_if(where, [&](std::uint32_t pixel) {
      return (wanted >> static_cast<unsigned>(class_at(pixels, colours, pixel)) & 1U) != 0;
    }));
  };
  if (windows.kind == SensorKind::kCalibration) {
    constexpr auto kDark = 1U << static_cast<unsigned>(ColourClass::kBlack);
    const double inside = count(places.inside, kDark);
    const double all = inside + count(places.around, kDark);
    return all > 0.0 ? inside / all : 0.0;
  }
  if (places.inside.empty()) return 0.0;
  return count(places.inside, places.wanted) / static_cast<double>(places.inside.size());
}

std::span<const SensorValue> VirtualSensors::read(const PixelReader& pixels,
                                                  const ColourClasses& colours,
                                                  std::span<const BallCandidate> balls) {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    values_[i].value = value_of(i, pixels, colours, balls);
    values_[i].triggered = values_[i].value >= sensors_[i].threshold;
  }
  return values_;
}

}  // namespace teamsight::vision
