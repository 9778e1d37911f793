// vision/camera_parameters.hpp: one robot's eye as numbers; made from a camera file by settings/.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace teamsight::vision {

/// The Bayer formats are named by their first two pixels of the first two rows.
enum class PixelFormat : std::uint8_t {
  kBgr,
  kYuyv,
  kUyvy,
  kGrey,
  kNv12,
  kBayerRggb,
  kBayerBggr,
  kBayerGrbg,
  kBayerGbrg,
};

/// One measured ring around the robot: the floor at `distance` appears at `radius_px`.
struct RingMark {
  double radius_px{0.0};  ///< from the image centre
  double distance{0.0};   ///< m on the floor, from the robot's centre
  double sigma_px{0.5};   ///< of radius_px

  friend bool operator==(const RingMark&, const RingMark&) = default;
};

/// A mirror known by the rings seen in it; rows by growing radius and distance.
struct RadialTable {
  double centre_u_px{0.0};    ///< column; 0 is the middle of the first pixel
  double centre_v_px{0.0};    ///< row
  double mirror_height{0.0};  ///< of the virtual viewpoint over the floor; m
  std::vector<RingMark> rows;
  double head_roll{0.0};   ///< of camera and mirror, about R's x axis through the viewpoint; rad
  double head_pitch{0.0};  ///< about R's y axis; rad

  friend bool operator==(const RadialTable&, const RadialTable&) = default;
};

/// A point of the mirror's meridian: distance from the axis, height over the pinhole; m.
struct ProfilePoint {
  double x{0.0};
  double y{0.0};

  friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
};

/// A mirror of known shape above a pinhole camera that looks up.
struct ProfileMirror {
  double focal_x_px{0.0};
  double focal_y_px{0.0};
  double centre_u_px{0.0};
  double centre_v_px{0.0};
  std::vector<ProfilePoint> profile;  ///< by growing x, from the axis outwards
  double pinhole_height{0.0};         ///< over the floor; m
  std::array<double, 3> offset_C{};   ///< of the mirror's apex against its design place, in C; m
  std::array<double, 2> tilt_C{};     ///< of the mirror about C's x and y axes; rad
  double head_roll{0.0};              ///< of camera and mirror together, about R's x axis; rad
  double head_pitch{0.0};             ///< about R's y axis; rad

  friend bool operator==(const ProfileMirror&, const ProfileMirror&) = default;
};

enum class ColourClass : std::uint8_t {
  kNone,
  kGreen,
  kBall,
  kBlue,
  kYellow,
  kMagenta,
  kCyan,
  kRed,
  kWhite,
  kBlack,
};

/// What one colour looks like in this camera: a disc in the chroma plane (BT.601, 8 bits).
struct ColourSample {
  ColourClass colour{ColourClass::kNone};
  std::uint8_t u{128};
  std::uint8_t v{128};
  std::uint8_t radius{20};

  friend bool operator==(const ColourSample&, const ColourSample&) = default;
};

/// What one colour looks like in any light: a range of hues, given as directions in the chroma
/// plane (from u up, counter-clockwise to v up: blue 0, red 90 degrees, yellow 180), beyond a
/// distance from grey.
struct HueSector {
  ColourClass colour{ColourClass::kNone};
  double from{0.0};  ///< rad
  double to{0.0};    ///< rad; counter-clockwise from `from`
  std::uint8_t min_chroma{12};
  std::uint8_t max_chroma{255};

  friend bool operator==(const HueSector&, const HueSector&) = default;
};

/// A pixel's colour: luminance and chroma, BT.601 full range.
struct SampledColour {
  std::uint8_t y{0};
  std::uint8_t u{128};
  std::uint8_t v{128};

  friend bool operator==(const SampledColour&, const SampledColour&) = default;
};

/// The two colours every field has.
struct FieldColours {
  SampledColour green;  ///< median of the carpet
  SampledColour white;  ///< median of the paint

  friend bool operator==(const FieldColours&, const FieldColours&) = default;
};

/// Classes of a ClassTable: six bits each of luminance, u and v.
inline constexpr std::size_t kClassCells = std::size_t{1} << 18U;

/// The class of every colour, learnt from samples; kClassCells of them, in the order of class_cell.
using ClassTable = std::vector<ColourClass>;

[[nodiscard]] constexpr std::size_t class_cell(const SampledColour& colour) {
  return std::size_t{colour.y} >> 2U << 12U | std::size_t{colour.u} >> 2U << 6U | colour.v >> 2U;
}

/// A plane through colour space: a colour is bright where the weighted sum of its red, green and
/// blue exceeds the threshold.
struct CubePlane {
  double red{0.0};  ///< weights
  double green{0.0};
  double blue{0.0};
  double threshold{0.0};  ///< grey levels

  friend bool operator==(const CubePlane&, const CubePlane&) = default;
};

/// The founding paper's eight colours: which of the RGB cube's vertices a colour is nearest to, and
/// what that one shows.
struct CubeParameters {
  /// Along the cube's red, green and blue axis, in any linear combination of the sensor's.
  std::array<CubePlane, 3> planes{};
  /// By vertex: 1 red, 2 green, 4 blue, and their sums; kNone: shows nothing that matters.
  std::array<ColourClass, 8> classes{};

  friend bool operator==(const CubeParameters&, const CubeParameters&) = default;
};

/// What says a colour's class.
enum class ColourMethod : std::uint8_t {
  kSamples,  ///< discs in the chroma plane, then hue sectors
  kTable,    ///< a trained table over luminance and chroma
  kCube,     ///< the nearest vertex of the RGB cube
};

struct ColourParameters {
  std::uint8_t white_min_y{160};
  std::uint8_t black_max_y{40};
  std::vector<ColourSample> samples;
  std::vector<HueSector> sectors;  ///< asked where no sample's disc reaches; the first one counts
  ClassTable table;                ///< empty: there is none
  std::optional<CubeParameters> cube;
  /// Nothing: the table if there is one, else samples and sectors.
  std::optional<ColourMethod> method;
  /// Of a ball that has several: at least two, each once, none of them kGreen or kNone. Empty: no
  /// such ball is looked for.
  std::vector<ColourClass> pattern;
  /// What the field looked like when all these were chosen; nothing: nobody has said so.
  std::optional<FieldColours> light;

  friend bool operator==(const ColourParameters&, const ColourParameters&) = default;
};

/// Which of them says a colour's class; the others are not asked.
[[nodiscard]] inline ColourMethod method_of(const ColourParameters& colours) {
  return colours.method.value_or(colours.table.empty() ? ColourMethod::kSamples
                                                       : ColourMethod::kTable);
}

/// Whether anything may be of this class; kWhite and kBlack are not asked for, they follow from
/// luminance where they have no vertex.
[[nodiscard]] inline bool can_tell(const ColourParameters& colours, ColourClass colour) {
  switch (method_of(colours)) {
    case ColourMethod::kTable:
      return std::ranges::find(colours.table, colour) != colours.table.end();
    case ColourMethod::kCube:
      return colours.cube.has_value() &&
             std::ranges::find(colours.cube->classes, colour) != colours.cube->classes.end();
    case ColourMethod::kSamples:
      break;
  }
  return std::ranges::find(colours.samples, colour, &ColourSample::colour) !=
             colours.samples.end() ||
         std::ranges::find(colours.sectors, colour, &HueSector::colour) != colours.sectors.end();
}

/// Image directions in which the camera sees only its own robot; counter-clockwise from image
/// right as one looks at the picture; rad; from `from` counter-clockwise to `to`.
struct MaskedSector {
  double from{0.0};
  double to{0.0};

  friend bool operator==(const MaskedSector&, const MaskedSector&) = default;
};

/// A corner of a window in the image; px.
struct Corner {
  double u{0.0};
  double v{0.0};

  friend bool operator==(const Corner&, const Corner&) = default;
};

/// A closed polygon in the image; need not be convex.
using Polygon = std::vector<Corner>;

/// What never shows the world.
struct Mask {
  double inner_radius_px{0.0};
  double outer_radius_px{1e9};
  std::vector<MaskedSector> sectors;
  std::vector<Polygon> polygons;  ///< own body, or whatever else is always there

  friend bool operator==(const Mask&, const Mask&) = default;
};

struct ScanPattern {
  std::uint16_t rays{360};
  double max_distance{8.0};   ///< m
  double min_contrast{18.0};  ///< of a line against the floor, grey levels
  std::uint16_t chroma_window{
      3};  ///< samples along a radial line that share their mean chroma; odd

  friend bool operator==(const ScanPattern&, const ScanPattern&) = default;
};

/// What a calibration may turn in a camera, each counted from what the camera file says.
enum class CameraKnob : std::uint8_t {
  kCentreU,  ///< px
  kCentreV,
  kFocal,    ///< share of both focal lengths
  kOffsetX,  ///< of the mirror in C; m
  kOffsetY,
  kOffsetZ,
  kTiltX,  ///< of the mirror about C's axes; rad
  kTiltY,
  kHeadRoll,  ///< rad
  kHeadPitch,
  kHeight,   ///< of the pinhole; m
  kRadial0,  ///< shares of a radial table's radii: Chebyshev polynomials over the radius
  kRadial1,
  kRadial2,
  kRadial3,
  kRadial4,
};

/// How well a calibration knew the camera.
struct CalibrationRecord {
  std::vector<CameraKnob> knobs;  ///< at most kMaxCameraKnobs, none twice
  std::vector<double> cov;        ///< of the knobs, row by row, in their units squared
  double residual_px{0.0};        ///< median distance of the line points from the paint
  std::uint32_t views{0};         ///< images it was made from

  friend bool operator==(const CalibrationRecord&, const CalibrationRecord&) = default;
};

inline constexpr int kMaxCameraKnobs = 12;

/// What a virtual sensor answers; the first five are the founding paper's.
enum class SensorKind : std::uint8_t {
  kBumper,       ///< an obstacle near the robot: enough of the colours in the windows
  kGoal,         ///< a goal: enough of the colours in the windows
  kBall,         ///< a ball somewhere in the windows
  kKick,         ///< the ball lies where it can be kicked: its centre is in the windows
  kCalibration,  ///< the camera sees its own lens where it should: the dark disc's middle is inside
  kColour,       ///< any further one: enough of the colours in the windows
};

/// One virtual sensor: windows of the image and what is looked for in them.
struct SensorWindows {
  std::string name;  ///< at most 23 characters, unique
  SensorKind kind{SensorKind::kColour};
  std::vector<ColourClass> colours;  ///< not asked by kBall, kKick and kCalibration
  std::vector<Polygon> windows;
  double threshold{0.2};  ///< of the value, from which the sensor triggers

  friend bool operator==(const SensorWindows&, const SensorWindows&) = default;
};

/// Everything the vision must know of one camera.
struct CameraParameters {
  std::string name;
  std::uint32_t width_px{0};
  std::uint32_t height_px{0};
  PixelFormat format{PixelFormat::kBgr};
  std::variant<RadialTable, ProfileMirror> mirror;
  double forward{0.0};   ///< image direction of R's x axis, counter-clockwise from image right; rad
  bool mirrored{false};  ///< R's left lies clockwise from forward in the picture
  ColourParameters colours;
  Mask mask;
  ScanPattern scan;
  std::optional<CalibrationRecord> calibration;  ///< nothing: how well it is known is not known
  std::vector<SensorWindows> sensors;

  friend bool operator==(const CameraParameters&, const CameraParameters&) = default;
};

}  // namespace teamsight::vision
