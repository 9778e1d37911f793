// settings/class_table_file.cpp: see settings/class_table_file.hpp.
#include "settings/class_table_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

#include "geometry/expect.hpp"
#include "settings/settings_error.hpp"

namespace teamsight::settings {

namespace {

using vision::ColourClass;

constexpr std::string_view kHead = "teamsight colour classes: 6 bits of y, u, v\n";
constexpr auto kLastClass = static_cast<std::uint8_t>(ColourClass::kBlack);

}  // namespace

vision::ClassTable read_class_table(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!bytes.starts_with(kHead) || bytes.size() != kHead.size() + vision::kClassCells) {
    throw SettingsError(path.string() + ":1:1: found " + std::to_string(bytes.size()) +
                        " bytes, expected a table of colour classes, " +
                        std::to_string(kHead.size() + vision::kClassCells) + " bytes");
  }
  vision::ClassTable table;
  table.reserve(vision::kClassCells);
  for (const char byte : std::string_view(bytes).substr(kHead.size())) {
    const auto value = static_cast<std::uint8_t>(byte);
    if (value > kLastClass) {
      throw SettingsError(path.string() + ":2:" + std::to_string(table.size() + 1) + ": found " +
                          std::to_string(value) + ", expected a class from 0 to " +
                          std::to_string(kLastClass));
    }
    table.push_back(static_cast<ColourClass>(value));
  }
  return table;
}

std::string class_table_bytes(const vision::ClassTable& table) {
  TEAMSIGHT_EXPECT(table.size() == vision::kClassCells);
  std::string bytes(kHead);
  std::ranges::transform(table, std::back_inserter(bytes), [](ColourClass colour) {
    return static_cast<char>(colour);
  });
  return bytes;
}

}  // namespace teamsight::settings
