// vision/posture_search.cpp: grid, votes, refinement, merging.
#include "vision/posture_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"

namespace teamsight::vision {

namespace {

constexpr double kGridStep = 0.5;           // m
constexpr int kHeadings = 36;               // 10 degrees
constexpr std::size_t kSamples = 90;        // points used for rating
constexpr std::size_t kRefined = 60;        // places refined with the sample
constexpr std::size_t kFinished = 6;        // of those, finished with all points
constexpr double kSquareWidth = 0.3 * 0.3;  // m^2, of a vote: the grid leaves errors that wide
constexpr double kVoteCell = 0.1;           // m
constexpr double kVoteMargin = 2.0;         // m beyond the carpet; farther out a vote is nothing
constexpr double kFinishWidth = 0.25;       // m, of the first kernel with all points
constexpr double kSamePlace = 0.25;         // m
constexpr double kSameHeading = 0.2;        // rad

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
  make_votes(map);
  turned_.reserve(kSamples);
  sample_.reserve(kSamples);
  found_.reserve(kRefined);
  rated_.reserve(places_.size() * kHeadings);
}

void PostureSearch::make_votes(const LineMap& map) {
  const FieldModel& field = map.field();
  const Eigen::Vector2d half{0.5 * field.length + field.surround + kVoteMargin,
                             0.5 * field.width + field.surround + kVoteMargin};
  const Eigen::Vector2d corner = field.centre.vector() - half;
  corner_ = corner.cast<float>();
  columns_ = static_cast<int>(2.0 * half.x() / kVoteCell);
  rows_ = static_cast<int>(2.0 * half.y() / kVoteCell);
  votes_.clear();
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector2d middle = corner + kVoteCell * Eigen::Vector2d(column + 0.5, row + 0.5);
      const double d = map.nearest(middle).distance;
      votes_.push_back(static_cast<std::uint8_t>(255.0 * kSquareWidth / (kSquareWidth + d * d)));
    }
  }
}

int PostureSearch::votes_at(float x, float y) const {
  int votes = 0;
  for (const Eigen::Vector2f& p : turned_) {
    const auto column = static_cast<int>(x + p.x());
    const auto row = static_cast<int>(y + p.y());
    // One comparison for both ends: what is negative becomes very large.
    const bool is_inside = static_cast<unsigned>(column) < static_cast<unsigned>(columns_) &&
                           static_cast<unsigned>(row) < static_cast<unsigned>(rows_);
    if (is_inside) {
      votes += votes_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(column)];
    }
  }
  return votes;
}

void PostureSearch::rate(std::span<const LinePoint> points) {
  constexpr auto kCellsPerMetre = static_cast<float>(1.0 / kVoteCell);
  rated_.clear();
  for (int heading = 0; heading < kHeadings; ++heading) {
    const double theta = 2.0 * std::numbers::pi * heading / kHeadings;
    const Eigen::Matrix2d R_FR = Pose<Field, Robot>(0.0, 0.0, theta).rotation();
    turned_.clear();
    for (const LinePoint& point : points) {
      turned_.emplace_back((R_FR * point.p_R.vector()).cast<float>() * kCellsPerMetre);
    }
    for (const Eigen::Vector2d& place : places_) {
      const auto x = static_cast<float>(place.x());
      const auto y = static_cast<float>(place.y());
      const int votes =
          votes_at((x - corner_.x()) * kCellsPerMetre, (y - corner_.y()) * kCellsPerMetre);
      rated_.push_back({x, y, static_cast<float>(theta), static_cast<float>(votes)});
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
                                                  PostureFitter& fitter,
                                                  const HeadTilt& tilt) {
  found_.clear();
  if (points.empty()) return found_;
  const Point<Field>& centre = map.field().centre;
  const auto best_first = [](const auto& a, const auto& b) {
    return a.support > b.support;
  };
  take_sample(points, sample_);
  rate(sample_);
  const std::size_t refined = std::min(kRefined, rated_.size());
  std::partial_sort(rated_.begin(),
                    rated_.begin() + static_cast<std::ptrdiff_t>(refined),
                    rated_.end(),
                    [](const Place& a, const Place& b) { return a.votes > b.votes; });
  for (std::size_t i = 0; i < refined; ++i) {
    const Place& place = rated_[i];
    const Pose<Field, Robot> start{static_cast<double>(place.x),
                                   static_cast<double>(place.y),
                                   static_cast<double>(place.theta)};
    merge(fitter.fit(map, sample_, {start}), centre);
  }
  std::ranges::sort(found_, best_first);
  found_.resize(std::min(found_.size(), kFinished));
  std::array<PostureFit, kFinished> rough{};
  const std::size_t count = found_.size();
  std::copy(found_.begin(), found_.end(), rough.begin());
  found_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    merge(fitter.fit(map, points, {rough.at(i).X_FR, kFinishWidth, tilt}), centre);
  }
  std::ranges::sort(found_, best_first);
  return found_;
}

}  // namespace teamsight::vision
