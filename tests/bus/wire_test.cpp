// tests/bus/wire_test.cpp: every message survives its wire form, every rule refuses what breaks it.
#include "bus/wire.hpp"

#include <cstring>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "tests/bus/samples.hpp"

namespace teamsight::bus {
namespace {

using testing::full;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

using AllMessages = ::testing::Types<RobotState,
                                     Sightings,
                                     VirtualSensors,
                                     Odometry,
                                     WorldModel,
                                     Explanation,
                                     ClockProbe,
                                     ClockEcho,
                                     GameState,
                                     Command,
                                     Diagnostics,
                                     LinePoints,
                                     Thumbnail,
                                     Truth>;

template <class Message>
class EveryMessage : public ::testing::Test {};

TYPED_TEST_SUITE(EveryMessage, AllMessages);

TYPED_TEST(EveryMessage, SurvivesTheWireAtItsBounds) {
  WireSample<TypeParam> wire;

  const auto refused = to_wire(full<TypeParam>(), wire);
  const auto back = from_wire<TypeParam>(wire.sample);

  ASSERT_FALSE(refused) << to_string(*refused);
  ASSERT_TRUE(back) << to_string(back.error());
  EXPECT_EQ(*back, full<TypeParam>());
}

TYPED_TEST(EveryMessage, IsRefusedWithoutABootOrASequenceNumber) {
  for (const auto& [boot, sequence] : {std::pair{0U, 1U}, std::pair{1U, 0U}}) {
    TypeParam message = full<TypeParam>();
    message.id.boot = boot;
    message.id.sequence = sequence;
    WireSample<TypeParam> wire;

    const auto refused = to_wire(message, wire);

    EXPECT_EQ(refused, Reject::kBadIdentity);
    EXPECT_EQ(from_wire<TypeParam>(wire.sample).error(), Reject::kBadIdentity);
  }
}

TYPED_TEST(EveryMessage, IsRefusedFromARobotThatCannotBe) {
  TypeParam message = full<TypeParam>();
  message.id.robot = kMaxRobotId + 1;
  WireSample<TypeParam> wire;

  EXPECT_EQ(to_wire(message, wire), Reject::kBadIdentity);
}

/// What reading says of a full wire sample after `damage`.
template <class Message>
std::optional<Reject> after(const std::function<void(typename WireForm<Message>::Type&)>& damage) {
  WireSample<Message> wire;
  EXPECT_FALSE(to_wire(full<Message>(), wire));
  damage(wire.sample);
  const auto result = from_wire<Message>(wire.sample);
  return result ? std::nullopt : std::optional(result.error());
}

TEST(RobotStateWire, RefusesNumbersThatAreNotFinite) {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_EQ(after<RobotState>([&](auto& w) { w.posture.posture.x_m = bad; }), Reject::kNotFinite);
    EXPECT_EQ(after<RobotState>([&](auto& w) { w.posture.posture.cov[4] = bad; }),
              Reject::kNotFinite);
    EXPECT_EQ(after<RobotState>([&](auto& w) { w.omega_radps = bad; }), Reject::kNotFinite);
    EXPECT_EQ(after<RobotState>([&](auto& w) { w.battery_v = bad; }), Reject::kNotFinite);
  }
}

TEST(RobotStateWire, RefusesWhatIsNotACovariance) {
  EXPECT_EQ(after<RobotState>([](auto& w) { w.posture.posture.cov[0] = -1.0F; }),
            Reject::kBadCovariance);
  EXPECT_EQ(after<RobotState>([](auto& w) { w.posture.posture.cov[0] = 0.0F; }),
            Reject::kBadCovariance);
  EXPECT_EQ(after<RobotState>([](auto& w) { w.posture.posture.cov[1] = 10.0F; }),
            Reject::kBadCovariance);
  EXPECT_EQ(after<RobotState>([](auto& w) { w.posture.posture.cov[5] = 1e20F; }),
            Reject::kBadCovariance);
}

TEST(RobotStateWire, RefusesAKeyThatIsNotItsRobot) {
  EXPECT_EQ(after<RobotState>([](auto& w) { w.robot_id = 4; }), Reject::kBadIdentity);
  EXPECT_EQ(after<RobotState>([](auto& w) { w.robot_id = w.sample.robot_id = 0; }),
            Reject::kBadIdentity);
  EXPECT_EQ(after<RobotState>([](auto& w) { w.robot_id = w.sample.robot_id = 17; }),
            Reject::kBadIdentity);
}

TEST(RobotStateWire, RefusesCodesOfAnotherVersion) {
  EXPECT_EQ(after<RobotState>([](auto& w) {
              const std::int32_t unknown = 3;
              std::memcpy(&w.posture.status, &unknown, sizeof unknown);
            }),
            Reject::kBadEnum);
  EXPECT_EQ(after<RobotState>([](auto& w) { w.playing = 2; }), Reject::kBadEnum);
}

TEST(RobotStateWire, RefusesWhatCannotBe) {
  EXPECT_EQ(after<RobotState>([](auto& w) { w.posture.posture.x_m = 1000.0F; }),
            Reject::kOutOfRange);
  EXPECT_EQ(after<RobotState>([](auto& w) { w.posture.posture.theta_rad = 3.2F; }),
            Reject::kOutOfRange);
  EXPECT_EQ(after<RobotState>([](auto& w) { w.posture.inlier_ratio = 3.0F; }), Reject::kOutOfRange);
  EXPECT_EQ(after<RobotState>([](auto& w) { w.frame_rate_hz = -1.0F; }), Reject::kOutOfRange);
}

TEST(RobotStateWire, RefusesImplausibleStamps) {
  EXPECT_EQ(after<RobotState>([](auto& w) { w.exposure_ns = -1; }), Reject::kImplausibleStamp);
  EXPECT_EQ(after<RobotState>([](auto& w) { w.publish_ns = w.exposure_ns - 1; }),
            Reject::kImplausibleStamp);
  EXPECT_EQ(after<RobotState>([](auto& w) {
              w.publish_ns = w.exposure_ns = std::numeric_limits<std::int64_t>::max();
            }),
            Reject::kImplausibleStamp);
}

TEST(RobotStateWire, RefusesTextsWithoutAnEnd) {
  EXPECT_EQ(after<RobotState>(
                [](auto& w) { std::memset(w.software_version, 'x', sizeof w.software_version); }),
            Reject::kUnbounded);
}

TEST(RobotStateWire, RefusesTextsThatNoTerminalShouldSee) {
  for (const char* bad : {"\x1b[2J", "a\nb", "\xff", "\xc3", "\xed\xa0\x80", "\xc0\xaf", "\x7f"}) {
    EXPECT_EQ(after<RobotState>([&](auto& w) { std::strcpy(w.software_version, bad); }),
              Reject::kOutOfRange)
        << bad;
  }
}

TEST(SightingsWire, RefusesSequencesBeyondTheirBounds) {
  EXPECT_EQ(after<Sightings>([](auto& w) { w.balls._length = 5; }), Reject::kUnbounded);
  EXPECT_EQ(after<Sightings>([](auto& w) { w.obstacles._length = 4'000'000'000; }),
            Reject::kUnbounded);
  EXPECT_EQ(after<Sightings>([](auto& w) { w.balls._buffer = nullptr; }), Reject::kUnbounded);
}

TEST(SightingsWire, RefusesABadElementAnywhere) {
  EXPECT_EQ(after<Sightings>([](auto& w) { w.balls._buffer[3].origin_m[2] = kNan; }),
            Reject::kNotFinite);
  EXPECT_EQ(after<Sightings>([](auto& w) { w.balls._buffer[3].cov_direction[0] = -0.5F; }),
            Reject::kBadCovariance);
  EXPECT_EQ(after<Sightings>([](auto& w) { w.balls._buffer[3].direction[2] = -0.5F; }),
            Reject::kOutOfRange);
  EXPECT_EQ(after<Sightings>([](auto& w) { w.balls._buffer[3].colour = 5; }), Reject::kBadEnum);
  EXPECT_EQ(after<Sightings>([](auto& w) { w.obstacles._buffer[15].x_m = kInfinity; }),
            Reject::kNotFinite);
  EXPECT_EQ(after<Sightings>([](auto& w) { w.obstacles._buffer[15].confidence_percent = 101; }),
            Reject::kOutOfRange);
  EXPECT_EQ(after<Sightings>([](auto& w) { w.light = 5; }), Reject::kBadEnum);
}

TEST(WorldModelWire, RefusesABadElementAnywhere) {
  EXPECT_EQ(after<WorldModel>([](auto& w) { w.balls._buffer[1].p_m[2] = kNan; }),
            Reject::kNotFinite);
  EXPECT_EQ(after<WorldModel>([](auto& w) { w.balls._buffer[1].cov_v[0] = 0.0F; }),
            Reject::kBadCovariance);
  EXPECT_EQ(after<WorldModel>([](auto& w) { w.balls._buffer[1].existence_percent = 200; }),
            Reject::kOutOfRange);
  EXPECT_EQ(after<WorldModel>([](auto& w) { w.teammates._buffer[5].robot_id = 0; }),
            Reject::kBadIdentity);
  EXPECT_EQ(after<WorldModel>([](auto& w) { w.teammates._buffer[5].half_log_odds_team = kNan; }),
            Reject::kNotFinite);
  EXPECT_EQ(after<WorldModel>([](auto& w) { w.teammates._buffer[5].quarantine = 7; }),
            Reject::kBadEnum);
  EXPECT_EQ(after<WorldModel>([](auto& w) { w.obstacles._buffer[11].vy_mps = 1e6F; }),
            Reject::kOutOfRange);
  EXPECT_EQ(after<WorldModel>([](auto& w) { w.obstacles._length = 13; }), Reject::kUnbounded);
  EXPECT_EQ(after<WorldModel>([](auto& w) { w.team = 1; }), Reject::kBadIdentity);
}

TEST(OtherWires, RefuseWhatBreaksTheirRules) {
  EXPECT_EQ(after<VirtualSensors>([](auto& w) { w.readings._buffer[23].value = 1.5F; }),
            Reject::kOutOfRange);
  EXPECT_EQ(after<VirtualSensors>([](auto& w) { w.readings._length = 25; }), Reject::kUnbounded);
  EXPECT_EQ(after<Odometry>([](auto& w) { w.sigma_v_mps = -0.1F; }), Reject::kOutOfRange);
  EXPECT_EQ(after<Odometry>([](auto& w) { w.x_m = kNan; }), Reject::kNotFinite);
  EXPECT_EQ(after<Explanation>([](auto& w) { w.tracks._buffer[13].kind = 2; }), Reject::kBadEnum);
  EXPECT_EQ(after<Explanation>([](auto& w) { w.robots._buffer[15].clock_sigma_ms = kNan; }),
            Reject::kNotFinite);
  EXPECT_EQ(after<Explanation>([](auto& w) {
              w.robots._buffer[15].clock_offset_ns = std::numeric_limits<std::int64_t>::min();
            }),
            Reject::kOutOfRange);
  EXPECT_EQ(after<ClockProbe>([](auto& w) { w.host_id = 4; }), Reject::kBadIdentity);
  EXPECT_EQ(after<ClockEcho>([](auto& w) { w.replies._buffer[15].received_ns = w.sent_ns + 1; }),
            Reject::kImplausibleStamp);
  EXPECT_EQ(after<ClockEcho>([](auto& w) { w.replies._buffer[15].probe_sequence = 0; }),
            Reject::kBadIdentity);
  EXPECT_EQ(after<Command>([](auto& w) { w.command_id = 0; }), Reject::kBadIdentity);
  EXPECT_EQ(after<Command>([](auto& w) { w.target_robot_id = 17; }), Reject::kBadIdentity);
  EXPECT_EQ(after<Diagnostics>([](auto& w) { w.process[0] = '\0'; }), Reject::kBadIdentity);
  EXPECT_EQ(after<Diagnostics>([](auto& w) { w.counters._buffer[17].name[0] = '\t'; }),
            Reject::kOutOfRange);
  EXPECT_EQ(after<LinePoints>([](auto& w) { w.points._buffer[199].inlier = 9; }), Reject::kBadEnum);
  EXPECT_EQ(after<Thumbnail>([](auto& w) { w.jpeg._length = 32'769; }), Reject::kUnbounded);
  EXPECT_EQ(after<Truth>([](auto& w) { w.robots._buffer[19].robot_id = 33; }),
            Reject::kBadIdentity);
}

TEST(GameStateWire, RefusesCodesOfAnotherVersion) {
  const auto set = [](auto& field, std::int32_t raw) {
    std::memcpy(&field, &raw, sizeof raw);
  };

  EXPECT_EQ(after<GameState>([&](auto& w) { set(w.phase, 7); }), Reject::kBadEnum);
  EXPECT_EQ(after<GameState>([&](auto& w) { set(w.piece, -1); }), Reject::kBadEnum);
  EXPECT_EQ(after<Command>([&](auto& w) { set(w.kind, 7); }), Reject::kBadEnum);
}

/// What writing says of a full message after `damage`.
template <class Message>
std::optional<Reject> writing(const std::function<void(Message&)>& damage) {
  Message message = full<Message>();
  damage(message);
  WireSample<Message> wire;
  return to_wire(message, wire);
}

TEST(Writing, RefusesWhatDoesNotFitItsField) {
  EXPECT_EQ(writing<Sightings>([](auto& m) { m.balls.emplace_back(); }), Reject::kUnbounded);
  EXPECT_EQ(writing<RobotState>([](auto& m) { m.software_version += 'x'; }), Reject::kUnbounded);
  EXPECT_EQ(writing<RobotState>([](auto& m) { m.omega = 1e300; }), Reject::kNotFinite);
  EXPECT_EQ(writing<Sightings>([](auto& m) { m.obstacles[0].confidence = 1.01; }),
            Reject::kOutOfRange);
  EXPECT_EQ(writing<WorldModel>([](auto& m) { m.balls[0].existence = std::nan(""); }),
            Reject::kNotFinite);
  EXPECT_EQ(writing<WorldModel>([](auto& m) { m.balls[0].age = Duration{-1}; }),
            Reject::kOutOfRange);
  EXPECT_EQ(writing<WorldModel>([](auto& m) { m.obstacles[0].radius = 66.0; }),
            Reject::kOutOfRange);
  EXPECT_EQ(writing<LinePoints>([](auto& m) { m.points[0].p_R.x = 33.0; }), Reject::kOutOfRange);
  EXPECT_EQ(writing<Thumbnail>([](auto& m) { m.jpeg.push_back(0); }), Reject::kUnbounded);
}

TEST(Writing, SaysOfAnAgeBeyondItsFieldThatItIsThatOrOlder) {
  WorldModel message = full<WorldModel>();
  message.balls[0].age = std::chrono::hours(1);
  WireSample<WorldModel> wire;

  ASSERT_FALSE(to_wire(message, wire));

  EXPECT_EQ(wire.sample.balls._buffer[0].age_ms, 65'535);
}

TEST(Reject, HasANameForEveryReason) {
  for (std::size_t i = 0; i < kRejectReasons; ++i) {
    EXPECT_NE(to_string(static_cast<Reject>(i)), "unknown");
  }
}

}  // namespace
}  // namespace teamsight::bus
