// client/team_world.hpp: the freshest world, and the game's state, in one call each; for behaviour
// programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "bus/messages.hpp"
#include "client/world.hpp"

namespace teamsight {

/// Where to listen, if not where the robot file says.
struct TeamWorldOptions {
  std::optional<std::uint32_t> team_domain;  ///< instead of the team file's domain_id, 0 ... 229
  std::string host_tag;                      ///< tag of the host domain; empty = the robot's own
};

/// Listens to the team's leading fusion and to the own host's.
///
/// `TeamWorld team("robot3.textproto"); ... World world = team.freshest();`
///
/// Makes no thread. Use from one thread; make one per process.
class TeamWorld {
 public:
  /// @param robot_file  of the robot this program runs on (config/robots)
  /// @throws std::runtime_error with one line that names the file and what is wrong with it, or
  ///         why the bus cannot be joined
  explicit TeamWorld(const std::filesystem::path& robot_file, const TeamWorldOptions& options = {});
  TeamWorld(TeamWorld&&) noexcept;
  TeamWorld& operator=(TeamWorld&&) noexcept;
  TeamWorld(const TeamWorld&) = delete;
  TeamWorld& operator=(const TeamWorld&) = delete;
  ~TeamWorld();

  /// The leader's model while it is fresh (250 ms), else the own host's (1 s), else none.
  ///
  /// Takes what has come since the last call, and does not wait for more. If the leader lives and
  /// is not heard (somebody forges its packets), it joins the bus anew, which may take 10 ms.
  [[nodiscard]] World freshest();

  /// What the referee last said, as the coach station tells it, once a second and on every change.
  ///
  /// Nothing if no station has told anything for three seconds: whoever plays on then does so
  /// without a referee. Takes what has come since the last call, and does not wait for more.
  [[nodiscard]] std::optional<bus::GameState> game();

  /// The robot of the robot file.
  [[nodiscard]] RobotId robot() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight
