// settings/mirror_profile_csv.cpp: a mirror's meridian with slopes, as a CSV file.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <system_error>

#include "settings/mirror_file.hpp"
#include "settings/text_format.hpp"

namespace teamsight::settings {

namespace {

constexpr std::string_view kHead = "x_m,y_m,slope";
constexpr double kKink = 1e-9;  // m between the two rows of a joint

/// A line of the file and where it stands, for complaints.
struct Line {
  const std::filesystem::path* path{nullptr};
  int number{0};
  std::string text;

  [[nodiscard]] SettingsError error(const std::string& key,
                                    const std::string& found,
                                    const std::string& expected) const {
    return SettingsError(path->string() + ":" + std::to_string(std::max(number, 1)) + ": key '" +
                         key + "': found " + found + ", expected " + expected);
  }
};

mirror::Node node_of(const Line& line) {
  std::array<double, 3> values{};
  const char* at = line.text.data();
  const char* const end = at + line.text.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto [stop, error] = std::from_chars(at, end, values.at(i));
    const bool ends_well = i + 1 == values.size() ? stop == end : stop != end && *stop == ',';
    if (error != std::errc() || !ends_well || !std::isfinite(values.at(i))) {
      throw line.error(std::string(kHead), "'" + line.text + "'", "three finite numbers");
    }
    at = stop + 1;
  }
  if (values[0] < 0.0) throw line.error("x_m", text_of(values[0]), "at least 0, the axis");
  if (values[1] <= 0.0) throw line.error("y_m", text_of(values[1]), "above 0, the pinhole");
  return {values[0], values[1], values[2]};
}

void append(mirror::Profile& profile, const mirror::Node& node, const Line& line) {
  auto& parts = profile.parts;
  if (!parts.empty()) {
    const mirror::Node& before = parts.back().nodes.back();
    if (node.x <= before.x) {
      throw line.error(
          "x_m",
          text_of(node.x),
          "more than the row before, " + text_of(before.x) + " (the profile must be a function)");
    }
    if (node.x - before.x > 1.5 * kKink) {
      parts.back().nodes.push_back(node);
      return;
    }
  }
  const std::string name = line.path->stem().string() + " " + std::to_string(parts.size() + 1);
  parts.push_back({.name = name, .nodes = {node}, .kinked_start = !parts.empty()});
}

/// The next line that is neither empty nor a comment.
bool next_row(std::ifstream& file, Line& line) {
  while (std::getline(file, line.text)) {
    ++line.number;
    if (!line.text.empty() && line.text.back() == '\r') line.text.pop_back();
    if (!line.text.empty() && line.text.front() != '#') return true;
  }
  return false;
}

void check_parts(const mirror::Profile& profile, const Line& line) {
  if (profile.parts.empty()) {
    throw line.error(std::string(kHead), "no rows", "at least two rows");
  }
  for (const mirror::Part& part : profile.parts) {
    if (part.nodes.size() < 2) {
      throw line.error("x_m", "a part of one row", "at least two rows in each part");
    }
  }
}

std::string row(double x, const mirror::Node& node) {
  return text_of(x) + "," + text_of(node.y) + "," + text_of(node.slope) + "\n";
}

}  // namespace

mirror::Profile read_mirror_profile(const std::filesystem::path& path) {
  std::ifstream file(path);
  Line line{&path, 0, {}};
  mirror::Profile profile;
  bool has_head = false;
  while (next_row(file, line)) {
    if (has_head) {
      append(profile, node_of(line), line);
    } else if (line.text != kHead) {
      throw line.error(std::string(kHead), "'" + line.text + "'", "the head x_m,y_m,slope");
    }
    has_head = true;
  }
  check_parts(profile, line);
  return profile;
}

std::string mirror_profile_csv(const mirror::Profile& profile) {
  std::string text = std::string(kHead) + "\n";
  for (std::size_t i = 0; i < profile.parts.size(); ++i) {
    const auto& nodes = profile.parts[i].nodes;
    const bool kinked = profile.parts[i].kinked_start;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (i > 0 && k == 0 && !kinked) continue;
      text += row(i > 0 && k == 0 ? nodes[k].x + kKink : nodes[k].x, nodes[k]);
    }
  }
  return text;
}

}  // namespace teamsight::settings
