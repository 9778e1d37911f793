// tests/realdata/colour_samples_test.cpp: a ball's colour from a few labelled images, on the
// others.
#include "vision/calibration/colour_samples.hpp"

#include <cstddef>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tests/realdata/folders.hpp"
#include "tools/image_file.hpp"
#include "vision/colour_classes.hpp"

namespace teamsight {
namespace {

using vision::ColourClass;
using vision::ColourClasses;
using vision::LabelledColours;
using vision::SampledColour;

constexpr std::size_t kTaught = 3;  // images
constexpr double kInside = 0.6;     // of a ball's radius: away from its rim

/// The pixels of each sure ball of one image.
std::vector<std::vector<SampledColour>> balls_of(const nlohmann::json& label,
                                                 const vision::CameraParameters& camera) {
  const auto image =
      tools::read_image(test::data_dir() / label["image"].get<std::string>(), camera);
  std::vector<std::vector<SampledColour>> balls;
  for (const auto& ball : label["balls"]) {
    if (!ball["certain"].get<bool>()) continue;
    balls.push_back(vision::colours_around(image.view(),
                                           {ball["u"].get<double>(), ball["v"].get<double>()},
                                           kInside * ball["r_px"].get<double>()));
  }
  return balls;
}

double share_of_balls(const vision::ColourParameters& colours,
                      const std::vector<SampledColour>& pixels) {
  const ColourClasses classes(colours);
  std::size_t balls = 0;
  for (const SampledColour& p : pixels) {
    if (classes.of(vision::Chroma{p.u, p.v}) == ColourClass::kBall) ++balls;
  }
  return static_cast<double>(balls) / static_cast<double>(pixels.size());
}

TEST(RealColours, OfABallAreKnownInOtherImagesOfTheSameCamera) {
  if (!test::has_data("lar_minho2023")) GTEST_SKIP() << "no real data in " << test::data_dir();
  std::ifstream file(test::data_dir() / "labels.json");
  const std::map<std::string, std::string> cameras{{"lar_minho2023/3v", "lar_minho2023-3"},
                                                   {"lar_minho2023/8v2", "lar_minho2023-8"},
                                                   {"lar_minho2023/8v3", "lar_minho2023-8b"},
                                                   {"minho2017/Screenshot", "minho2017"}};
  const auto labels = nlohmann::json::parse(file);
  for (const auto& [prefix, name] : cameras) {
    const auto camera =
        settings::load_camera(test::source_dir() / "config/cameras" / (name + ".textproto"));
    std::vector<LabelledColours> taught;
    std::vector<SampledColour> asked;
    std::size_t seen = 0;
    for (const auto& label : labels) {
      if (!label["image"].get<std::string>().starts_with(prefix)) continue;
      const auto balls = balls_of(label, camera);
      const bool is_taught = !balls.empty() && seen++ < kTaught;
      for (const auto& pixels : balls) {
        if (is_taught) {
          taught.push_back({ColourClass::kBall, pixels});
        } else {
          asked.insert(asked.end(), pixels.begin(), pixels.end());
        }
      }
    }
    const auto colours = vision::colours_from(camera.colours, taught);
    ASSERT_TRUE(colours) << name;
    if (asked.empty()) continue;
    const double share = share_of_balls(*colours, asked);
    const double shipped = share_of_balls(camera.colours, asked);
    std::cout << name << ": " << share << " of the balls' " << asked.size()
              << " pixels; with the shipped classes " << shipped << '\n';
    EXPECT_GT(share, 0.85 * shipped) << name;
  }
}

}  // namespace
}  // namespace teamsight
