// tests/realdata/vision_detect_test.cpp: what `teamsight score detect` finds must not get worse.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace teamsight {
namespace {

namespace fs = std::filesystem;

// What it found when this was written, of 58 balls, 74 robots and 44 people.
constexpr int kBallsFound = 55;
constexpr int kBallsFalse = 1;
constexpr int kRobotsFound = 67;
constexpr int kRobotsFalse = 2;
constexpr int kPeopleFound = 29;
constexpr int kLegsFalse = 29;
// The same in 21 other lights together.
constexpr int kBallsFoundInLights = 1083;
constexpr int kBallsFalseInLights = 103;
constexpr int kRobotsFoundInLights = 1349;
constexpr int kRobotsFalseInLights = 142;

std::string variable(const char* name, const std::string& otherwise) {
  // A test has one thread when it reads its environment.
  // NOLINTNEXTLINE(concurrency-mt-unsafe)
  const char* value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

fs::path source_dir() {
  return variable("TEAMSIGHT_SOURCE_DIR", fs::current_path().string());
}

fs::path data_dir() {
  return variable("TEAMSIGHT_DATA", (source_dir() / ".." / "shared" / "data").string());
}

/// The last line of the command's output, which sums up all images.
nlohmann::json score_of_all(const std::string& option) {
  const std::string command =
      variable("TEAMSIGHT_BIN_DIR", "build/release/bin") + "/teamsight score detect --data '" +
      data_dir().string() + "' --cameras '" +
      (source_dir() / "tests/realdata/cameras.txt").string() + "' " + option;
  // The command is made of this test's own paths.
  // NOLINTNEXTLINE(cert-env33-c)
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string output;
  std::array<char, 4096> part{};
  while (pipe && fgets(part.data(), part.size(), pipe.get()) != nullptr) output += part.data();
  std::istringstream lines(output);
  std::string last;
  for (std::string line; std::getline(lines, line);) last = line;
  return nlohmann::json::parse(last, nullptr, false);
}

TEST(LabelledImages, AreReadAtLeastAsWellAsBefore) {
  if (!fs::exists(data_dir() / "labels.json")) {
    std::cerr << "\n*** NO REAL DATA: no labels.json in " << data_dir() << " ***\n";
    GTEST_SKIP() << "no real data in " << data_dir();
  }

  const nlohmann::json score = score_of_all("");

  ASSERT_FALSE(score.is_discarded());
  std::cout << score.dump() << '\n';
  EXPECT_GE(score.at("balls").at("found"), kBallsFound);
  EXPECT_LE(score.at("balls").at("false_on_carpet"), kBallsFalse);
  EXPECT_GE(score.at("robots").at("found"), kRobotsFound);
  EXPECT_LE(score.at("robots").at("false_on_carpet"), kRobotsFalse);
  EXPECT_GE(score.at("people").at("found"), kPeopleFound);
  EXPECT_LE(score.at("people").at("false_on_carpet"), kLegsFalse);
}

TEST(LabelledImages, AreReadAtLeastAsWellAsBeforeInOtherLight) {
  if (!fs::exists(data_dir() / "labels.json")) {
    GTEST_SKIP() << "no real data in " << data_dir();
  }

  const nlohmann::json score = score_of_all("--lights");

  ASSERT_FALSE(score.is_discarded());
  std::cout << score.dump() << '\n';
  EXPECT_GE(score.at("balls").at("found"), kBallsFoundInLights);
  EXPECT_LE(score.at("balls").at("false_on_carpet"), kBallsFalseInLights);
  EXPECT_GE(score.at("robots").at("found"), kRobotsFoundInLights);
  EXPECT_LE(score.at("robots").at("false_on_carpet"), kRobotsFalseInLights);
}

}  // namespace
}  // namespace teamsight
