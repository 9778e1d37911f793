// settings/camera_names.cpp: one table per enumeration, read in both directions.
#include "settings/camera_names.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/expect.hpp"

namespace teamsight::settings {

namespace {

using config::CameraFile;
using Colours = CameraFile::Colours;
using vision::ColourClass;
using vision::PixelFormat;
using vision::SensorKind;

constexpr std::array kFormats{std::pair{CameraFile::BGR, PixelFormat::kBgr},
                              std::pair{CameraFile::YUYV, PixelFormat::kYuyv},
                              std::pair{CameraFile::UYVY, PixelFormat::kUyvy},
                              std::pair{CameraFile::GREY, PixelFormat::kGrey},
                              std::pair{CameraFile::NV12, PixelFormat::kNv12},
                              std::pair{CameraFile::BAYER_RGGB, PixelFormat::kBayerRggb},
                              std::pair{CameraFile::BAYER_BGGR, PixelFormat::kBayerBggr},
                              std::pair{CameraFile::BAYER_GRBG, PixelFormat::kBayerGrbg},
                              std::pair{CameraFile::BAYER_GBRG, PixelFormat::kBayerGbrg}};

constexpr std::array kClasses{std::pair{Colours::GREEN, ColourClass::kGreen},
                              std::pair{Colours::BALL, ColourClass::kBall},
                              std::pair{Colours::BLUE, ColourClass::kBlue},
                              std::pair{Colours::YELLOW, ColourClass::kYellow},
                              std::pair{Colours::MAGENTA, ColourClass::kMagenta},
                              std::pair{Colours::CYAN, ColourClass::kCyan},
                              std::pair{Colours::RED, ColourClass::kRed},
                              std::pair{Colours::WHITE, ColourClass::kWhite},
                              std::pair{Colours::BLACK, ColourClass::kBlack}};

constexpr std::array kMethods{std::pair{Colours::SAMPLES, vision::ColourMethod::kSamples},
                              std::pair{Colours::TABLE, vision::ColourMethod::kTable},
                              std::pair{Colours::CUBE, vision::ColourMethod::kCube}};

constexpr std::array kKinds{std::pair{CameraFile::Sensor::BUMPER, SensorKind::kBumper},
                            std::pair{CameraFile::Sensor::GOAL, SensorKind::kGoal},
                            std::pair{CameraFile::Sensor::BALL, SensorKind::kBall},
                            std::pair{CameraFile::Sensor::KICK, SensorKind::kKick},
                            std::pair{CameraFile::Sensor::CALIBRATION, SensorKind::kCalibration},
                            std::pair{CameraFile::Sensor::COLOUR, SensorKind::kColour}};

// The other one of the pair that `known` stands in.
template <class Table, class Known>
auto inside_of(const Table& table, Known known) {
  const auto pair = std::ranges::find(table, known, [](const auto& p) { return p.first; });
  TEAMSIGHT_EXPECT(pair != table.end());
  return pair->second;
}

template <class Table, class Known>
auto outside_of(const Table& table, Known known) {
  const auto pair = std::ranges::find(table, known, [](const auto& p) { return p.second; });
  TEAMSIGHT_EXPECT(pair != table.end());
  return pair->first;
}

}  // namespace

PixelFormat format_of(CameraFile::PixelFormat format) {
  return inside_of(kFormats, format);
}

CameraFile::PixelFormat file_format_of(PixelFormat format) {
  return outside_of(kFormats, format);
}

ColourClass class_of(Colours::Class colour) {
  return inside_of(kClasses, colour);
}

std::optional<Colours::Class> file_class_of(ColourClass colour) {
  if (colour == ColourClass::kNone) return std::nullopt;
  return outside_of(kClasses, colour);
}

vision::ColourMethod method_of(Colours::Method method) {
  return inside_of(kMethods, method);
}

Colours::Method file_method_of(vision::ColourMethod method) {
  return outside_of(kMethods, method);
}

SensorKind kind_of(CameraFile::Sensor::Kind kind) {
  return inside_of(kKinds, kind);
}

CameraFile::Sensor::Kind file_kind_of(SensorKind kind) {
  return outside_of(kKinds, kind);
}

}  // namespace teamsight::settings
