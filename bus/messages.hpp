// bus/messages.hpp: the topics as values, one struct per topic of idl/teamsight.idl.
//
// The world model and its parts are in geometry/, because the core speaks of them too. Stamps are
// PeerTime: the clock of whoever wrote the sample. `from_wire` establishes what each field
// promises.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/identity.hpp"
#include "geometry/pose.hpp"
#include "geometry/sighting.hpp"
#include "geometry/time.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::bus {

/// What one robot says of itself, once per frame.
struct RobotState {
  ObservationId id;
  PeerTime exposure;
  PeerTime published;
  PostureEstimate posture;                ///< at `exposure`
  Velocity<Robot> v_R;                    ///< of R over the floor; m/s
  double omega{0.0};                      ///< rad/s
  double half_log_odds_team{0.0};         ///< what the team told it, kept apart from its own
  std::uint32_t command_acknowledged{0};  ///< id of the last command carried out; 0 = none
  bool playing{true};
  bool sees_ball{false};
  bool has_ball{false};
  bool camera_lost{false};        ///< no frame for longer than three frame times
  bool muted{false};              ///< says nothing of what it sees, by the operator's command
  double frame_rate{0.0};         ///< Hz
  double battery{0.0};            ///< V; 0 = not measured
  double cpu_load{0.0};           ///< of one core, this process
  double cpu_temperature{0.0};    ///< degrees Celsius; 0 = not measured
  double calibration_drift{0.0};  ///< robust mean radial residual of the lines, px; 0 = unknown
  std::string software_version;   ///< at most 15 characters

  friend bool operator==(const RobotState&, const RobotState&) = default;
};

enum class Light : std::uint8_t { kUnknown, kGood, kDark, kGlare, kCovered };

/// Everything one robot saw in one frame, in R, with the posture that takes it to F.
struct Sightings {
  ObservationId id;
  PeerTime exposure;
  PeerTime published;
  PostureEstimate posture;  ///< at `exposure`
  Light light{Light::kUnknown};
  std::vector<BallRay> balls;               ///< at most kMaxBallRays
  std::vector<ObstacleSighting> obstacles;  ///< at most kMaxObstacleSightings

  friend bool operator==(const Sightings&, const Sightings&) = default;
};

struct SensorReading {
  std::string name;   ///< at most 23 characters
  double value{0.0};  ///< share of the window in the sensor's colours, in [0, 1]
  bool triggered{false};

  friend bool operator==(const SensorReading&, const SensorReading&) = default;
};

struct VirtualSensors {
  ObservationId id;
  PeerTime exposure;
  std::vector<SensorReading> readings;  ///< at most 24

  friend bool operator==(const VirtualSensors&, const VirtualSensors&) = default;
};

struct Odometry {
  ObservationId id;
  PeerTime stamp;
  Pose<Drive, Robot> X_DR;
  Velocity<Robot> v_R;      ///< m/s
  double omega{0.0};        ///< rad/s
  double sigma_v{0.0};      ///< m/s
  double sigma_omega{0.0};  ///< rad/s
  bool slipping{false};
  double gyro{0.0};           ///< turning rate by a gyro; rad/s
  double sigma_gyro{0.0};     ///< rad/s; 0 = there is no gyro
  double heading{0.0};        ///< of R's x axis in F, by a compass; rad
  double sigma_heading{0.0};  ///< rad; 0 = there is no compass

  friend bool operator==(const Odometry&, const Odometry&) = default;
};

enum class TrackKind : std::uint8_t { kBall, kObstacle };

struct ExplainedTrack {
  std::uint32_t track{0};
  TrackKind kind{TrackKind::kBall};
  RobotMask supporters{0};
  RobotMask rejected{0};
  std::chrono::seconds born_ago{0};
  double nis{0.0};  ///< mean normalised innovation squared per degree of freedom; 0 = none yet

  friend bool operator==(const ExplainedTrack&, const ExplainedTrack&) = default;
};

struct ExplainedRobot {
  RobotId robot{kNobody};
  double trust{0.0};  ///< in [0, 1]
  Quarantine quarantine{Quarantine::kNone};
  std::uint32_t accepted{0};
  std::uint32_t rejected_gate{0};
  std::uint32_t rejected_late{0};
  std::uint32_t rejected_duplicate{0};
  std::uint32_t rejected_posture{0};
  Duration clock_offset{0};  ///< peer minus the leader's host
  Duration clock_sigma{0};   ///< 0 = not estimated

  friend bool operator==(const ExplainedRobot&, const ExplainedRobot&) = default;
};

/// The operator's newest ball hint, as the leading fusion has it.
struct ExplainedHint {
  std::uint32_t command{0};  ///< that brought it; 0 = none was taken
  std::uint32_t track{0};    ///< the ball that it means; 0 = none is seen there
  Duration left{0};          ///< how long it still counts; 0 = over

  friend bool operator==(const ExplainedHint&, const ExplainedHint&) = default;
};

struct Explanation {
  ObservationId id;
  PeerTime stamp;
  std::vector<ExplainedTrack> tracks;  ///< at most 14
  std::vector<ExplainedRobot> robots;  ///< at most 16
  ExplainedHint hint;

  friend bool operator==(const Explanation&, const Explanation&) = default;
};

struct ClockProbe {
  ObservationId id;  ///< robot = the host that asks
  PeerTime sent;

  friend bool operator==(const ClockProbe&, const ClockProbe&) = default;
};

struct ClockReply {
  ObservationId probe;  ///< the probe answered
  PeerTime received;    ///< answerer's clock

  friend bool operator==(const ClockReply&, const ClockReply&) = default;
};

struct ClockEcho {
  ObservationId id;                 ///< robot = the host that answers
  PeerTime sent;                    ///< just before the write
  std::vector<ClockReply> replies;  ///< at most 16

  friend bool operator==(const ClockEcho&, const ClockEcho&) = default;
};

enum class GamePhase : std::uint8_t {
  kUnknown,
  kBefore,
  kFirstHalf,
  kHalfTime,
  kSecondHalf,
  kOver,
  kShootout
};
enum class SetPiece : std::uint8_t {
  kNone,
  kKickoff,
  kFreekick,
  kGoalkick,
  kThrowin,
  kCorner,
  kPenalty,
  kDropball,
  kPark
};

struct GameState {
  ObservationId id;
  PeerTime stamp;
  GamePhase phase{GamePhase::kUnknown};
  SetPiece piece{SetPiece::kNone};
  bool piece_is_ours{false};
  bool running{false};
  std::uint8_t goals_own{0};
  std::uint8_t goals_opponent{0};
  bool box_connected{false};
  Duration command_age{0};

  friend bool operator==(const GameState&, const GameState&) = default;
};

enum class CommandKind : std::uint8_t {
  kNone,
  kRelocate,
  kMute,
  kUnmute,
  kBallHint,
  kLinePoints,
  kThumbnail
};

struct Command {
  ObservationId id;
  RobotId target{kNobody};   ///< kNobody = all robots
  std::uint32_t command{0};  ///< acknowledged in RobotState, a hint in Explanation; never 0
  CommandKind kind{CommandKind::kNone};
  Pose<Field, Robot> X_FR;  ///< relocate: the posture; ball hint: x and y
  Eigen::Matrix3d cov{Eigen::Matrix3d::Identity()};
  Duration duration{0};  ///< how long line points and thumbnails go on

  friend bool operator==(const Command&, const Command&) = default;
};

struct Counter {
  std::string name;  ///< at most 39 characters
  std::uint64_t value{0};

  friend bool operator==(const Counter&, const Counter&) = default;
};

struct Diagnostics {
  std::string process;  ///< at most 39 characters, e.g. "agent/3"
  ObservationId id;
  PeerTime stamp;
  bool healthy{true};
  std::string message;        ///< what is wrong and what to do; at most 95 characters
  double frame_age_ms{-1.0};  ///< -1 = none yet, or no camera
  double step_ms_p50{0.0};
  double step_ms_p95{0.0};
  double cpu_load{0.0};  ///< of one core
  std::uint32_t resident_kb{0};
  double wire_bps{0.0};    ///< bit/s that this process sends to the team, headers included
  std::uint8_t thrift{0};  ///< what it leaves out since the air is full: process::Thrift, at most 4
  bool secured{false};     ///< DDS Security is on
  std::vector<Counter> counters;  ///< at most 18

  friend bool operator==(const Diagnostics&, const Diagnostics&) = default;
};

struct LinePoint {
  Point<Robot> p_R;  ///< within +-32 m
  bool inlier{false};

  friend bool operator==(const LinePoint&, const LinePoint&) = default;
};

struct LinePoints {
  ObservationId id;
  PeerTime exposure;
  std::vector<LinePoint> points;  ///< at most 200

  friend bool operator==(const LinePoints&, const LinePoints&) = default;
};

struct Thumbnail {
  ObservationId id;
  PeerTime exposure;
  std::uint16_t width_px{0};
  std::uint16_t height_px{0};
  std::vector<std::uint8_t> jpeg;  ///< at most 32768 bytes

  friend bool operator==(const Thumbnail&, const Thumbnail&) = default;
};

struct TrueRobot {
  std::uint8_t robot{0};  ///< 1..16 own, 17..32 opponents
  Pose<Field, Robot> X_FR;
  Velocity<Field> v_FR;

  friend bool operator==(const TrueRobot&, const TrueRobot&) = default;
};

struct Truth {
  ObservationId id;
  PeerTime stamp;
  Point3<Field> p_FB;
  Velocity3<Field> v_FB;
  std::vector<TrueRobot> robots;  ///< at most 20

  friend bool operator==(const Truth&, const Truth&) = default;
};

}  // namespace teamsight::bus
