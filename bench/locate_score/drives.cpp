// bench/locate_score/drives.cpp: sequences with slip, kidnapping and a wrong half.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <random>

#include "bench/locate_rivals/distance_table.hpp"
#include "bench/locate_rivals/monte_carlo.hpp"
#include "bench/locate_rivals/rprop.hpp"
#include "bench/locate_score/cases.hpp"
#include "bench/locate_score/drive.hpp"
#include "bench/locate_score/rendered_view.hpp"
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

double gap(const Pose<Field, Robot>& a, const Pose<Field, Robot>& b) {
  return (a.origin().vector() - b.origin().vector()).norm();
}

/// One sequence: the robot, its tracker, and the rivals that follow it.
class Sequence {
 public:
  Sequence(const CaseOptions& options, RenderedView& view, std::uint32_t number)
      : options_(options),
        view_(view),
        is_kidnapped_(number % 2 == 1),
        is_mirrored_(number % 5 == 0),
        drive_(options.field, {.slips_per_second = 0.2}, options.seed + 1000 * number),
        random_(options.seed + 1000 * number + 1),
        localiser_(options.field, parameters_of(view)),
        state_(localiser_.begin()),
        search_(options.field),
        table_(options.field),
        cloud_(options.field, {}, options.seed + number) {
    const Point<Field>& centre = options.field.centre;
    const Pose<Field, Robot> named =
        is_mirrored_ ? mirrored(drive_.truth(), centre) : drive_.truth();
    localiser_.place(state_, named, 0.01 * Eigen::Matrix3d::Identity(), drive_.now());
    rprop_ = drive_.truth();
    cloud_.gather(drive_.truth(), {0.1, 0.1, 0.05});
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
    view_.draw(drive_.truth(), {});
    const auto seen = view_.line_points();
    points_.assign(seen.begin(), seen.end());
    const vision::Located located = track(frame, result);
    judge(frame, located, result);
    if (options_.rivals && (!is_kidnapped_ || frame < kKidnappedAt)) follow(way, frame, result);
  }

  vision::Located track(int frame, DriveResult& result) {
    const auto start = std::chrono::steady_clock::now();
    const vision::FrameEvidence evidence{drive_.now(), points_};
    vision::Located located = localiser_.see(state_, evidence);
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
    const bool counts =
        frame >= kSettled && !is_mirrored_ && !(is_kidnapped_ && frame >= kKidnappedAt);
    if (counts) {
      Answer answer{located.posture.X_FR, located.posture.cov, time_ms};
      if (located.posture.status == PostureStatus::kLost) answer.X_FR.reset();
      result.frames.tallies["track"].add(
          answer, drive_.truth(), Eigen::Vector2d::Zero(), std::nullopt);
    }
    return located;
  }

  void judge(int frame, const vision::Located& located, DriveResult& result) {
    const Pose<Field, Robot>& X_FR = located.posture.X_FR;
    const double here = gap(X_FR, drive_.truth());
    const double either =
        std::min(here, gap(mirrored(X_FR, options_.field.centre), drive_.truth()));
    const bool is_lost = located.posture.status == PostureStatus::kLost;
    // Who is told the wrong half cannot know better before the compass says so.
    const bool is_false =
        located.posture.status == PostureStatus::kOk && here > kWrong && !is_mirrored_;
    false_ok_ = is_false ? false_ok_ + kFramePeriod : 0.0;
    result.longest_false_ok_s = std::max(result.longest_false_ok_s, false_ok_);
    if (false_ok_ > kFalseOkTime && false_ok_ - kFramePeriod <= kFalseOkTime) {
      ++result.false_ok_episodes;
    }
    const bool is_right = !is_lost && either < kRight;
    if (is_kidnapped_ && frame >= kKidnappedAt) {
      if (is_right && !found_at_) found_at_ = frame;
      if (!is_right) found_at_.reset();
    }
    if (is_mirrored_ && !repaired_at_ && here < kWrong) repaired_at_ = frame;
  }

  void follow(const Pose<Robot, Robot>& way, int frame, DriveResult& result) {
    const auto start = std::chrono::steady_clock::now();
    rprop_ = locate_rivals::rprop(table_, points_, rprop_ * way);
    const auto middle = std::chrono::steady_clock::now();
    cloud_.move(way);
    cloud_.weigh(table_, points_);
    const Pose<Field, Robot> mean = cloud_.estimate();
    const auto end = std::chrono::steady_clock::now();
    if (frame < kSettled) return;
    using Milliseconds = std::chrono::duration<double, std::milli>;
    const Eigen::Vector2d none = Eigen::Vector2d::Zero();
    result.frames.tallies["rprop10"].add(
        {rprop_, {}, Milliseconds(middle - start).count()}, drive_.truth(), none, std::nullopt);
    result.frames.tallies["mcl500"].add(
        {mean, {}, Milliseconds(end - middle).count()}, drive_.truth(), none, std::nullopt);
  }

  void finish(DriveResult& result) const {
    if (is_kidnapped_ && found_at_) {
      const double after = (*found_at_ - kKidnappedAt) * kFramePeriod;
      if (after <= 1.0) ++result.found_within_1s;
      result.slowest_s = std::max(result.slowest_s, after);
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
  vision::Localiser localiser_;
  vision::LocalisationState state_;
  vision::BackgroundSearch search_;
  locate_rivals::DistanceTable table_;
  locate_rivals::MonteCarlo cloud_;
  Pose<Field, Robot> rprop_;
  Pose<teamsight::Drive, Robot> last_wheels_;
  std::vector<vision::LinePoint> points_;
  std::optional<vision::SearchAnswer> answer_;
  int answer_in_{0};
  std::optional<int> found_at_;
  std::optional<int> repaired_at_;
  double false_ok_{0.0};
};

}  // namespace

DriveResult run_drives(const CaseOptions& options) {
  RenderedView view(options.camera, options.camera, options.field, options.pixel_noise_sigma);
  DriveResult result;
  result.frames.name = "drive";
  const auto sequences = static_cast<std::uint32_t>(std::max<std::size_t>(4, options.poses / 25));
  for (std::uint32_t number = 0; number < sequences; ++number) {
    Sequence(options, view, number).run(result);
  }
  return result;
}

}  // namespace teamsight::locate_score
