// tests/sim/picture_book_test.cpp: the program that writes a match as image files with truth.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/process.hpp"

namespace teamsight::sim {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

class PictureBook : public testing::Test {
 protected:
  // Half a second of a match at 4 Hz: two pages for each of two robots.
  [[nodiscard]] test::ChildProcess write(const std::string& lines = {},
                                         const std::vector<std::string>& options = {}) const {
    const auto config = test::source_path("config").string();
    const auto match = folder_.write(
        "match.textproto",
        "field: \"" + config + "/fields/msl-2024.textproto\"\n" + "camera: \"" + config +
            "/cameras/sim-640.textproto\"\nrobot: [1, 3]\n" + "frame_rate_hz: 4\n" + lines);
    std::vector<std::string> command{test::program("teamsight-sim-render").string(),
                                     "--match",
                                     match.string(),
                                     "--out",
                                     book().string(),
                                     "--seconds",
                                     "0.5"};
    command.insert(command.end(), options.begin(), options.end());
    return test::ChildProcess(command);
  }

  [[nodiscard]] fs::path book() const { return folder_.path() / "book"; }

  [[nodiscard]] std::vector<json> truth() const {
    std::vector<json> lines;
    std::ifstream file(book() / "truth.jsonl");
    for (std::string line; std::getline(file, line);) {
      lines.push_back(json::parse(line));
    }
    return lines;
  }

 private:
  test::TempDirectory folder_;
};

TEST_F(PictureBook, HasAPictureAndItsTruthForEveryRobotAndFrame) {
  auto writer = write();
  ASSERT_EQ(writer.wait_exit(60s), 0) << writer.err();

  const std::vector<json> lines = truth();

  ASSERT_EQ(lines.size(), 4U);
  for (const json& line : lines) {
    EXPECT_GT(fs::file_size(book() / line["image"].get<std::string>()), 10000U);
    EXPECT_EQ(line["balls"].size(), 1U);
    EXPECT_EQ(line["robots"].size(), 6U) << "the other one and five opponents";
  }
  EXPECT_EQ(lines[3]["image"], "robot3_000001.png");
  EXPECT_EQ(lines[3]["robot"], 3);
  EXPECT_EQ(lines[3]["time_s"], 0.25);
}

TEST_F(PictureBook, MayBeJpeg) {
  auto writer = write({}, {"--jpeg", "70"});
  ASSERT_EQ(writer.wait_exit(60s), 0) << writer.err();

  const std::string image = truth().at(0)["image"];

  EXPECT_EQ(image, "robot1_000000.jpg");
  std::ifstream file(book() / image, std::ios::binary);
  EXPECT_EQ(file.get(), 0xFF);
  EXPECT_EQ(file.get(), 0xD8);
}

TEST_F(PictureBook, IsNotWrittenOverAnother) {
  fs::create_directory(book());

  auto writer = write();

  EXPECT_EQ(writer.wait_exit(60s), 2);
  EXPECT_THAT(writer.err(), HasSubstr("expected no such folder yet"));
  EXPECT_TRUE(fs::is_empty(book()));
}

TEST_F(PictureBook, IsNotBegunForABadMatch) {
  auto writer = write("scenario: \"rugby\"\n");

  EXPECT_EQ(writer.wait_exit(60s), 2);
  const std::string words = writer.err();
  EXPECT_THAT(words, HasSubstr("found \"rugby\""));
  EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << words;
  EXPECT_FALSE(fs::exists(book()));
}

}  // namespace
}  // namespace teamsight::sim
