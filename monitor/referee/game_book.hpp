// monitor/referee/game_book.hpp: the referee box's commands kept as the state of the game.
#pragma once

#include <string>

#include "bus/messages.hpp"
#include "geometry/time.hpp"
#include "monitor/referee/box_protocol.hpp"

namespace teamsight::monitor {

/// Applies commands, of the box or of the operator, one after the other.
class GameBook {
 public:
  /// @param own_address  our multicast address, e.g. "224.16.32.63"; empty: WELCOME tells it
  explicit GameBook(std::string own_address);

  /// Targets of commands by hand, whatever the addresses are.
  static constexpr const char* kOurs = "ours";
  static constexpr const char* kTheirs = "theirs";

  /// What one command changed, for the log; says so when it is unknown, which changes nothing.
  std::string apply(const BoxCommand& command, HostTime now);

  void set_connected(bool is_connected) { state_.box_connected = is_connected; }

  /// Identity and stamp are the caller's to fill in.
  [[nodiscard]] bus::GameState state(HostTime now) const;

  /// The last command as it came, e.g. "KICKOFF ours"; empty: none yet.
  [[nodiscard]] const std::string& last_command() const { return last_command_; }

 private:
  [[nodiscard]] std::string whose(const BoxCommand& command) const;
  [[nodiscard]] bool is_ours(const BoxCommand& command) const;
  bool apply_game_flow(const std::string& name);
  bool apply_set_piece(const BoxCommand& command);
  bool apply_goal(const BoxCommand& command);

  std::string own_address_;
  bool learns_address_{false};
  bus::GameState state_;
  HostTime command_at_{};
  std::string last_command_;
};

}  // namespace teamsight::monitor
