// vision/localisation/localisation.hpp: where the robot is, followed over time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.hpp"
#include "geometry/sighting.hpp"
#include "geometry/time.hpp"
#include "vision/line_map.hpp"
#include "vision/line_points.hpp"
#include "vision/localisation/half_odds.hpp"
#include "vision/localisation/hypothesis.hpp"
#include "vision/localisation/motion_log.hpp"
#include "vision/localisation/wide_fit.hpp"
#include "vision/posture.hpp"
#include "vision/posture_fit.hpp"
#include "vision/posture_search.hpp"

namespace teamsight::vision {

/// What the localisation is told before it starts.
struct LocalisationParameters {
  StartSide start_side{StartSide::kUnknown};
  /// Where the camera looks from, and how far the head may lean when nothing tells the
  /// acceleration.
  HeadTilt tilt{.sigma = Eigen::Vector2d::Constant(0.0052)};
  double sigma_lean{0.0008};            ///< of the lean of a robot that drives evenly; rad
  double lean_per_acceleration{0.005};  ///< sigma of the lean; rad per m/s^2
  double sigma_tilt_drift{0.0003};      ///< of the head's constant tilt; rad per root second
  /// What the camera file may be wrong by. Never averaged away.
  SharedError shared{};
  MotionParameters motion{};
  DriveLimits limits{};
};

/// What was counted since the start.
struct LocalisationCounts {
  std::uint64_t frames{0};
  std::uint64_t frames_not_finite{0};
  std::uint64_t frames_backwards{0};  ///< older than anything remembered
  std::uint64_t frames_late{0};       ///< older than the newest, taken in by replay
  std::uint64_t inputs_not_finite{0};
  std::uint64_t inputs_backwards{0};
  std::uint64_t misses{0};     ///< frames whose lines did not support the expected posture
  std::uint64_t surprises{0};  ///< frames whose posture lay outside the gate
  std::uint64_t slips{0};      ///< times the wheels were found to slip
  std::uint64_t jumps{0};      ///< times another hypothesis became the best
  std::uint64_t flips{0};      ///< times the half was changed
};

/// What one frame said about one hypothesis.
struct PostureFix {
  std::uint32_t hypothesis{0};
  PostureFit fit;
};

/// A frame as the localisation remembers it, to take in a later frame at its own time.
struct RememberedFrame {
  HostTime exposure{};
  Belief before;  ///< at the frame before
  std::array<PostureFix, kMaxHypotheses> fixes;
  std::size_t count{0};
  std::size_t points{0};
};

/// Everything that is known; a value.
struct LocalisationState {
  MotionLog log;
  Belief belief;  ///< at the exposure of the newest frame
  std::array<RememberedFrame, 12> memory;
  std::size_t remembered{0};
  std::uint32_t next_id{1};

  Eigen::Vector2d tilt{Eigen::Vector2d::Zero()};            ///< of the head at rest; rad
  Eigen::Vector2d var_tilt{Eigen::Vector2d::Constant(-1)};  ///< rad^2; negative: not begun
  double correlation{1.0};                                  ///< N / N_eff of line points, smoothed
  double usual_support{-1.0};  ///< votes per point while all was well; negative: not known

  HostTime last_fix{};     ///< when the best hypothesis was last corrected
  HostTime doubt_since{};  ///< zero: no doubt
  HostTime slip_until{};
  HostTime last_search{};
  HostTime last_compass{};
  std::optional<PostureFix> last_posture;  ///< of the frame at last_fix
  bool is_searching{false};
  bool has_started{false};  ///< the start side has done its duty
  bool is_rivalled{false};
  /// While rivalled: how far the surprise was from what was expected, in R; m, m, rad.
  Eigen::Vector3d rival_gap{Eigen::Vector3d::Zero()};
  int frames_to_flip{0};
  int frames_backwards{0};
  double team_log_odds{0.0};  ///< what the team says of the best hypothesis' half
  LocalisationCounts counts;
};

/// One frame's evidence.
struct FrameEvidence {
  HostTime exposure{};
  std::span<const LinePoint> points;
  std::span<const GoalBearing> goals{};
};

/// What is said after a frame.
struct Located {
  PostureEstimate posture;         ///< at the frame's exposure; half_log_odds is the own evidence
  double half_log_odds_team{0.0};  ///< the team's, kept apart
  Eigen::Vector2d tilt{Eigen::Vector2d::Zero()};  ///< roll, pitch in that frame; rad
  double scale{1.0};                              ///< see PostureFit
  double nis{0.0};  ///< of the best hypothesis, over 3; 0: not corrected
  bool is_slipping{false};
};

/// Line points for a search over the whole field; the search may take its time elsewhere.
struct SearchRequest {
  HostTime exposure{};
  std::vector<LinePoint> points;
  HeadTilt tilt;
  /// Where the robot was thought to be, and how well that fitted; nothing: no idea.
  std::optional<PostureFit> tracked;
};

struct SearchAnswer {
  HostTime exposure{};
  std::optional<PostureFit> tracked;
  std::vector<PostureFit> places;  ///< best first, one of each pair of mirror images
};

/// Searches the whole field: up to 25 ms. A function of the request; for a background thread.
class BackgroundSearch {
 public:
  explicit BackgroundSearch(const FieldModel& field);

  [[nodiscard]] SearchAnswer answer(const SearchRequest& request);

 private:
  LineMap map_;
  PostureFitter fitter_;
  PostureSearch search_;
};

/// Follows the robot: several hypotheses, each corrected by robust Gauss-Newton on the frame's line
/// points and carried on by wheels and gyro between frames; doubts itself, asks for a search, and
/// weighs what the search found against what it believed.
///
/// Tables and buffers only; everything known is in a LocalisationState. Thread rule: one thread.
class Localiser {
 public:
  Localiser(const FieldModel& field, const LocalisationParameters& parameters);

  /// Nothing known yet.
  [[nodiscard]] LocalisationState begin() const;

  /// Takes one frame in at its exposure; an older one than the last by replay. Not finite or older
  /// than all that is remembered: counted, and the state is as before.
  Located see(LocalisationState& state, const FrameEvidence& frame);

  /// Readings between frames; bad ones are counted and dropped.
  void roll(LocalisationState& state, const WheelReading& reading) const;
  void turn(LocalisationState& state, const GyroReading& reading) const;
  void point(LocalisationState& state, const CompassReading& reading) const;

  /// What the team says: log-odds that the robot stands where it thinks rather than mirrored.
  void hear_team(LocalisationState& state, double log_odds) const;

  /// Put there by hand, or by the coach, half and all.
  void place(LocalisationState& state,
             const Pose<Field, Robot>& X_FR,
             const Eigen::Matrix3d& cov,
             HostTime when) const;

  /// A search to be made for the frame just seen; nothing if none is needed now.
  [[nodiscard]] std::optional<SearchRequest> wanted_search(LocalisationState& state,
                                                           const FrameEvidence& frame) const;

  /// Takes in what a search found, at the time of its points.
  void insert(LocalisationState& state, const SearchAnswer& answer) const;

  /// The best hypothesis at any time after the last frame; nothing if there is none.
  [[nodiscard]] std::optional<Hypothesis> at(const LocalisationState& state, HostTime when) const;

  /// What could be said without another frame.
  [[nodiscard]] Located report(const LocalisationState& state) const;

  [[nodiscard]] const LineMap& map() const { return map_; }

 private:
  void predict(const LocalisationState& state, Belief& belief, HostTime to) const;
  /// Of the lean against the tilt at rest; rad. Nothing if nothing tells the acceleration.
  [[nodiscard]] std::optional<double> sigma_lean(const LocalisationState& state,
                                                 HostTime exposure) const;
  [[nodiscard]] HeadTilt expected_tilt(const LocalisationState& state, HostTime exposure) const;
  void take(LocalisationState& state, const FrameEvidence& frame, RememberedFrame& memory);
  void learn(LocalisationState& state, const PostureFit& fit, const RememberedFrame& memory) const;
  void weigh(Belief& belief, const RememberedFrame& memory) const;
  void notice_slip(LocalisationState& state, const PostureFix& fix, HostTime exposure) const;
  void watch_slip(LocalisationState& state, Belief& belief, const RememberedFrame& memory) const;
  /// @return how far off the fit was, in R, if it was a surprise, before which the hypothesis gave
  /// way
  std::optional<Eigen::Vector3d> take_fix(const LocalisationState& state,
                                          Hypothesis& one,
                                          const PostureFit& fit,
                                          HostTime exposure) const;
  void correct_best(LocalisationState& state,
                    Hypothesis& best,
                    const RememberedFrame& memory) const;
  void correct_all(LocalisationState& state, Belief& belief, const RememberedFrame& memory) const;
  void doubt(LocalisationState& state, HostTime when) const;
  void weigh_halves(LocalisationState& state, const FrameEvidence& frame) const;
  [[nodiscard]] bool supports(const LocalisationState& state,
                              const PostureFit& fit,
                              std::size_t points) const;
  /// A hypothesis whose velocity is not known; weight and half are left open.
  [[nodiscard]] Hypothesis standing_at(LocalisationState& state,
                                       const Pose<Field, Robot>& X_FR,
                                       const Eigen::Matrix3d& cov) const;
  /// How far a push since the last fix can have moved and turned the robot; m and rad.
  [[nodiscard]] double reach_of_a_push(const LocalisationState& state, HostTime now) const;
  /// What a fit that surprises leaves of a hypothesis' half.
  void keep_half(const LocalisationState& state,
                 Hypothesis& one,
                 const PostureFit& fit,
                 HostTime exposure) const;
  /// Weight and half of a place that a search found, by what was believed at that moment.
  void join(const LocalisationState& state, Hypothesis& found, const Belief& before) const;
  /// @param exposure  of the search's frame; the hypothesis is one at `before.at`
  [[nodiscard]] Hypothesis from_search(LocalisationState& state,
                                       const PostureFit& place,
                                       HostTime exposure,
                                       const Belief& before) const;
  /// Makes a place that a search found a hypothesis. @return true if it was the best one already
  bool take_place(LocalisationState& state,
                  const PostureFit& place,
                  const SearchAnswer& answer,
                  const Belief& before) const;
  bool take_late(LocalisationState& state, const FrameEvidence& frame);
  void restart_clock(LocalisationState& state, HostTime exposure) const;
  [[nodiscard]] PostureStatus status_of(const LocalisationState& state) const;

  LocalisationParameters parameters_;
  LineMap map_;
  bool symmetric_;
  WideFitter fitter_;
};

}  // namespace teamsight::vision
