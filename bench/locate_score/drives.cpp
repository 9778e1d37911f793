// bench/locate_score/drives.cpp: sequences with slip, kidnapping and a wrong half.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "bench/locate_rivals/distance_table.hpp"
#include "bench/locate_rivals/monte_carlo.hpp"
#include "bench/locate_rivals/rprop.hpp"
#include "bench/locate_score/cases.hpp"
#include "bench/locate_score/drive.hpp"
#include "bench/locate_score/methods.hpp"
#include "bench/locate_score/rendered_view.hpp"
#include "bench/locate_score/spoils.hpp"
#include "vision/localisation/localisation.hpp"

namespace teamsight::locate_score {

namespace {

constexpr int kFrames = 300;       // ten seconds
constexpr int kSettled = 30;       // frames
constexpr int kKidnappedAt = 120;  // frame
constexpr double kFramePeriod = 1.0 / 30.0;
constexpr double kWrong = 0.5;        // m
constexpr double kRight = 0.1;        // m
constexpr double kFalseOkTime = 0.3;  // s
constexpr int kSearchFrames = 2;      // a search in the background answers so much later
constexpr int kRepairFrames = 150;
constexpr double kLean = 0.003;  // rad per m/s^2, of a head on a robot that accelerates

double gap(const Pose<Field, Robot>& a, const Pose<Field, Robot>& b) {
  return (a.origin().vector() - b.origin().vector()).norm();
}

// Everybody who is asked on one drive, and what they make of a kidnapping.
using FoundAt = std::map<std::string, std::optional<int>>;

/// The rivals, each with what it carries from frame to frame.
class Rivals {
 public:
  Rivals(const FieldModel& field, const Pose<Field, Robot>& start, std::uint32_t seed)
      : table_(field),
        cloud_(field, {}, seed),
        hough_(field),
        rprop_(start) {
    cloud_.gather(start, {0.1, 0.1, 0.05});
  }

  /// @param way  of the wheels since the last frame
  std::map<std::string, Answer> follow(const Pose<Robot, Robot>& way,
                                       std::span<const vision::LinePoint> points) {
    using Milliseconds = std::chrono::duration<double, std::milli>;
    const auto start = std::chrono::steady_clock::now();
    rprop_ = locate_rivals::rprop(table_, points, rprop_ * way);
    const auto middle = std::chrono::steady_clock::now();
    cloud_.move(way);
    cloud_.weigh(table_, points);
    const Pose<Field, Robot> mean = cloud_.estimate();
    const auto end = std::chrono::steady_clock::now();
    return {{"rprop10", {rprop_, {}, Milliseconds(middle - start).count()}},
            {"mcl500", {mean, {}, Milliseconds(end - middle).count()}},
            {"hough2001", hough_.locate(points)}};
  }

 private:
  locate_rivals::DistanceTable table_;
  locate_rivals::MonteCarlo cloud_;
  PointHough hough_;
  Pose<Field, Robot> rprop_;
};

/// One sequence: the robot, its tracker, and the rivals that follow it.
// In the order in which they are made, not packed: there are few.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding)
class Sequence {
 public:
  Sequence(const CaseOptions& options,
           const CalibrationRemainder& remainder,
           RenderedView& view,
           std::uint32_t number)
      : options_(options),
        view_(view),
        is_kidnapped_(number % 2 == 1),
        is_mirrored_(number % 5 == 0),
        drive_(options.field, {.slips_per_second = 0.2}, options.seed + 1000 * number),
        random_(options.seed + 1000 * number + 1),
        eye_(remainder, view.head().eye_height, random_),
        localiser_(options.field, parameters_of(view)),
        state_(localiser_.begin()),
        search_(options.field) {
    const Point<Field>& centre = options.field.centre;
    if (is_half_turn_symmetric(options.field)) symmetry_ = centre;
    const Pose<Field, Robot> named =
        is_mirrored_ ? mirrored(drive_.truth(), centre) : drive_.truth();
    localiser_.place(state_, named, 0.01 * Eigen::Matrix3d::Identity(), drive_.now());
    if (options.rivals) rivals_.emplace(options.field, drive_.truth(), options.seed + number);
    last_wheels_ = drive_.step().X_DR;
  }

  void run(DriveResult& result) {
    ++result.sequences;
    for (int frame = 0; frame < kFrames; ++frame) step(frame, result);
    finish(result);
    result.slips += state_.counts.slips;
  }

 private:
  static vision::LocalisationParameters parameters_of(const RenderedView& view) {
    vision::LocalisationParameters parameters;
    parameters.tilt = view.head();
    return parameters;
  }

  void step(int frame, DriveResult& result) {
    if (is_kidnapped_ && frame == kKidnappedAt) {
      drive_.kidnap(draw_pose(options_.field, 0.5, random_));
      ++result.kidnappings;
    }
    Pose<teamsight::Drive, Robot> wheels = last_wheels_;
    for (int i = 0; i < (frame % 3 == 0 ? 4 : 3); ++i) {
      const vision::WheelReading reading = drive_.step();
      localiser_.roll(state_, reading);
      wheels = reading.X_DR;
    }
    // A compass on those that begin on the wrong half, ten times a second.
    if (is_mirrored_ && frame % 3 == 0) {
      std::normal_distribution<double> noise(0.0, 0.3);
      localiser_.point(state_, {drive_.now(), drive_.truth().theta() + noise(random_), 0.3});
    }
    const Pose<Robot, Robot> way = last_wheels_.inverse() * wheels;
    last_wheels_ = wheels;
    look();
    const Answer tracked = track();
    judge(frame, tracked, result);
    if (rivals_) {
      for (const auto& [name, answer] : rivals_->follow(way, points_)) {
        count(frame, name, answer, result);
      }
    }
  }

  // What the robot's own eye makes of the frame, on a head that leans back as it accelerates.
  void look() {
    view_.draw(drive_.truth(), {});
    const auto seen = view_.line_points();
    points_.assign(seen.begin(), seen.end());
    const Eigen::Vector2d& acceleration = drive_.acceleration();
    eye_.look(points_, kLean * Eigen::Vector2d(acceleration.y(), -acceleration.x()));
  }

  // Nothing if the tracker says that it is lost; its status is in `is_ok_`.
  Answer track() {
    const auto start = std::chrono::steady_clock::now();
    const vision::FrameEvidence evidence{drive_.now(), points_};
    const vision::Located located = localiser_.see(state_, evidence);
    const double time_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (answer_ && --answer_in_ <= 0) {
      localiser_.insert(state_, *answer_);
      answer_.reset();
    }
    if (const auto request = localiser_.wanted_search(state_, evidence)) {
      answer_ = search_.answer(*request);
      answer_in_ = kSearchFrames;
    }
    is_ok_ = located.posture.status == PostureStatus::kOk;
    Answer answer{located.posture.X_FR, located.posture.cov, time_ms};
    if (located.posture.status == PostureStatus::kLost) answer.X_FR.reset();
    return answer;
  }

  void judge(int frame, const Answer& tracked, DriveResult& result) {
    // Who is told the wrong half cannot know better before the compass says so.
    const bool is_wrong = tracked.X_FR && gap(*tracked.X_FR, drive_.truth()) > kWrong;
    false_ok_ = is_ok_ && is_wrong && !is_mirrored_ ? false_ok_ + kFramePeriod : 0.0;
    result.longest_false_ok_s = std::max(result.longest_false_ok_s, false_ok_);
    if (false_ok_ > kFalseOkTime && false_ok_ - kFramePeriod <= kFalseOkTime) {
      ++result.false_ok_episodes;
    }
    if (is_mirrored_ && !repaired_at_ && tracked.X_FR && !is_wrong) repaired_at_ = frame;
    count(frame, "track", tracked, result);
  }

  // One method's answer to one frame: into its errors before a kidnapping, into its recovery after.
  void count(int frame, const std::string& name, const Answer& answer, DriveResult& result) {
    if (is_kidnapped_ && frame >= kKidnappedAt) {
      const Pose<Field, Robot> image = mirrored(drive_.truth(), options_.field.centre);
      const bool is_right = answer.X_FR && std::min(gap(*answer.X_FR, drive_.truth()),
                                                    gap(*answer.X_FR, image)) < kRight;
      std::optional<int>& found_at = found_at_[name];
      if (!is_right) {
        found_at.reset();
      } else if (!found_at) {
        found_at = frame;
      }
    } else if (frame >= kSettled && !is_mirrored_) {
      const bool knows_half = name != "hough2001";
      result.frames.tallies[name].add(
          answer, drive_.truth(), Eigen::Vector2d::Zero(), knows_half ? std::nullopt : symmetry_);
    }
  }

  void finish(DriveResult& result) const {
    for (const auto& [name, found_at] : found_at_) {
      Recoveries& recoveries = result.recoveries[name];
      if (!found_at) continue;
      const double after = (*found_at - kKidnappedAt) * kFramePeriod;
      if (after <= 1.0) ++recoveries.within_1s;
      recoveries.slowest_s = std::max(recoveries.slowest_s, after);
    }
    if (is_mirrored_) {
      ++result.wrong_halves;
      if (repaired_at_ && *repaired_at_ <= kRepairFrames) ++result.halves_repaired;
    }
  }

  const CaseOptions& options_;
  RenderedView& view_;
  bool is_kidnapped_;
  bool is_mirrored_;
  Drive drive_;
  std::mt19937 random_;
  Eye eye_;
  vision::Localiser localiser_;
  vision::LocalisationState state_;
  vision::BackgroundSearch search_;
  std::optional<Point<Field>> symmetry_;
  std::optional<Rivals> rivals_;
  Pose<teamsight::Drive, Robot> last_wheels_;
  std::vector<vision::LinePoint> points_;
  std::optional<vision::SearchAnswer> answer_;
  int answer_in_{0};
  bool is_ok_{false};
  FoundAt found_at_;
  std::optional<int> repaired_at_;
  double false_ok_{0.0};
};

}  // namespace

DriveResult run_drives(const CaseOptions& options, const CalibrationRemainder& remainder) {
  RenderedView view(options.camera, options.camera, options.field, options.pixel_noise_sigma);
  DriveResult result;
  result.frames.name = "drive";
  const auto sequences = static_cast<std::uint32_t>(std::max<std::size_t>(4, options.poses / 25));
  for (std::uint32_t number = 0; number < sequences; ++number) {
    Sequence(options, remainder, view, number).run(result);
  }
  return result;
}

}  // namespace teamsight::locate_score
