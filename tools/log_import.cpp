// tools/log_import.cpp: `teamsight log import`: a game as the league's referee box recorded it.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "bus/fault.hpp"
#include "bus/messages.hpp"
#include "process/program.hpp"
#include "recording/mcap_writer.hpp"
#include "recording/output_file.hpp"
#include "recording/topic_channel.hpp"
#include "tools/league_game.hpp"
#include "tools/log_actions.hpp"

namespace teamsight::tools {
namespace {

using nlohmann::json;

// The league's world states tell no uncertainty. What is drawn is the spread that was measured
// between one team's obstacles and the other team's own postures, about half a metre in the plane.
constexpr double kAssumedVar = 0.5 * 0.5 / 2.0;  // m^2, per axis
constexpr std::int64_t kNsPerMs = 1'000'000;
constexpr RobotId kImporter = kNobody;  // no robot's fusion made it

/// One league file, one topic after the other, into one MCAP file.
class Importer {
 public:
  explicit Importer(const std::filesystem::path& out)
      : file_(out),
        writer_([this](std::string_view bytes) { return file_.write(bytes); }, "teamsight import"),
        worlds_(writer_.add_channel(recording::channel_of<WorldModel>())),
        games_(writer_.add_channel(recording::channel_of<bus::GameState>())) {}

  void add_world(const json& record) {
    const auto ms = record.find("timestamp");
    const auto state = record.find("worldstate");
    const bool is_record =
        ms != record.end() && ms->is_number() && state != record.end() && state->is_object();
    if (!is_record || !begin(ms->get<std::int64_t>())) {
      ++skipped_;
      return;
    }
    WorldModel world;
    world.id = {kImporter, 1, ++sequence_};
    world.strength = 1;
    world.stamp = stamp_at(ms->get<std::int64_t>());
    fill(*state, world);
    write(worlds_, ms->get<std::int64_t>(), world);
  }

  void add_game(std::int64_t ms, const bus::GameState& wanted) {
    if (!begin(ms)) return;
    bus::GameState game = wanted;
    game.id = {kNobody, 1, ++sequence_};
    game.stamp = stamp_at(ms);
    write(games_, ms, game);
  }

  int finish() {
    writer_.add_metadata(
        "teamsight.recording",
        {{"team", team_}, {"log_minus_host_ns", std::to_string(first_ms_ * kNsPerMs - kStart)}});
    writer_.finish();
    if (!file_.problem().empty()) throw std::runtime_error(file_.problem());
    std::printf("{\"messages\": %llu, \"skipped\": %llu}\n",
                static_cast<unsigned long long>(writer_.messages()),
                static_cast<unsigned long long>(skipped_));
    return writer_.messages() > 0 ? process::kDone : process::kAnswerIsNo;
  }

 private:
  static constexpr std::int64_t kStart = 1'000'000'000;  // no stamp is 0 or less

  /// The first stamp decides what the others are counted from; one from long before is refused.
  bool begin(std::int64_t ms) {
    if (first_ms_ == 0) first_ms_ = ms - 60'000;
    return ms >= first_ms_ && ms - first_ms_ < 86'400'000;
  }

  [[nodiscard]] PeerTime stamp_at(std::int64_t ms) const {
    return PeerTime{Duration{(ms - first_ms_) * kNsPerMs + kStart}};
  }

  template <class Message>
  void write(std::uint16_t channel, std::int64_t ms, const Message& message) {
    if (bus::fault_of(message)) {
      ++skipped_;
      return;
    }
    writer_.write(channel, {ms * kNsPerMs, ms * kNsPerMs, 0}, recording::payload_of(message));
  }

  /// From the box's frame (x right, y to the opponent goal) to F.
  void fill(const json& state, WorldModel& world) {
    if (team_.empty() && state.value("teamName", json()).is_string()) team_ = state["teamName"];
    for (const json& item : state.value("robots", json::array())) add_robot(item, world);
    for (const json& item : state.value("balls", json::array())) add_ball(item, world);
    for (const json& item : state.value("obstacles", json::array())) add_obstacle(item, world);
    std::ranges::sort(world.teammates, {}, &WorldTeammate::robot);
  }

  static void add_robot(const json& item, WorldModel& world) {
    if (!item.is_object() || world.teammates.size() == kMaxWorldTeammates) return;
    const auto pose = numbers(item, "pose", 3);
    const double id = number(item, "id", 0.0);
    if (!pose || id < 1.0 || id > kMaxRobotId) return;
    WorldTeammate mate;
    mate.robot = static_cast<RobotId>(id);
    mate.status = PostureStatus::kOk;
    mate.X_FR = {(*pose)[1], -(*pose)[0], (*pose)[2]};
    mate.cov = Eigen::Vector3d(kAssumedVar, kAssumedVar, 0.01).asDiagonal();
    if (const auto v = numbers(item, "velocity", 2)) mate.v_FR = {(*v)[1], -(*v)[0]};
    mate.trust = 1.0;
    world.teammates.push_back(mate);
  }

  static void add_ball(const json& item, WorldModel& world) {
    if (!item.is_object() || world.balls.size() == kMaxWorldBalls) return;
    const auto at = numbers(item, "position", 3);
    const double confidence = number(item, "confidence", -1.0);
    if (!at || confidence < 0.0 || confidence > 1.0) return;
    WorldBall ball;
    ball.track = static_cast<std::uint32_t>(world.balls.size() + 1);
    ball.p_FB = {(*at)[1], -(*at)[0], (*at)[2]};
    if (const auto v = numbers(item, "velocity", 3)) ball.v_FB = {(*v)[1], -(*v)[0], (*v)[2]};
    ball.cov_p = Eigen::Matrix3d::Identity() * kAssumedVar;
    ball.existence = confidence;
    world.balls.push_back(ball);
  }

  static void add_obstacle(const json& item, WorldModel& world) {
    if (!item.is_object() || world.obstacles.size() == kMaxWorldObstacles) return;
    const auto at = numbers(item, "position", 2);
    if (!at) return;
    WorldObstacle obstacle;
    obstacle.track = static_cast<std::uint32_t>(world.obstacles.size() + 1);
    obstacle.p_FO = {(*at)[1], -(*at)[0]};
    if (const auto v = numbers(item, "velocity", 2)) obstacle.v_FO = {(*v)[1], -(*v)[0]};
    obstacle.cov_p = Eigen::Matrix2d::Identity() * kAssumedVar;
    obstacle.radius = std::clamp(number(item, "radius", 0.25), 0.05, 1.0);
    obstacle.existence = std::clamp(number(item, "confidence", 1.0), 0.0, 1.0);
    world.obstacles.push_back(obstacle);
  }

  recording::OutputFile file_;
  recording::McapWriter writer_;
  std::uint16_t worlds_;
  std::uint16_t games_;
  std::string team_;
  std::int64_t first_ms_{0};
  std::uint32_t sequence_{0};
  std::uint64_t skipped_{0};
};

struct Piece {
  const char* words;
  bus::SetPiece piece;
};

constexpr std::array kPieces{Piece{"Kickoff", bus::SetPiece::kKickoff},
                             Piece{"Freekick", bus::SetPiece::kFreekick},
                             Piece{"Goalkick", bus::SetPiece::kGoalkick},
                             Piece{"Throw In", bus::SetPiece::kThrowin},
                             Piece{"Corner", bus::SetPiece::kCorner},
                             Piece{"Penalty", bus::SetPiece::kPenalty},
                             Piece{"Dropped Ball", bus::SetPiece::kDropball}};

/// One line: "stamp,game time,phase,letter,words".
void apply_event(const std::string& words, const std::string& own, bus::GameState& game) {
  const bool is_ours = words.starts_with(own);
  if (words == "START" || words == "STOP") {
    game.running = words == "START";
    game.piece = bus::SetPiece::kNone;
  }
  for (const Piece& piece : kPieces) {
    if (words.find(piece.words) == std::string::npos) continue;
    game.piece = piece.piece;
    game.piece_is_ours = is_ours;
    game.running = false;
  }
  if (words.ends_with(" Goal+")) ++(is_ours ? game.goals_own : game.goals_opponent);
  if (words.find("1st half") != std::string::npos) game.phase = bus::GamePhase::kFirstHalf;
  if (words.find("2nd half") != std::string::npos) game.phase = bus::GamePhase::kSecondHalf;
  if (words.find("Halftime") != std::string::npos) game.phase = bus::GamePhase::kHalfTime;
  if (words.find("End Game") != std::string::npos) game.phase = bus::GamePhase::kOver;
}

void import_events(const LogImport& request, Importer& importer) {
  const std::string own = request.own == "magenta" ? "MAGENTA" : "CYAN";
  bus::GameState game;
  game.phase = bus::GamePhase::kBefore;
  game.box_connected = true;
  for_each_league_event(request.events, [&](std::int64_t ms, const std::string& words) {
    apply_event(words, own, game);
    importer.add_game(ms, game);
  });
}

}  // namespace

int log_import(const LogImport& request) {
  Importer importer(request.out);
  // A box that was switched off leaves the list open: what stands before counts.
  for_each_league_record(request.worlds, [&](const json& record) { importer.add_world(record); });
  if (!request.events.empty()) import_events(request, importer);
  return importer.finish();
}

}  // namespace teamsight::tools
