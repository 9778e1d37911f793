// process/temperature.cpp: see process/temperature.hpp.
#include "process/temperature.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace teamsight::process {

std::optional<double> hottest_zone(const std::filesystem::path& folder) {
  constexpr double kHottest = 150.0;
  std::optional<double> hottest;
  std::error_code ignored;  // no folder: no zones
  for (const auto& zone : std::filesystem::directory_iterator(folder, ignored)) {
    if (!zone.path().filename().string().starts_with("thermal_zone")) continue;
    std::ifstream file(zone.path() / "temp");
    double thousandths = 0.0;
    if (!(file >> thousandths)) continue;
    const double degrees = thousandths / 1000.0;
    if (degrees < 0.0 || degrees > kHottest) continue;
    hottest = std::max(hottest.value_or(degrees), degrees);
  }
  return hottest;
}

}  // namespace teamsight::process
