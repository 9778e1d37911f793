// monitor/referee/game_book.cpp: see monitor/referee/game_book.hpp.
#include "monitor/referee/game_book.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>
#include <utility>

namespace teamsight::monitor {
namespace {

using bus::GamePhase;
using bus::SetPiece;

struct PhaseRow {
  std::string_view name;
  GamePhase phase;
};

// The league has no phases of its own for overtime.
constexpr std::array kPhases{PhaseRow{"FIRST_HALF", GamePhase::kFirstHalf},
                             PhaseRow{"HALF_TIME", GamePhase::kHalfTime},
                             PhaseRow{"SECOND_HALF", GamePhase::kSecondHalf},
                             PhaseRow{"FIRST_HALF_OVERTIME", GamePhase::kFirstHalf},
                             PhaseRow{"SECOND_HALF_OVERTIME", GamePhase::kSecondHalf},
                             PhaseRow{"END_GAME", GamePhase::kOver},
                             PhaseRow{"GAMEOVER", GamePhase::kOver},
                             PhaseRow{"GAME_OVER", GamePhase::kOver}};

struct PieceRow {
  std::string_view name;
  SetPiece piece;
};

constexpr std::array kPieces{PieceRow{"KICKOFF", SetPiece::kKickoff},
                             PieceRow{"FREEKICK", SetPiece::kFreekick},
                             PieceRow{"GOALKICK", SetPiece::kGoalkick},
                             PieceRow{"THROWIN", SetPiece::kThrowin},
                             PieceRow{"CORNER", SetPiece::kCorner},
                             PieceRow{"PENALTY", SetPiece::kPenalty},
                             PieceRow{"DROP_BALL", SetPiece::kDropball},
                             PieceRow{"PARK", SetPiece::kPark}};

// They change nothing that a robot has to know; which robot is meant stands in the log.
constexpr std::array<std::string_view, 10> kNoted{"TESTMODE_ON",
                                                  "TESTMODE_OFF",
                                                  "YELLOW_CARD",
                                                  "RED_CARD",
                                                  "DOUBLE_YELLOW",
                                                  "REPAIR",
                                                  "REPAIR_END",
                                                  "SUBSTITUTION",
                                                  "IS_ALIVE",
                                                  "END_PART"};

// The wire's ages end at 65.5 s; beyond this all are the same.
constexpr Duration kOldest = std::chrono::seconds(65);
// Commands closer than this are of the same time: the way over the bus counts as age.
constexpr Duration kSameTime = std::chrono::milliseconds(100);
// Three times lost, and the other station is gone.
constexpr Duration kOtherGone = std::chrono::seconds(4);

std::uint8_t counted(std::uint8_t goals, int change) {
  return static_cast<std::uint8_t>(std::clamp(goals + change, 0, 99));
}

}  // namespace

GameBook::GameBook(std::string own_address)
    : own_address_(std::move(own_address)),
      learns_address_(own_address_.empty()) {}

bool GameBook::is_ours(const BoxCommand& command) const {
  return command.target == kOurs || (!own_address_.empty() && command.target == own_address_);
}

std::string GameBook::whose(const BoxCommand& command) const {
  if (command.target.empty()) return {};
  if (is_ours(command)) return " ours";
  return own_address_.empty() && command.target != kTheirs ? " " + command.target : " theirs";
}

bool GameBook::apply_game_flow(const std::string& name) {
  if (name == "START" || name == "STOP") {
    state_.running = name == "START";
    state_.piece = SetPiece::kNone;
    state_.piece_is_ours = false;
    return true;
  }
  const auto row = std::ranges::find(kPhases, name, &PhaseRow::name);
  if (row == kPhases.end()) return false;
  state_.phase = row->phase;
  state_.running = false;
  return true;
}

bool GameBook::apply_set_piece(const BoxCommand& command) {
  const auto row = std::ranges::find(kPieces, command.name, &PieceRow::name);
  if (row == kPieces.end()) return false;
  state_.piece = row->piece;
  state_.piece_is_ours = is_ours(command);
  state_.running = false;
  return true;
}

bool GameBook::apply_goal(const BoxCommand& command) {
  if (command.name != "GOAL" && command.name != "SUBGOAL") return false;
  const int change = command.name == "GOAL" ? 1 : -1;
  const bool is_somebodys = is_ours(command) || command.target == kTheirs ||
                            (!command.target.empty() && !own_address_.empty());
  if (!is_somebodys) return true;
  std::uint8_t& goals = is_ours(command) ? state_.goals_own : state_.goals_opponent;
  goals = counted(goals, change);
  return true;
}

std::string GameBook::apply(const BoxCommand& command, HostTime now) {
  if (command.name == "WELCOME" && learns_address_) own_address_ = command.target;
  std::string said = command.name + whose(command) +
                     (command.robot ? " robot " + std::to_string(*command.robot) : "");
  const bool is_connected = state_.box_connected;
  bool is_known =
      command.name == "WELCOME" || std::ranges::find(kNoted, command.name) != kNoted.end();
  if (command.name == "RESET") {
    state_ = {};
    state_.phase = GamePhase::kBefore;
    state_.box_connected = is_connected;
    is_known = true;
  }
  is_known =
      is_known || apply_game_flow(command.name) || apply_set_piece(command) || apply_goal(command);
  if (!is_known) return "unknown command " + command.name;
  last_command_ = said;
  command_at_ = now;
  speaks_ = true;
  follows_ = false;
  return said;
}

void GameBook::set_connected(bool is_connected) {
  state_.box_connected = is_connected;
  // Who was never connected has no news of that.
  speaks_ = speaks_ || is_connected;
  follows_ = follows_ && !is_connected;
}

bool GameBook::other_has_box(HostTime now) const {
  return other_box_heard_ != HostTime{} && now - other_box_heard_ < kOtherGone;
}

bool GameBook::hear(const bus::GameState& other, std::uint32_t own_boot, HostTime now) {
  told_ = now;
  other_box_heard_ = other.box_connected ? now : HostTime{};
  if (state_.box_connected) return false;
  if (speaks_ && !other.box_connected) {
    const Duration own_age = std::min(now - command_at_, kOldest);
    const Duration lead = own_age - std::min(other.command_age, kOldest);
    const bool is_same = lead < kSameTime && lead > -kSameTime;
    if (is_same ? other.id.boot < own_boot : lead < Duration{0}) return false;
  }
  state_ = other;
  state_.box_connected = false;
  command_at_ = now - other.command_age;
  last_command_ = "told by another station";
  speaks_ = false;
  return !std::exchange(follows_, true);
}

bool GameBook::take_over(HostTime now) {
  if (!follows_ || now - told_ < kOtherGone) return false;
  follows_ = false;
  speaks_ = true;
  return true;
}

bus::GameState GameBook::state(HostTime now) const {
  bus::GameState state = state_;
  state.command_age = command_at_ == HostTime{} ? Duration{0} : now - command_at_;
  return state;
}

}  // namespace teamsight::monitor
