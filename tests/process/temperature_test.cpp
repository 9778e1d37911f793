// tests/process/temperature_test.cpp: the kernel's thermal zones, made up in a folder.
#include "process/temperature.hpp"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/process.hpp"

namespace teamsight::process {
namespace {

void make_zone(const std::filesystem::path& folder, const std::string& name, const char* text) {
  std::filesystem::create_directories(folder / name);
  std::ofstream(folder / name / "temp") << text;
}

TEST(HottestZone, IsTheLargestThatMakesSense) {
  const test::TempDirectory folder;
  const std::filesystem::path zones = folder.path();
  make_zone(zones, "thermal_zone0", "48000\n");
  make_zone(zones, "thermal_zone1", "61500\n");
  make_zone(zones, "thermal_zone2", "255000\n");
  make_zone(zones, "thermal_zone3", "not now\n");
  make_zone(zones, "cooling_device0", "99000\n");

  EXPECT_EQ(hottest_zone(zones), 61.5);
}

TEST(HottestZone, IsNothingWhereThereAreNone) {
  const test::TempDirectory folder;

  EXPECT_EQ(hottest_zone(folder.path()), std::nullopt);
  EXPECT_EQ(hottest_zone(std::filesystem::path(folder.path()) / "missing"), std::nullopt);
}

}  // namespace
}  // namespace teamsight::process
