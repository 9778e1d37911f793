// tests/network/scenarios_security.cpp: what DDS Security costs, and whom it keeps out.
#include <algorithm>
#include <cstring>
#include <fstream>

#include "tests/network/stage.hpp"

namespace teamsight::network {
namespace {

struct Cost {
  double start_ms{0.0};
  double mbit{0.0};
  double age_ms{0.0};
};

Cost measure(Stage& stage, const std::string& title) {
  Cost cost;
  cost.start_ms = stage.start();
  const std::int64_t from = now_ns();
  cost.mbit = stage.report_wire(stage.observed(seconds(5)));
  cost.age_ms = stage.report(title, {from, now_ns()}).air_age_ms;
  stage.outcome.say(title + ": start-up " + number(cost.start_ms, 0) + " ms, " +
                    number(cost.mbit, 2) + " Mbit/s, leader's models " + number(cost.age_ms, 2) +
                    " ms old on arrival (median of the slowest reader)");
  stage.outcome.expect(cost.age_ms > 0.0, title + ": models came over the air");
  return cost;
}

bool anybody_has(Team& team, RobotId robot, std::int64_t from_ns) {
  const auto bit = static_cast<std::uint8_t>(1U << (robot - 1U));
  for (RobotId reader = 1; reader < robot - 1; ++reader) {
    const auto seen =
        first(team.sights(reader), Channel::kChoice, from_ns, [bit](const Sight& sight) {
          return (sight.robots & bit) != 0;
        });
    if (seen) return true;
  }
  return false;
}

// A team of the same name on the same domain, whose team file names no keys.
void expect_no_stranger(Stage& stage, const TeamOptions& options) {
  TeamOptions strangers = options;
  strangers.secured = false;
  strangers.robots = 6;
  strangers.has_coach = false;
  strangers.first_host = 2;
  Team team(stage.hosts, strangers);
  const std::int64_t from = now_ns();
  team.start(6);  // on the one host that is free
  pause(seconds(3));
  stage.outcome.expect(!anybody_has(stage.team, 6, from),
                       "nobody hears a robot without an identity");
  const auto heard = first(
      team.sights(6), Channel::kLeader, from, [](const Sight& sight) { return sight.maker != 6; });
  stage.outcome.expect(!heard, "a robot without an identity hears nobody");
}

// Robot 5 has the team's identity, and says that it is robot 6.
void expect_no_impostor(Stage& stage) {
  stage.team.agent(5).end();
  const std::int64_t from = now_ns();
  stage.team.start_as(5, 6);
  pause(seconds(3));
  stage.outcome.expect(!anybody_has(stage.team, 6, from),
                       "nobody believes one robot in another's name");
}

// RTPS messages of the team, as somebody on the same network hears them.
std::string capture(Stage& stage, milliseconds duration) {
  constexpr std::size_t kHeaders = 14 + 20 + 8;
  constexpr std::size_t kMost = 4'000'000;
  std::string messages;
  stage.hosts.network().mirror([&](const std::uint8_t* frame, std::size_t size) {
    const bool is_rtps = size > kHeaders + 4 && std::memcmp(frame + kHeaders, "RTPS", 4) == 0;
    if (!is_rtps || messages.size() > kMost) return;
    const std::size_t length = size - kHeaders;
    messages += static_cast<char>(length & 0xffU);
    messages += static_cast<char>(length >> 8U);
    messages.append(reinterpret_cast<const char*>(frame + kHeaders), length);
  });
  pause(duration);
  stage.hosts.network().mirror(nullptr);
  const std::string path = stage.team.file("capture").string();
  std::ofstream(path, std::ios::binary) << messages;
  return path;
}

std::uint64_t largest_growth(const std::vector<std::pair<std::string, ProcessSize>>& before,
                             const std::vector<std::pair<std::string, ProcessSize>>& after) {
  std::uint64_t most = 0;
  for (std::size_t i = 0; i < after.size() && i < before.size(); ++i) {
    const std::uint64_t then = before[i].second.resident_kb;
    most =
        std::max(most, after[i].second.resident_kb > then ? after[i].second.resident_kb - then : 0);
  }
  return most;
}

Outcome attack(const std::string& name, const ScenarioOptions& options, bool secured) {
  TeamOptions team = team_of(options);
  team.robots = 5;
  team.secured = secured;
  Stage stage(name, options, team, 1);
  stage.start();
  const std::string packets = capture(stage, seconds(2));
  const auto before = stage.team.sizes();
  test::ChildProcess attacker(
      stage.hosts.on_host(stage.hosts.count() - 1,
                          {BENCH_ATTACK, "40", "1000", std::to_string(options.seed), packets}));
  const std::int64_t from = now_ns();
  stage.report_wire(stage.observed(seconds(10)));
  const Knowledge during =
      stage.report("the team's own packets, changed, 1000 a second", {from, now_ns()});
  stage.outcome.expect(attacker.is_running(), "the attack went on: " + attacker.err());
  attacker.end();
  const std::int64_t ended = now_ns();
  stage.report_wire(seconds(3));
  const Knowledge after = stage.report("afterwards", {ended, now_ns()});
  const std::uint64_t growth = largest_growth(before, stage.team.sizes());
  stage.outcome.say("largest growth of a process: " + std::to_string(growth) + " kB");
  for (RobotId robot = 1; robot <= team.robots; ++robot) {
    const bool lives =
        stage.team.agent(robot).is_running() && stage.team.fusion(robot).is_running();
    stage.outcome.expect(lives, "robot " + std::to_string(robot) + " is not crashed");
  }
  stage.outcome.expect(growth <= 4000, "no process grows by more than 4 MB");
  stage.outcome.expect((during.robots & ~everybody(5)) == 0, "no false robot");
  stage.outcome.expect(during.served >= 0.99, "every behaviour is served");
  stage.outcome.expect(after.robots == everybody(5), "all robots in all models");
  if (secured) stage.outcome.expect(during.air_share >= 0.99, "no sample is lost");
  return stage.outcome;
}

}  // namespace

Outcome attack_off(const ScenarioOptions& options) {
  return attack("attack", options, false);
}

Outcome attack_on(const ScenarioOptions& options) {
  return attack("attack-secured", options, true);
}

Outcome security(const ScenarioOptions& options) {
  TeamOptions plain = team_of(options);
  plain.robots = 5;
  TeamOptions secured = plain;
  secured.secured = true;
  Outcome before;
  const auto take_turn = [&](const TeamOptions& team, const char* name, std::size_t strangers) {
    Stage stage("security", options, team, strangers);
    const Cost cost = measure(stage, name);
    before.lines.insert(before.lines.end(), stage.outcome.lines.begin(), stage.outcome.lines.end());
    before.broken.insert(
        before.broken.end(), stage.outcome.broken.begin(), stage.outcome.broken.end());
    return cost;
  };
  // Both twice, in turns: whatever else the machine does can only make a model older.
  Cost off = take_turn(plain, "security off", 0);
  const Cost first_on = take_turn(secured, "security on", 2);
  off.age_ms = std::min(off.age_ms, take_turn(plain, "security off", 0).age_ms);
  Stage stage("security", options, secured, 2);
  const Cost on = measure(stage, "security on");
  stage.outcome.lines.insert(stage.outcome.lines.begin(), before.lines.begin(), before.lines.end());
  stage.outcome.broken.insert(
      stage.outcome.broken.end(), before.broken.begin(), before.broken.end());
  for (const double start_ms : {first_on.start_ms, on.start_ms}) {
    stage.outcome.expect(start_ms >= 0 && start_ms <= 3000.0, "start-up within 3 s");
  }
  // A ratio of two times around a millisecond needs the whole length: in a few seconds of a machine
  // that does other things as well it says more about those.
  if (options.length >= 1.0) {
    stage.outcome.expect(
        std::min(first_on.age_ms, on.age_ms) <= std::max(1.5 * off.age_ms, off.age_ms + 0.5),
        "latency within 1.5 of that without, or half a millisecond");
  }
  expect_no_stranger(stage, secured);
  expect_no_impostor(stage);
  return stage.outcome;
}

}  // namespace teamsight::network
