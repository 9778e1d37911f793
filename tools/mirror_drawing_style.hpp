// tools/mirror_drawing_style.hpp: what the drawings of mirrors have in common: colours, range,
// titles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "tools/svg_plot.hpp"
#include "vision/mirror/design.hpp"

namespace teamsight::tools {

/// Gives each name the next colour when it first appears, and keeps it.
class PartColours {
 public:
  const std::string& of(const std::string& part) {
    const auto found = std::find(names_.begin(), names_.end(), part);
    const auto index = static_cast<std::size_t>(found - names_.begin());
    if (found == names_.end()) {
      names_.push_back(part);
    }
    return plot::series_colour(index);
  }

 private:
  std::vector<std::string> names_;
};

/// The floor distance that the axes reach: a little more than the longest view asked for; m.
[[nodiscard]] inline double farthest(const std::vector<mirror::Mirror>& mirrors) {
  double result = 12.0;
  for (const mirror::Mirror& mirror : mirrors) {
    if (mirror.multi_part) {
      result = std::max(result, 1.07 * mirror.multi_part->parameters.max_distance);
    }
  }
  return result;
}

/// @param subject  what is drawn, beginning with a capital
[[nodiscard]] inline std::string title_of(const std::vector<mirror::Mirror>& mirrors,
                                          const std::string& subject) {
  return mirrors.size() == 1 ? subject + ": " + mirrors.front().name : subject;
}

}  // namespace teamsight::tools
