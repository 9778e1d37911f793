// monitor/referee/referee.hpp: the referee box and the bus: the game to the robots, our world out.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "monitor/order.hpp"
#include "monitor/referee/box_link.hpp"
#include "monitor/referee/game_book.hpp"
#include "monitor/station.hpp"
#include "monitor/update.hpp"

namespace teamsight::monitor {

struct RefereeSettings {
  std::optional<BoxAddress> box;  ///< nothing: only commands by hand
  std::string own_address;        ///< our multicast address; empty: the box tells it
  std::string team;               ///< name in the world state
  std::uint32_t boot{0};
};

/// Owns the connection, the state of the game and its topic. Use from the loop's thread.
class Referee {
 public:
  /// @param station  told what happens; outlives this, as the loop does
  Referee(RefereeSettings settings,
          const bus::Participant& team,
          bus::Loop& loop,
          Station& station);
  ~Referee();
  Referee(const Referee&) = delete;
  Referee& operator=(const Referee&) = delete;

  /// A command by hand. Refused while a box is connected: there is one referee.
  ///
  /// @return why it was refused; empty if it was carried out
  std::string by_hand(const RefereeOrder& order);

  [[nodiscard]] RefereeReport report(HostTime now) const;

 private:
  void hear(std::string_view message);
  void hear_others();
  void carry_out(const BoxCommand& command, const std::string& who);
  void note_connection(bool is_connected);
  void publish(HostTime now);
  void send_world();

  RefereeSettings settings_;
  bus::Writer<bus::GameState> games_;
  bus::Reader<bus::GameState> others_;
  Station* station_;
  GameBook book_;
  std::unique_ptr<BoxLink> link_;
  std::uint32_t sequence_{0};
  std::uint64_t refused_{0};
  std::uint64_t counted_sent_{0};
  std::deque<HostTime> sent_at_;
};

}  // namespace teamsight::monitor
