// tests/fusion/consistency_test.cpp: errors are as large as the covariances say, over many seeds.
#include <cmath>
#include <cstdio>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "fusion/clock_offset.hpp"
#include "fusion/fusion.hpp"
#include "geometry/uncertainty.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;
using test::Eye;
using test::normal;
using test::Random;

constexpr double kFrame = 1.0 / 30.0;

/// Mean of squared normalised errors, to be compared with their degrees of freedom.
class SquaredErrors {
 public:
  void add(const Eigen::VectorXd& error, const Eigen::MatrixXd& cov) {
    sum_ += squared_mahalanobis(error, cov);
    ++count_;
  }

  void add(double squared) {
    sum_ += squared;
    ++count_;
  }

  /// Within 3.3 standard deviations (99.9 %) of a chi-square mean, plus `slack` for what is known
  /// to be approximate: relative, dimensionless.
  /// @param each  how many pairs of degrees of freedom each added number is a mean of; 0 = it is
  /// none
  void expect_chi_square(int degrees, double slack, int each = 0) const {
    ASSERT_GT(count_, 100);
    const double samples = each == 0 ? count_ : 2.0 * each * count_;
    const double spread = 3.3 * std::sqrt(2.0 * degrees / samples);
    EXPECT_NEAR(sum_ / count_, degrees, spread + slack * degrees) << "over " << count_;
  }

  [[nodiscard]] double mean() const { return sum_ / count_; }

  /// Within these shares of the degrees of freedom.
  void expect_between(int degrees, double least, double most) const {
    ASSERT_GT(count_, 100);
    EXPECT_GT(sum_ / count_, least * degrees) << "over " << count_;
    EXPECT_LT(sum_ / count_, most * degrees) << "over " << count_;
  }

 private:
  double sum_{0.0};
  int count_{0};
};

/// Something that moves as a filter assumes: velocity fades and is disturbed by white acceleration.
struct Mover {
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};
  Eigen::Vector2d v_F{Eigen::Vector2d::Zero()};

  void move(double dt, const TrackParameters& motion, Random& random) {
    const double psd = motion.acceleration_psd;
    Eigen::Matrix2d cov;
    cov << dt * dt * dt / 3.0, dt * dt / 2.0, dt * dt / 2.0, dt;
    const Eigen::Matrix2d root = (psd * cov).llt().matrixL();
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d draw = root * Eigen::Vector2d(normal(random, 1.0), normal(random, 1.0));
      p_F(axis) += v_F(axis) * dt + draw(0);
      v_F(axis) += -motion.velocity_decay * v_F(axis) * dt + draw(1);
    }
  }
};

/// A ball that rolls, braked by the carpet and disturbed by white acceleration.
struct Roller {
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};
  Eigen::Vector2d v_F{Eigen::Vector2d::Zero()};

  void move(double dt, const BallMotion& motion, Random& random) {
    const double speed = v_F.norm();
    if (speed > 1e-9) v_F *= std::max(0.0, 1.0 - motion.friction * dt / speed);
    p_F += v_F * dt;
    const double push = std::sqrt(motion.rolling_psd * dt);
    v_F += Eigen::Vector2d(normal(random, push), normal(random, push));
  }
};

const Pose<Field, Robot> kStands[] = {{-3.0, -1.0, 0.4}, {2.5, 2.0, -2.0}, {0.5, -3.0, 1.6}};

/// Where a robot sees a thing that sees all too far by this share.
Point<Field> too_far(const Pose<Field, Robot>& X_FR, const Point<Field>& p_F, double share) {
  const Eigen::Vector2d from = X_FR.origin().vector();
  return Point<Field>::from(from + (1.0 + share) * (p_F.vector() - from));
}

/// Three robots watch a ball and an opponent for a second; what is the world worth at the end?
WorldModel watch(std::uint64_t seed, Roller& ball, Mover& opponent, Report& report) {
  Random random(seed);
  const test::EyeNoise noise{0.004, 0.05, 0.02, 0.005};
  Eye eyes[] = {{1, 11, noise}, {2, 22, noise}, {3, 33, noise}};
  Parameters parameters;
  parameters.ball_motion.kicks_at_foot = parameters.ball_motion.kicks_alone = 1e-6;
  double scales[3] = {};
  for (double& scale : scales) scale = normal(random, parameters.teammate.sigma_scale);
  Fusion fusion(parameters, test::plain_field());
  ball.v_F << normal(random, 1.5), normal(random, 1.5);
  opponent.p_F << -0.5, 1.5;
  HostTime now = at_second(0.0);
  for (int i = 0; i < 90; ++i) {
    const double dt = kFrame / 3.0;
    ball.move(dt, parameters.ball_motion, random);
    opponent.move(dt, parameters.obstacle, random);
    now += from_seconds(dt);
    Eye& eye = eyes[i % 3];
    eye.look(kStands[i % 3], now, &random);
    const auto seen = [&](const Eigen::Vector2d& p_F) {
      return too_far(kStands[i % 3], Point<Field>::from(p_F), scales[i % 3]);
    };
    eye.see_ball(seen(ball.p_F), &random);
    eye.see_obstacle(seen(opponent.p_F), &random);
    fusion.insert(eye.frame(), now);
  }
  report = fusion.report_at(now);
  return fusion.world_at(now);
}

/// Three robots watch a ball that is led round a circle at 1.5 m/s, with nobody near it.
SquaredErrors watch_led_ball(std::uint64_t seed, const Parameters& parameters) {
  constexpr double kCircle = 2.5;  // m
  constexpr double kSpeed = 1.5;   // m/s
  const auto ball_at = [&](double t) {
    const double angle = kSpeed / kCircle * t;
    return Point<Field>{kCircle * std::cos(angle), kCircle * std::sin(angle)};
  };
  Random random(seed);
  const test::EyeNoise noise{0.004, 0.05, 0.02, 0.005};
  Eye eyes[] = {{1, 11, noise}, {2, 22, noise}, {3, 33, noise}};
  Fusion fusion(parameters, test::plain_field());
  SquaredErrors errors;
  for (int i = 0; i < 900; ++i) {
    const double t = i * kFrame / 3.0;
    Eye& eye = eyes[i % 3];
    eye.look(kStands[i % 3], at_second(t), &random);
    eye.see_ball(ball_at(t), &random);
    fusion.insert(eye.frame(), at_second(t));
    if (t < 2.0) continue;
    const WorldModel world = fusion.world_at(at_second(t));
    if (world.balls.empty()) continue;
    const Eigen::Vector2d error =
        world.balls.front().p_FB.on_floor().vector() - ball_at(t).vector();
    errors.add(error, world.balls.front().cov_p.topLeftCorner<2, 2>());
  }
  return errors;
}

TEST(FusionConsistency, ABallThatIsLedIsFollowedAsWellAsIsSaid) {
  Parameters never_led;
  never_led.ball_motion.leads_alone = never_led.ball_motion.leads_at_foot = 0.0;
  double nees = 0.0;
  double nees_if_never_led = 0.0;
  constexpr int kRuns = 5;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    nees += watch_led_ball(seed, Parameters{}).mean() / (2.0 * kRuns);
    nees_if_never_led += watch_led_ball(seed, never_led).mean() / (2.0 * kRuns);
  }
  std::printf("NEES %.2f, as a ball that nobody leads %.2f\n", nees, nees_if_never_led);
  EXPECT_LT(nees, 1.3);
  EXPECT_GT(nees_if_never_led, 1.3);
}

TEST(FusionConsistency, ErrorsAndInnovationsFitTheirCovariances) {
  SquaredErrors ball_position;
  SquaredErrors ball_velocity;
  SquaredErrors obstacle_position;
  SquaredErrors ball_innovation;
  SquaredErrors obstacle_innovation;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Roller ball;
    Mover opponent;
    Report report;
    const WorldModel world = watch(seed, ball, opponent, report);
    ASSERT_FALSE(world.balls.empty()) << "seed " << seed;
    ASSERT_FALSE(world.obstacles.empty()) << "seed " << seed;
    const WorldBall& seen = world.balls.front();
    ball_position.add(seen.p_FB.on_floor().vector() - ball.p_F, seen.cov_p.topLeftCorner<2, 2>());
    ball_velocity.add(Eigen::Vector2d(seen.v_FB.x, seen.v_FB.y) - ball.v_F,
                      seen.cov_v.topLeftCorner<2, 2>());
    obstacle_position.add(world.obstacles.front().p_FO.vector() - opponent.p_F,
                          world.obstacles.front().cov_p);
    for (const TrackReport& track : report.tracks) {
      (track.is_ball ? ball_innovation : obstacle_innovation).add(track.nis);
    }
  }

  // Until it is known that these errors do not last, they are considered as if they did: wider than
  // needed in the first moments, never narrower.
  ball_position.expect_between(2, 0.5, 1.2);
  ball_velocity.expect_between(2, 0.8, 1.3);
  obstacle_position.expect_between(2, 0.8, 1.2);
  ball_innovation.expect_between(1, 0.8, 1.2);
  obstacle_innovation.expect_between(1, 0.7, 1.2);
}

/// How postures err when they are carried on for 50 ms.
///
/// @param kept  of a posture's error, what is left of it one frame later
SquaredErrors errors_of_carried(double kept) {
  const TeammateParameters parameters;
  TrackParameters motion;
  motion.acceleration_psd = parameters.acceleration_psd;
  TrackParameters turning;
  turning.acceleration_psd = parameters.angular_acceleration_psd;
  const Eigen::Vector3d sigma(0.03, 0.03, 0.01);
  SquaredErrors errors;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    Mover body;
    Mover heading;  // only its first axis counts
    heading.p_F.x() = 3.1;
    Eigen::Vector3d off;
    for (int axis = 0; axis < 3; ++axis) off(axis) = normal(random, sigma(axis));
    PostureTrack track;
    PostureJitter jitter;
    HostTime now = at_second(0.0);
    for (int i = 0; i < 60; ++i) {
      body.move(kFrame, motion, random);
      heading.move(kFrame, turning, random);
      now += from_seconds(kFrame);
      for (int axis = 0; axis < 3; ++axis) {
        off(axis) = kept * off(axis) + normal(random, std::sqrt(1.0 - kept * kept) * sigma(axis));
      }
      PostureEstimate posture;
      posture.status = PostureStatus::kOk;
      posture.cov = sigma.cwiseAbs2().asDiagonal();
      posture.X_FR = {body.p_F.x() + off.x(), body.p_F.y() + off.y(), heading.p_F.x() + off.z()};
      const Eigen::Matrix3d shake = jitter.is_measured() ? jitter.fresh(posture.cov) : posture.cov;
      take_posture(track, {posture, shake, now}, parameters);
      jitter.take(posture.X_FR, posture.cov, now, parameters);
    }
    body.move(0.05, motion, random);
    heading.move(0.05, turning, random);
    const auto carried = carried_to(track, now + from_seconds(0.05), parameters);
    const Eigen::Vector3d error(carried.X_FR.x() - body.p_F.x(),
                                carried.X_FR.y() - body.p_F.y(),
                                angle_difference(carried.X_FR.theta(), heading.p_F.x()));
    errors.add(error, carried.cov);
  }
  return errors;
}

TEST(TeammateConsistency, CarriedPosturesThatErrAnewInEachFrameFitTheirCovariances) {
  errors_of_carried(0.0).expect_chi_square(3, 0.0);
}

TEST(TeammateConsistency, CarriedPosturesWhoseErrorsLastFitTheirCovariances) {
  const double for_a_second = std::exp(-kFrame);
  errors_of_carried(for_a_second).expect_chi_square(3, 0.0);
}

TEST(ClockOffsetConsistency, JitterAndDriftStayWithinTheirSigma) {
  double squares = 0.0;
  constexpr int kSeeds = 300;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Random random(seed);
    std::exponential_distribution<double> jitter(1.0 / 0.004);
    const double drift = std::uniform_real_distribution<double>(-5e-5, 5e-5)(random);
    const double offset = normal(random, 1000.0);
    const auto peer_at = [&](HostTime time) {
      const double t = to_seconds(time - at_second(0.0));
      return PeerTime{time.time_since_epoch() + from_seconds(offset + drift * t)};
    };
    ClockOffset clock;
    HostTime now = at_second(0.0);
    for (int i = 0; i < 20; ++i) {
      now += std::chrono::seconds(1);
      const HostTime there = now + from_seconds(0.0003 + jitter(random));
      const HostTime answered = there + std::chrono::milliseconds(5);
      const HostTime back = answered + from_seconds(0.0003 + jitter(random));
      ASSERT_TRUE(clock.add({now, peer_at(there), peer_at(answered), back}));
    }
    now += std::chrono::milliseconds(500);
    const auto estimate = clock.at(now);
    ASSERT_TRUE(estimate.has_value());
    const Duration truth = peer_at(now).time_since_epoch() - now.time_since_epoch();
    const double error = to_seconds(estimate->offset - truth);
    const double sigma = to_seconds(estimate->sigma);
    EXPECT_LT(std::abs(error), 3.0 * sigma) << "seed " << seed;
    EXPECT_LT(sigma, 0.002) << "seed " << seed;
    squares += error * error / (sigma * sigma);
  }

  // Sigma stands for the worst asymmetry that the round trip allows: safe, and not absurdly so.
  EXPECT_LT(squares / kSeeds, 1.1);
  EXPECT_GT(squares / kSeeds, 0.02);
}

}  // namespace
}  // namespace teamsight::fusion
