// tests/bench/robot_logs_test.cpp: reading a data set of real robots.
#include "bench/mrclam/robot_logs.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace teamsight::mrclam {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// A folder with a second of five robots that stand still and see one landmark and each other.
class RobotLogFolder : public ::testing::Test {
 protected:
  RobotLogFolder() {
    std::string name = (fs::temp_directory_path() / "teamsight-robot-logs-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    write("Barcodes.dat", "# comment\n 1 5\n 2 14\n 3 41\n 4 32\n 5 23\n 6 63\n");
    write("Landmark_Groundtruth.dat", "6 1.5 -2.0 0.001 0.001\n");
    for (int robot = 1; robot <= kRobots; ++robot) {
      const std::string stem = "Robot" + std::to_string(robot);
      write(stem + "_Groundtruth.dat", "100.0 0 0 0\n100.5 1 0 0.5\n101.0 2 0 1\n");
      write(stem + "_Odometry.dat", "100.0 0.5 0\n101.0 0.5 0\n");
      write(stem + "_Measurement.dat",
            "100.2\t63\t1.5\t0.25\n100.2 14 2.0 -0.5\n100.3 99 1.0 0.0\n");
    }
  }

  ~RobotLogFolder() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  fs::path folder_;
};

TEST_F(RobotLogFolder, IsReadWithStampsFromTheStart) {
  const RobotLogs logs = read_robot_logs(folder_);

  EXPECT_DOUBLE_EQ(logs.duration, 1.0);
  EXPECT_EQ(logs.landmarks.at(6), Eigen::Vector2d(1.5, -2.0));
  const RobotLog& robot = logs.robots[0];
  ASSERT_EQ(robot.seen.size(), 3U);
  EXPECT_NEAR(robot.seen[0].t, 0.2, 1e-9);
  EXPECT_EQ(robot.seen[0].subject, 6);
  EXPECT_EQ(robot.seen[1].subject, 2);
  EXPECT_EQ(robot.seen[2].subject, 0) << "a code that is nobody's";
  EXPECT_EQ(robot.truth_at(0.4).x(), 1.0);
  EXPECT_EQ(robot.truth_at(9.0).x(), 2.0);
}

TEST_F(RobotLogFolder, NamesFileAndLineOfWhatIsNoRow) {
  write("Robot3_Odometry.dat", "100.0 0.5 0\n100.5 half 0\n");
  EXPECT_THAT([&] { static_cast<void>(read_robot_logs(folder_)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("Robot3_Odometry.dat:2: found")));
}

TEST_F(RobotLogFolder, RefusesStampsThatRunBackwards) {
  write("Robot3_Odometry.dat", "100.0 0.5 0\n99.0 0.5 0\n");
  EXPECT_THAT([&] { static_cast<void>(read_robot_logs(folder_)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("Robot3_Odometry.dat:2: its stamp")));
}

TEST_F(RobotLogFolder, SaysWhichFileIsMissing) {
  fs::remove(folder_ / "Robot5_Measurement.dat");
  EXPECT_THAT([&] { static_cast<void>(read_robot_logs(folder_)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("Robot5_Measurement.dat: not found")));
}

}  // namespace
}  // namespace teamsight::mrclam
