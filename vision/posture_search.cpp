// vision/posture_search.cpp: grid, votes, refinement, merging.
#include "vision/posture_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"

namespace teamsight::vision {

namespace {

constexpr double kGridStep = 0.5;            // m
constexpr int kHeadings = 36;                // 10 degrees
constexpr std::size_t kSamples = 60;         // points used for rating
constexpr std::size_t kRefined = 40;         // places refined with the sample
constexpr std::size_t kFinished = 4;         // of those, finished with all points
constexpr float kSquareWidth = 0.3F * 0.3F;  // m^2, of a vote: the grid leaves errors that wide
constexpr double kSamePlace = 0.25;          // m
constexpr double kSameHeading = 0.2;         // rad

bool same(const Pose<Field, Robot>& a, const Pose<Field, Robot>& b) {
  return (a.origin().vector() - b.origin().vector()).norm() < kSamePlace &&
         std::abs(angle_difference(a.theta(), b.theta())) < kSameHeading;
}

// About kSamples points spread evenly over the list, which runs around the robot.
void take_sample(std::span<const LinePoint> points, std::vector<LinePoint>& sample) {
  sample.clear();
  const std::size_t count = std::min(points.size(), kSamples);
  for (std::size_t i = 0; i < count; ++i) sample.push_back(points[i * points.size() / count]);
}

// How well points (turned into F) lie on paint when the robot stands at `place`.
float votes_at(const LineMap& map,
               const Eigen::Vector2d& place,
               const std::vector<Eigen::Vector2d>& turned) {
  float votes = 0.0F;
  for (const Eigen::Vector2d& p : turned) {
    const float d = map.rough_distance(place + p);
    votes += kSquareWidth / (kSquareWidth + d * d);
  }
  return votes;
}

}  // namespace

PostureSearch::PostureSearch(const LineMap& map, bool half) : half_(half) {
  const FieldModel& field = map.field();
  const Eigen::Vector2d end{0.5 * field.length + field.surround,
                            0.5 * field.width + field.surround};
  const auto columns = static_cast<int>(2.0 * end.x() / kGridStep);
  const auto rows = static_cast<int>(2.0 * end.y() / kGridStep);
  for (int column = 0; column <= columns; ++column) {
    for (int row = 0; row <= rows; ++row) {
      const Eigen::Vector2d place = kGridStep * Eigen::Vector2d(column, row) - end;
      if (half && place.x() > 0.5 * kGridStep) continue;
      places_.emplace_back(field.centre.vector() + place);
    }
  }
  turned_.reserve(kSamples);
  sample_.reserve(kSamples);
  found_.reserve(kRefined);
  rated_.reserve(places_.size() * kHeadings);
}

void PostureSearch::rate(const LineMap& map, std::span<const LinePoint> points) {
  rated_.clear();
  for (int heading = 0; heading < kHeadings; ++heading) {
    const double theta = 2.0 * std::numbers::pi * heading / kHeadings;
    const Eigen::Matrix2d R_FR = Pose<Field, Robot>(0.0, 0.0, theta).rotation();
    turned_.clear();
    for (const LinePoint& point : points) turned_.emplace_back(R_FR * point.p_R.vector());
    for (const Eigen::Vector2d& place : places_) {
      const float votes = votes_at(map, place, turned_);
      rated_.push_back({static_cast<float>(place.x()),
                        static_cast<float>(place.y()),
                        static_cast<float>(theta),
                        votes});
    }
  }
}

void PostureSearch::merge(const PostureFit& fit, const Point<Field>& centre) {
  const auto known = std::ranges::find_if(found_, [&](const PostureFit& other) {
    return same(fit.X_FR, other.X_FR) || (half_ && same(mirrored(fit.X_FR, centre), other.X_FR));
  });
  if (known == found_.end()) {
    found_.push_back(fit);
  } else if (fit.support > known->support) {
    *known = fit;
  }
}

std::span<const PostureFit> PostureSearch::search(const LineMap& map,
                                                  std::span<const LinePoint> points,
                                                  PostureFitter& fitter) {
  found_.clear();
  if (points.empty()) return found_;
  const Point<Field>& centre = map.field().centre;
  const auto best_first = [](const auto& a, const auto& b) {
    return a.support > b.support;
  };
  take_sample(points, sample_);
  rate(map, sample_);
  const std::size_t refined = std::min(kRefined, rated_.size());
  std::partial_sort(rated_.begin(),
                    rated_.begin() + static_cast<std::ptrdiff_t>(refined),
                    rated_.end(),
                    [](const Place& a, const Place& b) { return a.votes > b.votes; });
  for (std::size_t i = 0; i < refined; ++i) {
    const Place& place = rated_[i];
    merge(fitter.fit(map,
                     sample_,
                     {static_cast<double>(place.x),
                      static_cast<double>(place.y),
                      static_cast<double>(place.theta)}),
          centre);
  }
  std::ranges::sort(found_, best_first);
  found_.resize(std::min(found_.size(), kFinished));
  std::array<PostureFit, kFinished> rough{};
  const std::size_t count = found_.size();
  std::copy(found_.begin(), found_.end(), rough.begin());
  found_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    merge(fitter.fit(map, points, rough.at(i).X_FR), centre);
  }
  std::ranges::sort(found_, best_first);
  return found_;
}

}  // namespace teamsight::vision
