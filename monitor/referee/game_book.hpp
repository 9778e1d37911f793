// monitor/referee/game_book.hpp: the referee box's commands kept as the state of the game.
#pragma once

#include <cstdint>
#include <string>

#include "bus/messages.hpp"
#include "geometry/time.hpp"
#include "monitor/referee/box_protocol.hpp"

namespace teamsight::monitor {

/// Applies commands, of the box or of the operator, one after the other.
///
/// Of several stations one tells the robots: whoever has the box, else whoever gave the newest
/// command. The others follow it and keep quiet, so that nobody's ignorance stops a game.
class GameBook {
 public:
  /// @param own_address  our multicast address, e.g. "224.16.32.63"; empty: WELCOME tells it
  explicit GameBook(std::string own_address);

  /// Targets of commands by hand, whatever the addresses are.
  static constexpr const char* kOurs = "ours";
  static constexpr const char* kTheirs = "theirs";

  /// What one command changed, for the log; says so when it is unknown, which changes nothing.
  std::string apply(const BoxCommand& command, HostTime now);

  void set_connected(bool is_connected);

  /// What another station tells; its game is taken over if its word counts more than ours.
  ///
  /// @param own_boot  decides between commands of the same time, at every station alike
  /// @return whether this station told the game until now, or knew none, and is quiet from now on
  bool hear(const bus::GameState& other, std::uint32_t own_boot, HostTime now);

  /// Goes on telling what it was told, once the station that it follows has been silent for four
  /// seconds; to be asked about once a second.
  ///
  /// @return whether that is so since now
  bool take_over(HostTime now);

  /// Whether the robots are to hear the game from this station: it has something to say.
  [[nodiscard]] bool speaks() const { return speaks_; }

  /// Whether they hear it from another station, whose game this one shows.
  [[nodiscard]] bool follows() const { return follows_; }

  /// Whether another station said lately that it is connected to the box.
  [[nodiscard]] bool other_has_box(HostTime now) const;

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
  bool speaks_{false};
  bool follows_{false};
  HostTime other_box_heard_{};
  HostTime told_{};  // when another station spoke last
  bus::GameState state_;
  HostTime command_at_{};
  std::string last_command_;
};

}  // namespace teamsight::monitor
