// tests/vision/localisation/ride.hpp: a drive with a camera, seen by a localiser, beside the truth.
#pragma once

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "bench/locate_score/drive.hpp"
#include "bench/locate_score/line_view.hpp"
#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"
#include "vision/localisation/localisation.hpp"

namespace teamsight::vision {

/// Plays a drive at 30 frames per second; searches answer two frames later.
class Ride {
 public:
  Ride(const FieldModel& field,
       const LocalisationParameters& parameters,
       const locate_score::DriveParameters& drive_parameters,
       std::uint32_t seed)
      : field_(field),
        localiser_(field, parameters),
        search_(field),
        state_(localiser_.begin()),
        drive_(field, drive_parameters, seed),
        random_(seed + 1000) {}

  /// One frame, a thirtieth of a second on.
  Located frame() {
    for (int i = 0; i < 3 + (frames_ % 3 == 0 ? 1 : 0); ++i) {
      const WheelReading reading = drive_.step();
      if (has_wheels) localiser_.roll(state_, reading);
    }
    ++frames_;
    if (lean_per_acceleration != 0.0) {
      view.pitch = -lean_per_acceleration * drive_.acceleration().x();
      view.roll = lean_per_acceleration * drive_.acceleration().y();
    }
    points_ = locate_score::look_at_lines(field_, truth(), view, fault, random_);
    if (spoil) spoil(points_);
    const FrameEvidence evidence{drive_.now(), points_};
    const Located located = localiser_.see(state_, evidence);
    if (answer_ && --answer_in_ <= 0) {
      localiser_.insert(state_, *answer_);
      answer_.reset();
    }
    if (const auto request = localiser_.wanted_search(state_, evidence)) {
      answer_ = search_.answer(*request);
      answer_in_ = 2;
    }
    return located;
  }

  [[nodiscard]] const Pose<Field, Robot>& truth() const { return drive_.truth(); }

  /// Distance of a posture from the truth, or from its mirror image; m.
  [[nodiscard]] double miss(const Located& located, bool or_mirrored) const {
    const auto gap = [&](const Pose<Field, Robot>& X) {
      return (X.origin().vector() - truth().origin().vector()).norm();
    };
    const double here = gap(located.posture.X_FR);
    return or_mirrored ? std::min(here, gap(mirrored(located.posture.X_FR, field_.centre))) : here;
  }

  [[nodiscard]] Eigen::Vector3d error(const Located& located) const {
    Eigen::Vector3d error = located.posture.X_FR.vector() - truth().vector();
    error.z() = wrap_angle(error.z());
    return error;
  }

  /// Told where it stands, as before kick-off.
  void place_at_truth() {
    const Eigen::Vector3d sigma(0.1, 0.1, 0.05);
    localiser_.place(state_, truth(), sigma.cwiseAbs2().asDiagonal(), drive_.now());
  }

  locate_score::LineViewParameters view;
  locate_score::MapFault fault;
  bool has_wheels{true};
  double lean_per_acceleration{0.0};  ///< rad per m/s^2
  std::function<void(std::vector<LinePoint>&)> spoil;

  Localiser& localiser() { return localiser_; }

  LocalisationState& state() { return state_; }

  locate_score::Drive& drive() { return drive_; }

  [[nodiscard]] const std::vector<LinePoint>& points() const { return points_; }

 private:
  FieldModel field_;
  Localiser localiser_;
  BackgroundSearch search_;
  LocalisationState state_;
  locate_score::Drive drive_;
  std::mt19937 random_;
  std::vector<LinePoint> points_;
  std::optional<SearchAnswer> answer_;
  int answer_in_{0};
  int frames_{0};
};

}  // namespace teamsight::vision
