// tests/system/team.hpp: a team of real processes for a test, and somebody who listens to it.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "tests/support/process.hpp"

namespace teamsight::test {

/// A copy of config/ that a test may change.
class ConfigCopy {
 public:
  ConfigCopy();

  /// A file of it, e.g. "robots/robot1.textproto".
  [[nodiscard]] std::string file(const std::string& relative) const;

  /// Adds lines to the end of a file of it.
  void append(const std::string& relative, const std::string& lines) const;

  /// Replaces a whole file of it.
  void replace(const std::string& relative, const std::string& text) const;

  [[nodiscard]] const std::filesystem::path& directory() const { return directory_.path(); }

 private:
  TempDirectory directory_;
};

/// Starts the processes of one team on this test's own domain.
class Team {
 public:
  /// @param robots  name of the robot files before the id: "robot" or "kassel"
  explicit Team(std::string robots) : robots_(std::move(robots)) {}

  [[nodiscard]] const ConfigCopy& config() const { return config_; }

  [[nodiscard]] std::unique_ptr<ChildProcess> agent(int id,
                                                    const std::string& source,
                                                    std::vector<std::string> more = {}) const;
  [[nodiscard]] std::unique_ptr<ChildProcess> fusion(int id) const;

  /// The coach station on a free port, which it names in its first line.
  /// @param web  directory of the page
  [[nodiscard]] std::unique_ptr<ChildProcess> monitor(const std::string& team_file,
                                                      const std::filesystem::path& web) const;

  /// The match of config/matches/demo.textproto, its FIFOs in `frames()`.
  [[nodiscard]] std::unique_ptr<ChildProcess> simulator() const;

  [[nodiscard]] std::filesystem::path frames() const { return config_.directory() / "frames"; }

  /// The source of a robot's frames from the simulator.
  [[nodiscard]] std::string stream(int id) const;

  [[nodiscard]] bus::Participant join(const std::string& team_file) const;

 private:
  std::string robots_;
  ConfigCopy config_;
};

/// Hears one team's topics; in a test it stands where the coach station stands.
class Listener {
 public:
  explicit Listener(const bus::Participant& team);

  /// Takes whatever has arrived.
  void listen();

  /// Newest of each; nothing if there was none yet.
  std::optional<WorldModel> world;
  std::map<RobotId, bus::RobotState> states;
  std::map<std::string, bus::Diagnostics> diagnostics;

  /// A robot as the newest world has it.
  [[nodiscard]] std::optional<WorldTeammate> teammate(RobotId robot) const;

  /// Asks for a relocation.
  /// @return the command's id, for RobotState.command_acknowledged
  std::uint32_t relocate(RobotId robot, const Pose<Field, Robot>& X_FR);

 private:
  bus::Reader<WorldModel> worlds_;
  bus::Reader<bus::RobotState> state_reader_;
  bus::Reader<bus::Diagnostics> diagnostics_reader_;
  bus::Writer<bus::Command> commands_;
  std::uint32_t command_{0};
};

}  // namespace teamsight::test
