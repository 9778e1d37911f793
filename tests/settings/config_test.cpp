// tests/settings/config_test.cpp: every file that is shipped under config/ loads.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "bus/profile.hpp"
#include "settings/load.hpp"
#include "settings/mirror_file.hpp"
#include "settings/profile_csv.hpp"

namespace teamsight::settings {
namespace {

namespace fs = std::filesystem;

fs::path config_folder() {
  const char* source = std::getenv("TEAMSIGHT_SOURCE_DIR");
  return fs::path(source ? source : ".") / "config";
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  return files;
}

// Loads a file by the folder it lies in; false for a kind that this test does not know.
bool load(const fs::path& path) {
  const std::string folder = path.parent_path().filename();
  const std::string extension = path.extension();
  if (path.filename() == "README.md") return true;
  if (folder == "dds" && extension == ".xml") return !bus::load_profile(path, "").text.empty();
  if (folder == "cameras" && extension == ".csv") return !read_profile(path).empty();
  if (extension != ".textproto") return false;
  if (folder == "fields") return !load_field(path).name.empty();
  if (folder == "cameras") return !load_camera(path).name.empty();
  if (folder == "mirrors") return !std::isnan(load_mirror(path).pixel_pitch.value_or(0.0));
  if (folder == "robots") return load_robot(path).id != kNobody;
  if (folder == "teams") return !load_team(path).name.empty();
  if (folder == "matches") return !load_match(path).robots.empty();
  return false;
}

TEST(Config, EveryFileLoads) {
  const std::vector<fs::path> files = files_in(config_folder());

  EXPECT_GT(files.size(), 10U) << "where is " << config_folder() << "?";
  for (const fs::path& path : files) {
    EXPECT_NO_THROW(EXPECT_TRUE(load(path)) << "unknown kind of file: " << path);
  }
}

TEST(Config, RobotsOfOneTeamDifferInIdAndStrength) {
  std::map<std::string, std::set<int>> ids;
  std::map<std::string, std::set<int>> strengths;

  for (const fs::path& path : files_in(config_folder() / "robots")) {
    const RobotSettings robot = load_robot(path);
    EXPECT_TRUE(ids[robot.team.name].insert(robot.id).second) << path;
    EXPECT_TRUE(strengths[robot.team.name].insert(robot.strength).second) << path;
  }
}

TEST(Config, TeamsDoNotShareADomain) {
  std::set<std::uint32_t> domains;

  for (const fs::path& path : files_in(config_folder() / "teams")) {
    EXPECT_TRUE(domains.insert(load_team(path).domain_id).second) << path;
  }
}

}  // namespace
}  // namespace teamsight::settings
