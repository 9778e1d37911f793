// tests/network/team.hpp: a team of real processes, one robot per host, and what every host knew.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/time.hpp"
#include "tests/network/hosts.hpp"
#include "tests/network/match.hpp"
#include "tests/network/sight.hpp"
#include "tests/support/process.hpp"

namespace teamsight::network {

/// How a bench is set up.
struct TeamOptions {
  std::string name{"bench"};
  std::string profile{"wifi"};  ///< of config/dds; its network card is the hosts'
  double rate_hz{30.0};
  std::size_t first_host{0};
  RobotId robots{kRobots};
  bool has_coach{true};         ///< on the host after the robots
  std::string more_team_lines;  ///< added to the team file
  bool secured{false};          ///< DDS Security, with keys of its own
  /// Robot whose processes see a wall clock that `jump_wall_clock` can move; 0 = nobody.
  RobotId with_loose_clock{kNobody};
};

/// What the kernel counts of a process.
struct ProcessSize {
  std::uint64_t resident_kb{0};
  std::uint64_t threads{0};
  std::uint64_t handles{0};
};

/// The processes of one team on the hosts. Robot r lives on host first_host + r - 1; the strongest
/// fusion is that of the robot with the highest id.
class Team {
 public:
  Team(Hosts& hosts, const TeamOptions& options);

  /// Starts the robot's camera-less agent and its fusion; the clock for "within 2 s" begins here.
  void start(RobotId robot);

  /// The same, but what it says carries another robot's id.
  void start_as(RobotId robot, RobotId said);
  void start_all();
  void start_fusion(RobotId robot);
  void start_coach();

  [[nodiscard]] test::ChildProcess& agent(RobotId robot) { return *of(robot).agent; }

  [[nodiscard]] test::ChildProcess& fusion(RobotId robot) { return *of(robot).fusion; }

  [[nodiscard]] std::size_t host(RobotId robot) const { return options_.first_host + robot - 1U; }

  [[nodiscard]] RobotId robots() const { return options_.robots; }

  [[nodiscard]] const TeamOptions& options() const { return options_; }

  /// What the robot's host has known up to now, in order.
  [[nodiscard]] const std::vector<Sight>& sights(RobotId robot);

  /// Sets the wall clock that the robot with the loose clock sees ahead of the real one.
  void jump_wall_clock(std::chrono::seconds ahead) const;

  /// Everything that runs, by name, e.g. "fusion/3".
  [[nodiscard]] std::vector<std::pair<std::string, ProcessSize>> sizes();

  /// Ends the robot's agent, which then tells which topic every writer on the bus writes.
  [[nodiscard]] std::map<WriterGuid, std::string> writers(RobotId robot);

  /// Complaints on the standard error of every process, "" if there are none; the first 1000
  /// letters.
  [[nodiscard]] std::string complaints();

  [[nodiscard]] std::filesystem::path file(const std::string& relative) const;

 private:
  struct Member {
    std::unique_ptr<test::ChildProcess> agent;
    std::unique_ptr<test::ChildProcess> fusion;
    std::vector<Sight> sights;
    std::uintmax_t read{0};
  };

  Member& of(RobotId robot) { return members_.at(static_cast<std::size_t>(robot) - 1U); }

  [[nodiscard]] std::unique_ptr<test::ChildProcess> spawn(std::size_t host,
                                                          const std::vector<std::string>& argv,
                                                          bool has_loose_clock = false) const;
  void write_configuration() const;
  void write_peers() const;
  void make_keys() const;
  [[nodiscard]] std::filesystem::path log_of(RobotId robot) const;
  [[nodiscard]] std::string robot_file(RobotId robot) const;

  Hosts* hosts_;
  TeamOptions options_;
  test::TempDirectory directory_;
  std::vector<Member> members_;
  std::unique_ptr<test::ChildProcess> coach_;
};

/// Monotonic clock of this process, as Sight::at_ns counts.
[[nodiscard]] std::int64_t now_ns();

void pause(std::chrono::milliseconds duration);

}  // namespace teamsight::network
