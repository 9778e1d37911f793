// settings/load.hpp: settings files in, checked parameters out. The only header others need.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/field_model.hpp"
#include "geometry/identity.hpp"
#include "settings/settings_error.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/team_shirts.hpp"

namespace teamsight::settings {

/// What the robots of a team have in common (config/teams). Paths are absolute; the files exist.
struct TeamSettings {
  std::string name;  ///< separates teams on one network
  std::filesystem::path field;
  std::uint32_t domain_id{0};          ///< of the domain between the robots
  std::filesystem::path dds_profile;   ///< Cyclone DDS XML for that domain
  std::filesystem::path host_profile;  ///< the same for the domain inside one computer
  std::filesystem::path security;      ///< folder of the speakers' folders; empty: security is off
  double ball_radius{0.11};            ///< m
  double robot_radius{0.25};           ///< m
  std::vector<RobotId> robots;         ///< its robots' ids; empty: any may play
  vision::TeamShirts shirts;           ///< what it and the others wear; kNone: not said
};

/// On which half a robot starts, where nothing else breaks the field's symmetry.
enum class StartSide : std::uint8_t { kUnknown, kOwnHalf, kOpponentHalf };

/// One robot (config/robots), which its team's list has, if there is one. Paths are absolute; the
/// files exist.
struct RobotSettings {
  RobotId id{kNobody};
  TeamSettings team;
  std::filesystem::path camera;
  std::uint16_t strength{0};  ///< the strongest fusion alive leads; different in every robot
  StartSide start_side{StartSide::kUnknown};
};

/// What makes a simulated camera a real one.
struct PictureSettings {
  /// A part of the robot's own body: an upright cylinder on its axis; m.
  struct Body {
    double radius{0.0};
    double height{0.0};
  };

  /// A rod that holds the mirror: a wedge in the picture, its direction counter-clockwise from
  /// image right; rad.
  struct Strut {
    double direction{0.0};
    double half_width{0.0};
  };

  int samples_per_axis{1};
  int moments{1};          ///< of the exposure that are drawn and averaged
  double exposure{0.005};  ///< s
  double gain{1.0};
  double red_gain{1.0};
  double green_gain{1.0};
  double blue_gain{1.0};
  double vignetting{0.3};        ///< share of the light that is lost at the corners
  double defocus_px{0.5};        ///< sigma in the middle
  double rim_defocus_px{0.75};   ///< sigma at the corners
  double unevenness{0.1};        ///< of the carpet's brightness
  std::uint32_t defect_seed{0};  ///< 0: every eye is as its camera file says
  std::vector<Body> body;        ///< empty: not said
  std::vector<Strut> struts;
};

/// What is painted on a simulated ball.
struct BallPaintSettings {
  /// Where the second colour is.
  enum class Pattern : std::uint8_t { kPlain, kFootball, kOctants };
  using Rgb = std::array<std::uint8_t, 3>;

  Rgb paint{240, 110, 20};
  Pattern pattern{Pattern::kPlain};
  Rgb panels{20, 20, 20};
};

/// A simulated match (config/matches). Paths are absolute; the files exist.
struct MatchSettings {
  std::filesystem::path field;
  std::filesystem::path camera;      ///< the same for every robot
  std::optional<TeamSettings> team;  ///< nothing: no odometry and no truth on the host domains
  std::vector<RobotId> robots;       ///< the own robots that play; no id twice, at least one
  std::uint32_t opponents{0};
  std::uint32_t seed{1};  ///< the same seed gives the same match
  double frame_rate_hz{15.0};
  double pixel_noise_sigma{3.0};  ///< grey levels
  std::string scenario;           ///< not checked: the simulator knows the names
  PictureSettings picture;
  BallPaintSettings ball;
};

/// Reads a field file and turns the rulebook's letters into lines, arcs, spots and goals.
///
/// @throws SettingsError, as all of these do: the file is unreadable or not in protobuf text
///         format, has an unknown or lacks a required key, or holds a value that makes no sense
[[nodiscard]] FieldModel load_field(const std::filesystem::path& path);

/// Reads a camera file and the files beside it that it names: a mirror's profile as CSV, and
/// trained colour classes.
[[nodiscard]] vision::CameraParameters load_camera(const std::filesystem::path& path);

/// Reads a robot file and its team file; field, camera and profiles are left to their readers.
[[nodiscard]] RobotSettings load_robot(const std::filesystem::path& path);

[[nodiscard]] TeamSettings load_team(const std::filesystem::path& path);

[[nodiscard]] MatchSettings load_match(const std::filesystem::path& path);

/// Writes a camera file that load_camera reads back; a profile goes into a CSV file beside it, and
/// trained colour classes into one of their own.
/// A reader sees the old file or the new one, never a part of it.
///
/// @param comment  where the numbers come from, for the head of the file; may have several lines
/// @throws SettingsError if a file cannot be written
void save_camera(const std::filesystem::path& path,
                 const vision::CameraParameters& camera,
                 const std::string& comment = {});

}  // namespace teamsight::settings
