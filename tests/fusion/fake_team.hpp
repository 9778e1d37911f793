// tests/fusion/fake_team.hpp: robots' sightings on a real bus, and what a reader hears of the
// world.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "tests/fusion/scenario.hpp"
#include "tests/support/process.hpp"

namespace teamsight::fusion::test {

/// One world model as it came in.
struct HeardWorld {
  WorldModel model;
  HostTime received;
};

/// What looks like a ball to the robots.
enum class Shown : std::uint8_t {
  kBall,
  kOrangeThing,
  kBoth,  ///< to two robots; robot 2 sees the orange thing alone
};

/// Three robots that write Sightings of one ball and one opponent at 30 Hz, in this process, and a
/// reader of the team's world model.
class FakeTeam {
 public:
  /// Joins as the demo team's processes do.
  explicit FakeTeam(std::uint32_t team_domain);

  /// Writes frames and listens until `is_done` (asked after each step), at most `bound`.
  [[nodiscard]] bool play_until(const std::function<bool()>& is_done,
                                std::chrono::milliseconds bound);

  /// What looks like a ball from now on.
  void show(Shown shown) { shown_ = shown; }

  /// Gives the operator's word, as the coach station does.
  void hint(std::uint32_t command, const Point<Field>& p_FB);

  /// The hint that the leading fusion acknowledged last.
  [[nodiscard]] const bus::ExplainedHint& acknowledged() const { return acknowledged_; }

  /// Whether the newest model lists the ball before the orange thing, and both.
  [[nodiscard]] bool sees_the_ball_first() const;

  /// Everything heard so far, oldest first.
  [[nodiscard]] const std::vector<HeardWorld>& heard() const { return heard_; }

  /// Whether the newest model comes from this robot's fusion and shows the whole scene.
  [[nodiscard]] bool sees_whole_world_of(RobotId maker) const;

  static constexpr Point<Field> kBall{1.0, 0.5};
  static constexpr Point<Field> kOrangeThing{-1.0, 3.0};
  static constexpr Point<Field> kOpponent{0.0, -2.0};

 private:
  void write_frames();

  bus::Participant participant_;
  std::vector<bus::Writer<bus::Sightings>> writers_;
  bus::Writer<bus::Command> commands_;
  bus::Reader<WorldModel> worlds_;
  bus::Reader<bus::Explanation> explanations_;
  bus::ExplainedHint acknowledged_;
  Shown shown_{Shown::kBall};
  std::vector<Eye> eyes_;
  std::vector<HeardWorld> heard_;
  HostTime next_frame_{};
};

/// Starts `teamsight-fusion` for robot `robot` of the demo team.
[[nodiscard]] teamsight::test::ChildProcess start_fusion(RobotId robot, std::uint32_t team_domain);

/// Path of the demo team's robot file.
[[nodiscard]] std::string robot_file(RobotId robot);

/// Track ids of the balls, then of the obstacles.
[[nodiscard]] std::vector<std::uint32_t> ids_of(const WorldModel& world);

}  // namespace teamsight::fusion::test
