// tests/vision/mirror/mirrors.hpp: mirrors that several tests look at.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "settings/mirror_file.hpp"
#include "tests/support/process.hpp"
#include "vision/mirror/design.hpp"

namespace teamsight::test {

/// Every mirror file of the repository, without folder and ending.
inline const std::array<std::string, 6> kMirrorFiles{
    "multi_part", "cone_with_apex", "cone", "sphere", "paraboloid", "hyperboloid"};

/// Designs one of them; the test fails with an exception if it does not close.
[[nodiscard]] inline mirror::Mirror designed(const std::string& name) {
  const auto file = source_path("config/mirrors/" + name + ".textproto");
  return mirror::design(settings::load_mirror(file).parameters).value();
}

/// The multi-part mirror with all defaults and no body.
[[nodiscard]] inline mirror::MirrorParameters default_parameters() {
  return {.name = "default",
          .rim = {0.09, 0.8},
          .shape = mirror::MultiPart{},
          .scale = mirror::RimRadiusPx{512.0},
          .body = {}};
}

}  // namespace teamsight::test
