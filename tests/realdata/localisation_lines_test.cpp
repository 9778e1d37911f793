// tests/realdata/localisation_lines_test.cpp: postures from other teams' recorded line points.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tests/realdata/folders.hpp"
#include "vision/localisation/localisation.hpp"

namespace teamsight {
namespace {

namespace fs = std::filesystem;
using test::data_dir;
using test::source_dir;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

double number_in(const std::string& xml, const std::string& key) {
  const auto at = xml.find("<" + key + ">");
  return std::stod(xml.substr(at + key.size() + 2));
}

// White pixels taken to the floor by the team's own mirror: distance_m = a tan(b pixel_radius).
std::vector<vision::LinePoint> line_points(const fs::path& whites, const fs::path& mirror) {
  const std::string xml = text_of(mirror);
  const double a = number_in(xml, "para_a");
  const double b = number_in(xml, "para_b");
  const double column = number_in(xml, "center_coloum");
  const double row = number_in(xml, "center_row");
  std::ifstream file(whites);
  std::vector<vision::LinePoint> points;
  double x = 0.0;
  double y = 0.0;
  while (file >> x >> y) {
    const double radius = std::hypot(x - column, y - row);
    const double azimuth = std::atan2(row - y, x - column);
    const double distance = a * std::tan(b * radius);
    // The paint is 0.125 m wide, and a white pixel lies anywhere in it; the picture has pixels too.
    const double footprint = a * b / std::pow(std::cos(b * radius), 2);
    const double var = std::pow(0.036, 2) + std::pow(0.5 * footprint, 2);
    vision::LinePoint point;
    point.p_R = {distance * std::cos(azimuth), distance * std::sin(azimuth)};
    point.cov_R = var * Eigen::Matrix2d::Identity();
    points.push_back(point);
  }
  return points;
}

struct Residuals {
  double median{1e9};
  double most{1e9};  // 90 %
};

// Of all points, outliers included.
Residuals residuals_at(const vision::LineMap& map,
                       const std::vector<vision::LinePoint>& points,
                       const Pose<Field, Robot>& X_FR,
                       const vision::HeadTilt& tilt,
                       const Eigen::Vector2d& leant) {
  std::vector<double> sizes;
  for (const vision::LinePoint& point : points) {
    const auto residual = vision::line_residual(map, X_FR, point, leant, tilt.eye_height);
    sizes.push_back(std::abs(residual.distance));
  }
  std::ranges::sort(sizes);
  return {sizes[sizes.size() / 2], sizes[sizes.size() * 9 / 10]};
}

// The simplest fit: least squares of all points' distances, upright, from a place near by.
Pose<Field, Robot> least_squares_from(Pose<Field, Robot> X_FR,
                                      const vision::LineMap& map,
                                      const std::vector<vision::LinePoint>& points,
                                      const vision::HeadTilt& tilt) {
  for (int i = 0; i < 50; ++i) {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (const vision::LinePoint& point : points) {
      const auto residual =
          vision::line_residual(map, X_FR, point, Eigen::Vector2d::Zero(), tilt.eye_height);
      const Eigen::Vector3d slope = residual.jacobian;
      information += slope * slope.transpose();
      gradient += residual.distance * slope;
    }
    const Eigen::Vector3d change = information.ldlt().solve(-gradient);
    X_FR = {X_FR.x() + change.x(), X_FR.y() + change.y(), X_FR.theta() + change.z()};
  }
  return X_FR;
}

struct TwoFits {
  Residuals best;           // the best posture of a search without prior
  Residuals least_squares;  // from there
};

TwoFits fits_of(const std::vector<vision::LinePoint>& points, double sigma_tilt) {
  const FieldModel field = settings::load_field(source_dir() / "config/fields/msl-18x12.textproto");
  vision::BackgroundSearch search(field);
  vision::SearchRequest request;
  request.points = points;
  request.tilt.sigma.setConstant(sigma_tilt);
  const vision::SearchAnswer found = search.answer(request);
  if (found.places.empty()) return {};
  const vision::LineMap map(field);
  const vision::PostureFit& best = found.places.front();
  const auto simple = least_squares_from(best.X_FR, map, points, request.tilt);
  const TwoFits fits{residuals_at(map, points, best.X_FR, request.tilt, best.tilt),
                     residuals_at(map, points, simple, request.tilt, Eigen::Vector2d::Zero())};
  std::cout << points.size() << " points: x " << best.X_FR.x() << " m, y " << best.X_FR.y()
            << " m, theta " << best.X_FR.theta() << " rad; residuals: median " << fits.best.median
            << " m, 90 % " << fits.best.most << " m; by least squares " << fits.least_squares.median
            << " m, " << fits.least_squares.most << " m\n";
  return fits;
}

class RecordedLines : public ::testing::Test {
 protected:
  void SetUp() override {
    if (test::has_data("nubot_nudt")) return;
    GTEST_SKIP() << "no real data in " << data_dir();
  }
};

TEST_F(RecordedLines, OfTwoNubotsFitAsWellAsAnyFitOfThem) {
  for (const std::string robot : {"robot1", "robot2"}) {
    const fs::path folder = data_dir() / "nubot_nudt";
    const auto points =
        line_points(folder / (robot + "-whites.txt"), folder / (robot + "-mirror_calib.xml"));
    ASSERT_GT(points.size(), 2000U);

    const TwoFits fits = fits_of(points, 0.0052);

    EXPECT_LE(fits.best.median, 0.047) << robot;
    EXPECT_LE(fits.best.median, fits.least_squares.median) << robot;
    // A fit that listens to outliers leaves them nearer.
    EXPECT_LE(fits.best.most, 0.14) << robot;
  }
}

TEST_F(RecordedLines, OfAHalfFieldFitWithinTwoCentimetres) {
  const fs::path folder = data_dir() / "nubot_mshicom";
  const auto points =
      line_points(folder / "standalone_whites.txt", folder / "standalone_mirror_calib.xml");
  ASSERT_GT(points.size(), 200U);

  const TwoFits fits = fits_of(points, 0.0052);

  EXPECT_LE(fits.best.median, 0.020);
  EXPECT_LE(fits.best.most, 0.075);
}

TEST_F(RecordedLines, GiveThePostureThatTheFalconsFound) {
  const auto record =
      nlohmann::json::parse(text_of(data_dir() / "mra" / "falcons_r5_20191219_210335_lines.json"));
  std::vector<vision::LinePoint> points;
  for (const auto& mark : record["Input"]["landmarks"]) {
    // Theirs: x to the right, y forward.
    vision::LinePoint point;
    point.p_R = {mark["y"].get<double>(), -mark["x"].get<double>()};
    point.cov_R = 0.0025 * Eigen::Matrix2d::Identity();
    points.push_back(point);
  }
  const auto& pose = record["Output"]["candidates"][0]["pose"];
  const Point<Field> theirs{pose["y"].get<double>(), -pose["x"].get<double>()};
  const FieldModel field = settings::load_field(source_dir() / "config/fields/msl-18x12.textproto");
  vision::BackgroundSearch search(field);
  vision::SearchRequest request;
  request.points = points;

  const vision::SearchAnswer found = search.answer(request);

  ASSERT_FALSE(found.places.empty());
  const Pose<Field, Robot>& X_FR = found.places.front().X_FR;
  const double gap = std::min((X_FR.origin().vector() - theirs.vector()).norm(),
                              (X_FR.origin().vector() + theirs.vector()).norm());
  std::cout << points.size() << " points: " << gap << " m from their posture\n";
  EXPECT_LT(gap, 0.15);
}

}  // namespace
}  // namespace teamsight
