// settings/robot_file.cpp: robot, team and match files.
#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "config.pb.h"
#include "settings/load.hpp"
#include "settings/text_format.hpp"

namespace teamsight::settings {

namespace {

StartSide side_of(config::RobotFile::StartSide side) {
  switch (side) {
    case config::RobotFile::OWN_HALF:
      return StartSide::kOwnHalf;
    case config::RobotFile::OPPONENT_HALF:
      return StartSide::kOpponentHalf;
    case config::RobotFile::UNKNOWN:
      break;
  }
  return StartSide::kUnknown;
}

vision::ColourClass colour_of(config::TeamFile::Shirt shirt) {
  switch (shirt) {
    case config::TeamFile::CYAN:
      return vision::ColourClass::kCyan;
    case config::TeamFile::MAGENTA:
      return vision::ColourClass::kMagenta;
    case config::TeamFile::BLUE:
      return vision::ColourClass::kBlue;
    case config::TeamFile::RED:
      return vision::ColourClass::kRed;
  }
  return vision::ColourClass::kNone;
}

vision::TeamShirts shirts_in(const TextFile& text, const config::TeamFile& file) {
  vision::TeamShirts shirts;
  if (file.has_shirt()) shirts.own = colour_of(file.shirt());
  if (file.has_opponent_shirt()) shirts.theirs = colour_of(file.opponent_shirt());
  if (file.has_shirt() && shirts.own == shirts.theirs) {
    throw text.error("opponent_shirt",
                     config::TeamFile::Shirt_Name(file.opponent_shirt()) + ", the own colour",
                     "another than shirt");
  }
  return shirts;
}

template <class File>
std::vector<RobotId> robots_in(const TextFile& text, const File& file) {
  std::vector<RobotId> robots;
  for (int i = 0; i < file.robot_size(); ++i) {
    const auto id = static_cast<RobotId>(file.robot(i));
    if (std::ranges::find(robots, id) != robots.end()) {
      throw text.error(key_of("robot", i), std::to_string(id) + " again", "each robot once");
    }
    robots.push_back(id);
  }
  return robots;
}

std::string listed(const std::vector<RobotId>& robots) {
  std::string all;
  for (const RobotId robot : robots) all += (all.empty() ? "" : ", ") + std::to_string(robot);
  return all;
}

}  // namespace

TeamSettings load_team(const std::filesystem::path& path) {
  config::TeamFile file;
  const TextFile text = TextFile::read(path, file);
  TeamSettings team;
  team.name = file.name();
  team.field = text.resolve("field", file.field());
  team.domain_id = file.domain_id();
  team.dds_profile = text.resolve("dds_profile", file.dds_profile());
  team.host_profile = text.resolve("host_profile", file.host_profile());
  if (file.has_security()) team.security = text.resolve_folder("security", file.security());
  team.ball_radius = file.ball_radius_m();
  team.robot_radius = file.robot_radius_m();
  team.robots = robots_in(text, file);
  team.shirts = shirts_in(text, file);
  return team;
}

RobotSettings load_robot(const std::filesystem::path& path) {
  config::RobotFile file;
  const TextFile text = TextFile::read(path, file);
  RobotSettings robot;
  robot.id = static_cast<RobotId>(file.id());
  const std::filesystem::path team_path = text.resolve("team", file.team());
  robot.team = load_team(team_path);
  const std::vector<RobotId>& team = robot.team.robots;
  if (!team.empty() && std::ranges::find(team, robot.id) == team.end()) {
    throw text.error("id",
                     std::to_string(robot.id),
                     "one of the robots that " + team_path.string() + " lists: " + listed(team));
  }
  robot.camera = text.resolve("camera", file.camera());
  robot.strength = static_cast<std::uint16_t>(file.strength());
  robot.start_side = side_of(file.start_side());
  return robot;
}

namespace {

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

PictureSettings picture_of(const config::MatchFile::Picture& file) {
  PictureSettings picture;
  picture.samples_per_axis = static_cast<int>(file.samples_per_axis());
  picture.moments = static_cast<int>(file.moments());
  picture.exposure = file.exposure_ms() / 1000.0;
  picture.gain = file.gain();
  picture.red_gain = file.red_gain();
  picture.green_gain = file.green_gain();
  picture.blue_gain = file.blue_gain();
  picture.vignetting = file.vignetting();
  picture.defocus_px = file.defocus_px();
  picture.rim_defocus_px = file.rim_defocus_px();
  picture.unevenness = file.unevenness();
  picture.defect_seed = file.defect_seed();
  for (const auto& part : file.body()) picture.body.push_back({part.radius_m(), part.height_m()});
  for (const auto& strut : file.strut()) {
    picture.struts.push_back({radians(strut.direction_deg()), radians(strut.half_width_deg())});
  }
  return picture;
}

BallPaintSettings::Rgb rgb_of(const config::MatchFile::Ball::Rgb& file) {
  return {static_cast<std::uint8_t>(file.red()),
          static_cast<std::uint8_t>(file.green()),
          static_cast<std::uint8_t>(file.blue())};
}

BallPaintSettings ball_of(const TextFile& text, const config::MatchFile::Ball& file) {
  using File = config::MatchFile::Ball;
  BallPaintSettings ball;
  if (file.has_paint()) ball.paint = rgb_of(file.paint());
  if (file.has_panels()) ball.panels = rgb_of(file.panels());
  if (file.pattern() == File::FOOTBALL) ball.pattern = BallPaintSettings::Pattern::kFootball;
  if (file.pattern() == File::OCTANTS) ball.pattern = BallPaintSettings::Pattern::kOctants;
  if (file.has_panels() && file.pattern() == File::PLAIN) {
    throw text.error("ball.panels", "panels of a plain ball", "ball.pattern: FOOTBALL or OCTANTS");
  }
  return ball;
}

}  // namespace

MatchSettings load_match(const std::filesystem::path& path) {
  config::MatchFile file;
  const TextFile text = TextFile::read(path, file);
  MatchSettings match;
  match.field = text.resolve("field", file.field());
  match.camera = text.resolve("camera", file.camera());
  if (file.has_team()) match.team = load_team(text.resolve("team", file.team()));
  match.robots = robots_in(text, file);
  if (match.robots.empty()) throw text.error("robot", "no robot", "the id of at least one robot");
  match.opponents = file.opponents();
  match.seed = file.seed();
  match.frame_rate_hz = file.frame_rate_hz();
  match.pixel_noise_sigma = file.pixel_noise_sigma();
  match.scenario = file.scenario();
  match.picture = picture_of(file.picture());
  match.ball = ball_of(text, file.ball());
  return match;
}

}  // namespace teamsight::settings
