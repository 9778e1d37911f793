// bench/camera_play/camera_eyes.cpp: see camera_eyes.hpp.
#include "bench/camera_play/camera_eyes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "bench/camera_play/shown.hpp"
#include "bench/play/network.hpp"
#include "bench/play/play_log.hpp"
#include "geometry/expect.hpp"
#include "sim/match/wheels.hpp"
#include "sim/render/defects.hpp"
#include "sim/show.hpp"
#include "vision/localisation/localisation.hpp"
#include "vision/perception.hpp"

namespace teamsight::camera_play {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTableScale = 0.0002;        // dimensionless
constexpr double kTableShift = 0.05;          // pixels
constexpr double kRobotHeight = 0.8;          // m
constexpr double kBumped = 3.0 * kPi / 180;   // rad
constexpr int kFramesBefore = 5;              // looks around before the first moment
constexpr double kBetweenFramesBefore = 0.1;  // s
// What a person can pace out and see, as teamsight-agent takes it; 1 sigma, and how far off they
// are here.
const Eigen::Vector3d kToldSigma(0.5, 0.5, 0.3);
constexpr double kToldOff = 0.2;       // m
constexpr double kToldTurned = 0.1;    // rad
constexpr double kFreeOfOthers = 0.8;  // m

/// What a calibration leaves: some 6 mm at 6 m (locate_score::CalibrationRemainder). Of a mirror of
/// known shape that is a tenth of what assembly by hand gets wrong; of a table, whose rim shows
/// more floor per pixel, 0.05 pixels of shift and as much at the rim by its scale.
sim::DefectSizes remainder_of(const vision::CameraParameters& camera) {
  if (std::holds_alternative<vision::RadialTable>(camera.mirror)) {
    return {0.0, 0.0, 0.0, 0.0, kTableScale, kTableShift};
  }
  sim::DefectSizes sizes;
  for (double* size : {&sizes.sigma_lateral,
                       &sizes.sigma_axial,
                       &sizes.sigma_mirror_tilt,
                       &sizes.sigma_head_tilt,
                       &sizes.sigma_focal}) {
    *size *= 0.1;
  }
  return sizes;
}

sim::PictureParameters look_of(const CameraSetup& setup) {
  sim::PictureParameters picture = setup.picture;
  if (picture.body.empty()) picture.body = sim::low_body();
  return picture;
}

/// One robot: its eye, its wheels, and what it knows.
struct RobotEye {
  sim::Renderer renderer;
  sim::Random random;
  sim::Wheels wheels;
  vision::LocalisationState state;
  std::optional<vision::SearchAnswer> answer;  // of a search that the last frame asked for
  std::uint32_t sequence{0};
  play::Fault fault{play::Fault::kNone};
};

std::uint8_t number_of(const play::Moment& moment, std::size_t player, std::size_t own) {
  if (player < own) return moment.players[player].robot;
  return static_cast<std::uint8_t>(sim::kFirstOpponent + player - own);
}

/// A moment of the play as the simulator's moments are. @param before  the step before
sim::MatchState match_state(const play::Moment& moment, const play::Moment& before) {
  sim::MatchState state;
  const auto own = static_cast<std::size_t>(std::ranges::count_if(
      moment.players, [](const auto& player) { return player.robot != kNobody; }));
  for (std::size_t i = 0; i < moment.players.size(); ++i) {
    const play::TruePlayer& now = moment.players[i];
    sim::Player player;
    player.number = number_of(moment, i, own);
    player.X_FR = now.X_FR;
    const double seconds = moment.t - before.t;
    // Also bodies that are pushed turn their wheels.
    const Eigen::Vector2d way =
        now.X_FR.origin().vector() - before.players[i].X_FR.origin().vector();
    const Eigen::Vector2d v_F = seconds > 0.0 ? Eigen::Vector2d(way / seconds) : now.v_F;
    player.v_FR = {v_F.x(), v_F.y()};
    player.wheels_F = player.v_FR;
    player.omega = now.omega;
    state.players.push_back(player);
  }
  for (const play::TrueBall& ball : moment.balls) {
    state.balls.push_back(
        {Point3<Field>::from(ball.p_F), {ball.v_F.x(), ball.v_F.y(), ball.v_F.z()}});
  }
  return state;
}

}  // namespace

bool can_have(play::Fault fault, const vision::CameraParameters& camera) {
  return fault != play::Fault::kBiased ||
         std::holds_alternative<vision::ProfileMirror>(camera.mirror);
}

struct CameraEyes::Team {
  Team(const CameraSetup& made_with, const play::Scenario& scenario, std::uint64_t seed64);

  void bump(std::size_t robot);
  void look_around(std::size_t robot, const play::Moment& first);
  [[nodiscard]] Pose<Field, Robot> elsewhere(std::size_t robot, const play::Moment& first);
  vision::PostureResult locate(RobotEye& eye,
                               const vision::Perception::Cues& cues,
                               HostTime exposure);
  const vision::FrameObservation& see(std::size_t robot, HostTime exposure);
  [[nodiscard]] vision::CameraParameters true_camera(std::size_t robot,
                                                     const Eigen::Vector2d& bump) const;
  [[nodiscard]] sim::Renderer renderer(std::size_t robot, const Eigen::Vector2d& bump) const;

  CameraSetup setup;
  play::PlayParameters play;
  std::uint32_t seed;
  sim::Bodies bodies;
  // Neither remembers anything from frame to frame, so that all robots share them.
  vision::Perception perception;
  vision::Localiser localiser;
  vision::BackgroundSearch search;
  std::vector<RobotEye> robots;
  play::Moment last;
  sim::MatchState state;
  sim::Scene scene;
  std::vector<std::uint8_t> picture;
  std::vector<vision::GoalBearing> goals;
};

namespace {

vision::PerceptionParameters perception_of(const play::PlayParameters& play) {
  vision::PerceptionParameters parameters;
  parameters.ball_radius = play.ball_radius;
  parameters.robot_radius = play.robot_radius;
  // The colours that sim::show paints.
  parameters.shirts = {vision::ColourClass::kCyan, vision::ColourClass::kMagenta};
  return parameters;
}

vision::LocalisationParameters localisation_of(const vision::Perception& perception) {
  vision::LocalisationParameters parameters;
  parameters.tilt = perception.head();
  return parameters;
}

}  // namespace

CameraEyes::Team::Team(const CameraSetup& made_with,
                       const play::Scenario& scenario,
                       std::uint64_t seed64)
    : setup(made_with),
      play(scenario.play),
      seed(static_cast<std::uint32_t>(seed64 * 131)),
      bodies{play.ball_radius,
             play.robot_radius,
             kRobotHeight,
             sim::people_around(made_with.field, static_cast<std::uint32_t>(seed64))},
      perception(made_with.camera, made_with.field, perception_of(play)),
      localiser(made_with.field, localisation_of(perception)),
      search(made_with.field) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(play.own); ++i) {
    const auto own_seed = seed + static_cast<std::uint32_t>(i) + 1;
    robots.push_back({renderer(i, Eigen::Vector2d::Zero()),
                      sim::Random(own_seed),
                      sim::Wheels({}, own_seed),
                      localiser.begin(),
                      {}});
  }
}

vision::CameraParameters CameraEyes::Team::true_camera(std::size_t robot,
                                                       const Eigen::Vector2d& bump) const {
  const auto own_seed = seed + static_cast<std::uint32_t>(robot) + 1;
  sim::CameraDefects defects = sim::draw_defects(own_seed, remainder_of(setup.camera));
  defects.mirror_tilt[0] += bump.x();
  defects.mirror_tilt[1] += bump.y();
  return sim::with_defects(setup.camera, defects);
}

/// All see one floor.
sim::Renderer CameraEyes::Team::renderer(std::size_t robot, const Eigen::Vector2d& bump) const {
  return {true_camera(robot, bump),
          setup.field,
          look_of(setup),
          robots.empty() ? nullptr : robots.front().renderer.floor()};
}

void CameraEyes::Team::bump(std::size_t robot) {
  const double direction = robots[robot].random.uniform(-kPi, kPi);
  const Eigen::Vector2d tilt(kBumped * std::cos(direction), kBumped * std::sin(direction));
  robots[robot].renderer = renderer(robot, tilt);
}

/// A place on the carpet where nobody stands.
Pose<Field, Robot> CameraEyes::Team::elsewhere(std::size_t robot, const play::Moment& first) {
  sim::Random& random = robots[robot].random;
  for (;;) {
    const Pose<Field, Robot> pose(random.uniform(-0.45, 0.45) * setup.field.length,
                                  random.uniform(-0.45, 0.45) * setup.field.width,
                                  random.uniform(-kPi, kPi));
    const bool is_free = std::ranges::all_of(first.players, [&](const play::TruePlayer& player) {
      return (player.X_FR.origin().vector() - pose.origin().vector()).norm() > kFreeOfOthers;
    });
    if (is_free) return pose;
  }
}

void CameraEyes::Team::look_around(std::size_t robot, const play::Moment& first) {
  RobotEye& eye = robots[robot];
  play::Moment before = first;
  if (eye.fault == play::Fault::kKidnapped) {
    before.players[robot].X_FR = elsewhere(robot, first);
  }
  const Pose<Field, Robot>& truth = before.players[robot].X_FR;
  Pose<Field, Robot> told(truth.x() + eye.random.normal(kToldOff),
                          truth.y() + eye.random.normal(kToldOff),
                          truth.theta() + eye.random.normal(kToldTurned));
  if (eye.fault == play::Fault::kMirrored) told = mirrored(told, setup.field.centre);
  const HostTime start = play::host_time(-kFramesBefore * kBetweenFramesBefore);
  localiser.place(eye.state, told, kToldSigma.cwiseAbs2().asDiagonal(), start);
  state = match_state(before, before);
  for (sim::Player& player : state.players) player.v_FR = player.wheels_F = {};
  for (int frame = 0; frame < kFramesBefore; ++frame) {
    (void)see(robot, start + from_seconds(frame * kBetweenFramesBefore));
  }
}

vision::PostureResult CameraEyes::Team::locate(RobotEye& eye,
                                               const vision::Perception::Cues& cues,
                                               HostTime exposure) {
  goals.clear();
  for (const vision::SeenGoal& goal : cues.goals) goals.push_back(vision::bearing_of(goal));
  const vision::FrameEvidence evidence{exposure, cues.line_points, goals};
  const vision::Located located = localiser.see(eye.state, evidence);
  if (const auto request = localiser.wanted_search(eye.state, evidence)) {
    eye.answer = search.answer(*request);
  }
  vision::PostureResult result;
  result.estimate = located.posture;
  result.scale = located.scale;
  result.tilt = located.tilt;
  return result;
}

/// What the robot sees of `state`.
const vision::FrameObservation& CameraEyes::Team::see(std::size_t robot, HostTime exposure) {
  RobotEye& eye = robots[robot];
  sim::show(state, robot, bodies, scene);
  eye.renderer.draw(scene, eye.random, picture);
  if (eye.answer) localiser.insert(eye.state, *std::exchange(eye.answer, std::nullopt));
  const vision::CameraParameters& camera = setup.camera;
  const auto seen =
      perception.see_with({picture, camera.width_px, camera.height_px, camera.format},
                          [&](const auto& cues) { return locate(eye, cues, exposure); });
  TEAMSIGHT_EXPECT(seen.has_value());
  return **seen;
}

namespace {

/// Topics carry the upper halves of covariances, whose halves can differ in the last bit.
void carry(fusion::Observation& observation) {
  const auto mirror_upper = [](auto& cov) {
    cov = cov.template selfadjointView<Eigen::Upper>().toDenseMatrix().eval();
  };
  mirror_upper(observation.posture.cov);
  for (BallRay& ball : observation.balls) mirror_upper(ball.cov_direction);
  for (ObstacleSighting& obstacle : observation.obstacles) mirror_upper(obstacle.cov_R);
}

}  // namespace

CameraEyes::CameraEyes(const CameraSetup& setup, const play::Scenario& scenario, std::uint64_t seed)
    : team_(std::make_unique<Team>(setup, scenario, seed)) {
  const FieldModel expected = play::play_field();
  TEAMSIGHT_EXPECT(setup.field.length == expected.length && setup.field.width == expected.width);
}

CameraEyes::~CameraEyes() = default;

void CameraEyes::set_fault(std::size_t robot, play::Fault fault, const play::Moment& moment) {
  TEAMSIGHT_EXPECT(moment.t == 0.0 && can_have(fault, team_->setup.camera));
  team_->robots[robot].fault = fault;
  if (fault == play::Fault::kBiased) team_->bump(robot);
}

void CameraEyes::begin(const play::Moment& first) {
  for (std::size_t i = 0; i < team_->robots.size(); ++i) team_->look_around(i, first);
  team_->last = first;
}

void CameraEyes::step(const play::Moment& moment) {
  team_->state = match_state(moment, team_->last);
  for (std::size_t i = 0; i < team_->robots.size(); ++i) {
    RobotEye& eye = team_->robots[i];
    eye.wheels.roll(team_->state.players[i], moment.t - team_->last.t);
    const sim::WheelParameters claimed;
    team_->localiser.roll(eye.state,
                          {play::host_time(moment.t),
                           eye.wheels.pose(),
                           eye.wheels.velocity(),
                           eye.wheels.omega(),
                           claimed.sigma_v,
                           claimed.sigma_omega});
  }
  team_->last = moment;
}

play::Frame CameraEyes::look(std::size_t robot, const play::Moment& moment, double /*since*/) {
  const vision::FrameObservation& seen = team_->see(robot, play::host_time(moment.t));
  const auto id = static_cast<RobotId>(robot + 1);
  play::Frame frame;
  frame.observation.id = {id, 1000U + id, ++team_->robots[robot].sequence};
  frame.observation.posture = seen.posture;
  frame.observation.balls.assign(
      seen.balls.begin(),
      seen.balls.begin() + static_cast<std::ptrdiff_t>(std::min(seen.balls.size(), kMaxBallRays)));
  frame.observation.obstacles = seen.obstacles;
  carry(frame.observation);
  tell_shown(moment, robot, team_->play.robot_radius, frame);
  return frame;
}

}  // namespace teamsight::camera_play
