// settings/camera_parts.cpp: colours, windows and sensors of a camera file.
#include "settings/camera_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "settings/camera_names.hpp"
#include "settings/class_table_file.hpp"
#include "settings/colour_cube_part.hpp"

namespace teamsight::settings {

namespace {

using config::CameraFile;
using vision::SensorKind;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::size_t kLongestName = 23;  // of idl/teamsight.idl
constexpr int kMostSensors = 24;          // of idl/teamsight.idl

std::uint8_t byte(std::uint32_t value) {
  return static_cast<std::uint8_t>(value);  // in range, says the schema
}

vision::ColourSample sample_of(const TextFile& text, const CameraFile::Colours& file, int i) {
  const auto& sample = file.sample(i);
  const std::string key = "colours." + key_of("sample", i);
  for (int j = 0; j < i; ++j) {
    if (file.sample(j).u() != sample.u() || file.sample(j).v() != sample.v()) continue;
    throw text.error(
        key, "the same u and v as in sample[" + std::to_string(j) + "]", "each (u, v) once");
  }
  const auto colour = class_of(sample.class_());
  if (colour == vision::ColourClass::kWhite || colour == vision::ColourClass::kBlack) {
    throw text.error(key + ".class", "WHITE or BLACK", "a colour; those two follow from luminance");
  }
  return {colour, byte(sample.u()), byte(sample.v()), byte(sample.radius())};
}

vision::HueSector sector_of(const TextFile& text, const CameraFile::Colours& file, int i) {
  const auto& hue = file.hue(i);
  const std::string key = "colours." + key_of("hue", i);
  const double extent = hue.to_deg() - hue.from_deg();
  if (extent <= 0.0 || extent > 360.0) {
    throw text.error(
        key + ".to_deg", text_of(hue.to_deg()), "more than from_deg, by at most a full turn");
  }
  if (hue.max_chroma() <= hue.min_chroma()) {
    throw text.error(key + ".max_chroma",
                     std::to_string(hue.max_chroma()),
                     "more than min_chroma, " + std::to_string(hue.min_chroma()));
  }
  return {class_of(hue.class_()),
          kDegree * hue.from_deg(),
          kDegree * hue.to_deg(),
          byte(hue.min_chroma()),
          byte(hue.max_chroma())};
}

vision::SampledColour look_of(const CameraFile::Colours::Look& file) {
  return {byte(file.y()), byte(file.u()), byte(file.v())};
}

// Paint that is no brighter than the carpet is no paint.
vision::FieldColours light_of(const TextFile& text, const CameraFile::Colours::Light& file) {
  if (file.white().y() <= file.green().y()) {
    throw text.error("colours.light.white.y",
                     std::to_string(file.white().y()),
                     "more than green's, " + std::to_string(file.green().y()));
  }
  return {look_of(file.green()), look_of(file.white())};
}

void write_look(const vision::SampledColour& colour, CameraFile::Colours::Look& out) {
  out.set_y(colour.y);
  out.set_u(colour.u);
  out.set_v(colour.v);
}

// A method needs what it asks, and a cube that nothing asks is a slip of the pen.
void check_method(const TextFile& text, const CameraFile::Colours& file) {
  using Colours = CameraFile::Colours;
  if (file.method() == Colours::TABLE && !file.has_table()) {
    throw text.error("colours.method", "TABLE without a table", "colours.table beside it");
  }
  if (file.method() == Colours::CUBE && !file.has_cube()) {
    throw text.error("colours.method", "CUBE without a cube", "colours.cube beside it");
  }
  if (file.has_cube() && !file.has_method()) {
    throw text.error("colours.cube", "a cube, but no method", "colours.method: CUBE, or another");
  }
}

void check_pattern(const TextFile& text,
                   const CameraFile::Colours& file,
                   const vision::ColourParameters& colours) {
  constexpr std::size_t kFewest = 2;
  for (std::size_t i = 0; i < colours.pattern.size(); ++i) {
    const vision::ColourClass colour = colours.pattern[i];
    const auto written = file.pattern().class_(static_cast<int>(i));
    const std::string name =
        CameraFile::Colours::Class_Name(static_cast<CameraFile::Colours::Class>(written));
    const std::string key = "colours.pattern." + key_of("class", static_cast<int>(i));
    const auto before = colours.pattern.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(colours.pattern.begin(), before, colour) != before) {
      throw text.error(key, name + " again", "each class of the ball once");
    }
    if (colour == vision::ColourClass::kGreen) {
      throw text.error(key, name, "a class that the carpet has not");
    }
    const bool is_grey =
        colour == vision::ColourClass::kWhite || colour == vision::ColourClass::kBlack;
    if (!is_grey && !can_tell(colours, colour)) {
      throw text.error(
          key, name + ", which no colour is of", "a class that a sample, hue, table or cube names");
    }
  }
  if (file.has_pattern() && colours.pattern.size() < kFewest) {
    throw text.error("colours.pattern",
                     std::to_string(colours.pattern.size()) + " of the ball's classes",
                     "at least 2, such as `class: WHITE class: BLACK`; a ball of one colour is "
                     "told by samples of class BALL");
  }
}

bool asks_for_colours(SensorKind kind) {
  return kind == SensorKind::kBumper || kind == SensorKind::kGoal || kind == SensorKind::kColour;
}

vision::SensorWindows sensor_of(const TextFile& text, const CameraFile& file, int i) {
  const auto& source = file.sensor(i);
  const std::string key = key_of("sensor", i);
  vision::SensorWindows sensor;
  sensor.name = source.name();
  sensor.kind = kind_of(source.kind());
  sensor.threshold = source.threshold();
  for (const int colour : source.colour()) {
    sensor.colours.push_back(class_of(static_cast<CameraFile::Colours::Class>(colour)));
  }
  for (int j = 0; j < source.window_size(); ++j) {
    sensor.windows.push_back(polygon_of(text, key + "." + key_of("window", j), source.window(j)));
  }
  if (sensor.name.empty() || sensor.name.size() > kLongestName) {
    throw text.error(key + ".name", sensor.name, "1 to 23 characters");
  }
  if (sensor.windows.empty()) throw text.error(key + ".window", "no window", "at least one");
  if (asks_for_colours(sensor.kind) == sensor.colours.empty()) {
    throw text.error(key + ".colour",
                     std::to_string(sensor.colours.size()) + " colours",
                     "some for BUMPER, GOAL and COLOUR, none for the other kinds");
  }
  return sensor;
}

}  // namespace

vision::ColourParameters colours_of(const TextFile& text, const CameraFile::Colours& file) {
  if (file.black_max_y() >= file.white_min_y()) {
    throw text.error("colours.black_max_y",
                     std::to_string(file.black_max_y()),
                     "less than white_min_y, " + std::to_string(file.white_min_y()));
  }
  vision::ColourParameters colours;
  colours.white_min_y = byte(file.white_min_y());
  colours.black_max_y = byte(file.black_max_y());
  for (int i = 0; i < file.sample_size(); ++i) {
    colours.samples.push_back(sample_of(text, file, i));
  }
  for (int i = 0; i < file.hue_size(); ++i) colours.sectors.push_back(sector_of(text, file, i));
  if (file.has_table()) {
    colours.table = read_class_table(text.resolve("colours.table", file.table()));
  }
  if (file.has_cube()) colours.cube = cube_of(text, file.cube());
  if (file.has_method()) colours.method = method_of(file.method());
  check_method(text, file);
  for (const int colour : file.pattern().class_()) {
    colours.pattern.push_back(class_of(static_cast<CameraFile::Colours::Class>(colour)));
  }
  check_pattern(text, file, colours);
  if (file.has_light()) colours.light = light_of(text, file.light());
  return colours;
}

vision::Polygon polygon_of(const TextFile& text,
                           const std::string& key,
                           const CameraFile::Polygon& file) {
  constexpr int kFewestCorners = 3;
  if (file.corner_size() < kFewestCorners) {
    throw text.error(
        key + ".corner", std::to_string(file.corner_size()) + " corners", "at least 3");
  }
  vision::Polygon polygon;
  for (const auto& corner : file.corner()) polygon.push_back({corner.u_px(), corner.v_px()});
  return polygon;
}

std::vector<vision::SensorWindows> sensors_of(const TextFile& text, const CameraFile& file) {
  if (file.sensor_size() > kMostSensors) {
    throw text.error("sensor", std::to_string(file.sensor_size()) + " sensors", "at most 24");
  }
  std::vector<vision::SensorWindows> sensors;
  for (int i = 0; i < file.sensor_size(); ++i) {
    vision::SensorWindows sensor = sensor_of(text, file, i);
    if (std::ranges::find(sensors, sensor.name, &vision::SensorWindows::name) != sensors.end()) {
      throw text.error(key_of("sensor", i) + ".name", sensor.name, "each name once");
    }
    sensors.push_back(std::move(sensor));
  }
  return sensors;
}

void write_colours(const vision::ColourParameters& colours, CameraFile::Colours& out) {
  out.set_white_min_y(colours.white_min_y);
  out.set_black_max_y(colours.black_max_y);
  for (const vision::ColourSample& sample : colours.samples) {
    const auto colour = file_class_of(sample.colour);
    if (!colour) continue;
    auto& line = *out.add_sample();
    line.set_class_(*colour);
    line.set_u(sample.u);
    line.set_v(sample.v);
    line.set_radius(sample.radius);
  }
  for (const vision::HueSector& sector : colours.sectors) {
    const auto colour = file_class_of(sector.colour);
    if (!colour) continue;
    auto& line = *out.add_hue();
    line.set_class_(*colour);
    line.set_from_deg(sector.from / kDegree);
    line.set_to_deg(sector.to / kDegree);
    line.set_min_chroma(sector.min_chroma);
    line.set_max_chroma(sector.max_chroma);
  }
  if (colours.method) out.set_method(file_method_of(*colours.method));
  if (colours.cube) write_cube(*colours.cube, *out.mutable_cube());
  for (const vision::ColourClass colour : colours.pattern) {
    if (const auto name = file_class_of(colour)) out.mutable_pattern()->add_class_(*name);
  }
  if (colours.light) {
    write_look(colours.light->green, *out.mutable_light()->mutable_green());
    write_look(colours.light->white, *out.mutable_light()->mutable_white());
  }
}

void write_polygon(const vision::Polygon& polygon, CameraFile::Polygon& out) {
  for (const vision::Corner& corner : polygon) {
    auto& line = *out.add_corner();
    line.set_u_px(corner.u);
    line.set_v_px(corner.v);
  }
}

void write_sensor(const vision::SensorWindows& sensor, CameraFile::Sensor& out) {
  out.set_name(sensor.name);
  out.set_kind(file_kind_of(sensor.kind));
  out.set_threshold(sensor.threshold);
  for (const vision::ColourClass colour : sensor.colours) {
    if (const auto name = file_class_of(colour)) out.add_colour(*name);
  }
  for (const vision::Polygon& window : sensor.windows) write_polygon(window, *out.add_window());
}

}  // namespace teamsight::settings
