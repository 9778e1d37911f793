// tests/network/scenarios.cpp: see scenarios.hpp.
#include "tests/network/scenarios.hpp"

#include <csignal>

#include "tests/network/held_thread.hpp"
#include "tests/network/stage.hpp"

namespace teamsight::network {
namespace {

constexpr double kLeagueGoal = 2.0;  // Mbit/s
constexpr double kFullRate = 29.0;   // Hz, of 30: what a busy computer may delay

bool is_led_by(const Sight& sight, RobotId robot) {
  return sight.maker == robot;
}

// The share of the time without any model to go by; every behaviour is served, come what may.
void expect_served(Stage& stage, const Knowledge& worst, double own_rate_hz = kFullRate) {
  stage.outcome.expect(worst.served >= 0.99, "every behaviour has a model of at most 300 ms");
  stage.outcome.expect(worst.own_rate_hz >= own_rate_hz, "every own host's model at full rate");
}

void expect_recovery(Stage& stage, const std::string& of, double took_ms, double limit_ms) {
  stage.outcome.say(of + ": " + number(took_ms, 0) + " ms (limit " + number(limit_ms, 0) + ")");
  stage.outcome.expect(took_ms >= 0 && took_ms <= limit_ms, of + " within the limit");
}

double await_whole(Stage& stage, std::int64_t from_ns, milliseconds bound) {
  const std::uint8_t all = everybody(stage.team.robots());
  return stage.await(Channel::kChoice, from_ns, bound, [all](const Sight& sight) {
    return is_fresh(sight) && sight.robots == all;
  });
}

double await_leader(Stage& stage, RobotId leader, std::int64_t from_ns, milliseconds bound) {
  return stage.await(Channel::kLeader, from_ns, bound, [leader](const Sight& sight) {
    return is_led_by(sight, leader);
  });
}

Outcome calm(const ScenarioOptions& options) {
  TeamOptions team = team_of(options);
  team.robots = 5;  // what plays at once
  Stage stage("calm", options, team);
  stage.start();
  const std::int64_t from = now_ns();
  const double mbit = stage.report_wire(stage.observed(seconds(8)));
  const Knowledge worst = stage.report("calm", {from, now_ns()});
  expect_served(stage, worst);
  stage.outcome.expect(worst.robots == everybody(team.robots), "all robots in all models");
  stage.outcome.expect(worst.air_share >= 0.99, "nothing is lost");
  stage.outcome.expect(mbit <= kLeagueGoal, "five robots need at most 2.0 Mbit/s");
  stage.report_topics();
  return stage.outcome;
}

Outcome under(const std::string& name,
              const ScenarioOptions& options,
              const Weather& weather,
              double air_share,
              double air_gap_ms) {
  Stage stage(name, options, team_of(options));
  stage.start();
  stage.hosts.network().set_weather(weather);
  // A ball's error lasts for a second or so: it takes many seconds till its RMS means something.
  const Knowledge worst = stage.report(name, stage.run_for(stage.observed(seconds(20))));
  expect_served(stage, worst);
  stage.outcome.expect(worst.air_share >= air_share, "share of the leader's models over the air");
  stage.outcome.expect(worst.air_gap_ms <= air_gap_ms, "longest gap over the air");
  stage.outcome.expect(worst.ball_rmse_m <= 1.3 * worst.ball_bound_m,
                       "ball within 1.3 x its bound");
  stage.hosts.network().set_weather({});
  expect_recovery(stage, "whole again", await_whole(stage, now_ns(), seconds(5)), 1000.0);
  return stage.outcome;
}

Outcome loss_10(const ScenarioOptions& options) {
  return under("loss-10", options, {.loss = 0.10}, 0.85, 500.0);
}

Outcome loss_30(const ScenarioOptions& options) {
  return under("loss-30", options, {.loss = 0.30}, 0.65, 500.0);
}

// On average 5 frames in a row, a sixth of all.
Outcome bursts(const ScenarioOptions& options) {
  return under("bursts", options, {.burst_begins = 0.04, .burst_ends = 0.2}, 0.70, 1000.0);
}

Outcome delay(const ScenarioOptions& options) {
  const Weather weather{.delay = milliseconds(200), .jitter = milliseconds(60)};
  return under("delay", options, weather, 0.5, 500.0);
}

// The ball in the newest world model that robot 1 had; 0: no ball.
std::uint32_t ball_of(Team& team) {
  for (auto sight = team.sights(1).rbegin(); sight != team.sights(1).rend(); ++sight) {
    if (sight->channel == Channel::kChoice) return sight->ball_track;
  }
  return 0;
}

// The ball that a robot was told of last: while nobody of a half sees the ball, its models have
// none.
std::uint32_t last_ball_of(Team& team, RobotId robot) {
  const std::vector<Sight>& sights = team.sights(robot);
  for (auto sight = sights.rbegin(); sight != sights.rend(); ++sight) {
    if (sight->channel == Channel::kChoice && sight->ball_track != 0) return sight->ball_track;
  }
  return 0;
}

void expect_ball(Stage& stage, std::uint32_t before) {
  const std::uint32_t after = ball_of(stage.team);
  stage.outcome.expect(after == before,
                       "the ball keeps its id: it was " + std::to_string(before) + " and is " +
                           std::to_string(after));
}

// After a long split the participants have forgotten each other, and find each other again when
// they say that they exist (SPDPInterval, 2 s). A half that does not see the ball for some seconds
// may lose it and name it anew; the name that all go on with is the leading half's.
Outcome split(const std::string& name, const ScenarioOptions& options, milliseconds duration) {
  constexpr milliseconds kForgotten = seconds(10);
  const bool is_long = duration > kForgotten;
  Stage stage(name, options, team_of(options));
  stage.start();
  const std::int64_t cut = now_ns();
  stage.hosts.network().set_groups({0, 0, 0, 1, 1, 1, 1});
  const auto half_of = [](RobotId robot) {
    return robot <= 3 ? RobotId{3} : RobotId{6};
  };
  pause(duration);
  for (RobotId robot = 1; robot <= stage.team.robots(); ++robot) {
    const auto led =
        first(stage.team.sights(robot), Channel::kLeader, cut, [&](const Sight& sight) {
          return is_led_by(sight, half_of(robot));
        });
    const double took = led ? 1e-6 * static_cast<double>(*led - cut) : -1.0;
    expect_recovery(stage,
                    "robot " + std::to_string(robot) + " hears a leader of its half",
                    took,
                    static_cast<double>(lease_of(options).count()) + 100.0);
  }
  expect_served(stage, stage.report(name, {cut, now_ns()}));
  const std::uint32_t ball_before = last_ball_of(stage.team, 6);
  const double limit = is_long ? 2500.0 : 1000.0;
  const std::int64_t healed = now_ns();
  stage.hosts.network().set_groups(std::vector<int>(7, 0));
  expect_recovery(
      stage, "one model everywhere", await_leader(stage, 6, healed, seconds(10)), limit);
  stage.outcome.expect(await_whole(stage, healed, seconds(10)) >= 0, "all robots in all models");
  expect_ball(stage, ball_before);
  return stage.outcome;
}

Outcome split_5(const ScenarioOptions& options) {
  return split("split-5", options, seconds(5));
}

Outcome split_60(const ScenarioOptions& options) {
  return split("split-60", options, seconds(60));
}

/// The time from `from_ns` until every robot but the leader's own heard robot 5's fusion.
void expect_hand_over(Stage& stage, const ScenarioOptions& options, std::int64_t from_ns) {
  pause(seconds(2));
  double last = 0.0;
  for (RobotId robot = 1; robot < 6; ++robot) {
    const auto led =
        first(stage.team.sights(robot), Channel::kLeader, from_ns, [](const Sight& sight) {
          return is_led_by(sight, 5);
        });
    last = led && last >= 0.0 ? std::max(last, 1e-6 * static_cast<double>(*led - from_ns)) : -1.0;
  }
  const double limit = static_cast<double>(lease_of(options).count()) + 100.0;
  expect_recovery(stage, "the next leader's model at every other robot", last, limit);
}

Outcome vanish(const ScenarioOptions& options) {
  Stage stage("vanish", options, team_of(options));
  stage.start();
  const std::uint32_t ball = ball_of(stage.team);
  const std::int64_t cut = now_ns();
  stage.hosts.network().cut(stage.team.host(6), true);
  expect_hand_over(stage, options, cut);
  expect_served(stage, stage.report("the leader's host has vanished", {cut, now_ns()}));
  expect_ball(stage, ball);
  const std::int64_t back = now_ns();
  stage.hosts.network().cut(stage.team.host(6), false);
  expect_recovery(stage, "one model everywhere", await_leader(stage, 6, back, seconds(10)), 1000.0);
  return stage.outcome;
}

Outcome freeze(const ScenarioOptions& options) {
  Stage stage("freeze", options, team_of(options));
  stage.start();
  const std::int64_t frozen = now_ns();
  stage.team.agent(6).kill(SIGSTOP);
  stage.team.fusion(6).kill(SIGSTOP);
  expect_hand_over(stage, options, frozen);
  stage.team.agent(6).kill(SIGCONT);
  stage.team.fusion(6).kill(SIGCONT);
  const std::int64_t thawed = now_ns();
  stage.report("the leader's host is frozen", {frozen, thawed});
  stage.outcome.expect(await_whole(stage, thawed, seconds(10)) >= 0, "all robots in all models");
  expect_recovery(
      stage, "one model everywhere", await_leader(stage, 6, thawed, seconds(10)), 3000.0);
  return stage.outcome;
}

Outcome hang(const ScenarioOptions& options) {
  Stage stage("hang", options, team_of(options));
  stage.start();
  const std::uint32_t ball = ball_of(stage.team);
  const std::int64_t hung = now_ns();
  {
    const HeldThread main_loop(stage.team.fusion(6).pid());
    expect_hand_over(stage, options, hung);
    stage.report("the leading fusion's main loop hangs", {hung, now_ns()});
    expect_ball(stage, ball);
  }
  const std::int64_t again = now_ns();
  expect_recovery(stage, "it leads again", await_leader(stage, 6, again, seconds(10)), 3000.0);
  return stage.outcome;
}

Outcome kill_leader(const ScenarioOptions& options) {
  Stage stage("kill", options, team_of(options));
  stage.start();
  const std::uint32_t ball = ball_of(stage.team);
  const std::int64_t killed = now_ns();
  stage.team.fusion(6).kill(SIGKILL);
  expect_hand_over(stage, options, killed);
  stage.report("the leading fusion is killed", {killed, now_ns()});
  expect_ball(stage, ball);
  const std::int64_t again = now_ns();
  stage.team.start_fusion(6);
  expect_recovery(stage, "it leads again", await_leader(stage, 6, again, seconds(10)), 3000.0);
  return stage.outcome;
}

Outcome join_late(const std::string& name,
                  const ScenarioOptions& options,
                  const Weather& weather,
                  double limit_ms) {
  Stage stage(name, options, team_of(options));
  for (RobotId robot = 1; robot < 6; ++robot) stage.team.start(robot);
  stage.team.start_coach();
  pause(seconds(4));
  stage.hosts.network().set_weather(weather);
  const std::int64_t started = now_ns();
  stage.team.start(6);
  expect_recovery(
      stage, "the new robot is in every model", await_whole(stage, started, seconds(25)), limit_ms);
  stage.report("while it comes", {started, now_ns()});
  return stage.outcome;
}

Outcome late_robot(const ScenarioOptions& options) {
  return join_late("late-robot", options, {}, 2000.0);
}

// Each announcement that is lost costs one more SPDPInterval (2 s).
Outcome late_robot_lossy(const ScenarioOptions& options) {
  return join_late("late-robot-lossy", options, {.loss = 0.30}, 20000.0);
}

Outcome clock_jump(const ScenarioOptions& options) {
  TeamOptions team = team_of(options);
  team.with_loose_clock = 6;
  Stage stage("clock-jump", options, team);
  stage.start();
  const std::int64_t from = now_ns();
  for (const auto ahead : {seconds(-60), seconds(30), seconds(-5), seconds(0)}) {
    stage.team.jump_wall_clock(ahead);
    pause(stage.observed(seconds(2)));
  }
  const Knowledge worst = stage.report("the leader's wall clock jumps", {from, now_ns()});
  expect_served(stage, worst);
  stage.outcome.expect(worst.air_share >= 0.99, "nothing is lost");
  stage.outcome.expect(worst.leaders == std::set<int>{6}, "nobody else takes over");
  return stage.outcome;
}

Outcome no_multicast(const ScenarioOptions& given) {
  ScenarioOptions options = given;
  options.profile = "unicast";
  Stage stage("no-multicast", options, team_of(options));
  stage.hosts.network().set_weather({.drops_multicast = true});
  stage.start();
  const std::int64_t from = now_ns();
  stage.report_wire(stage.observed(seconds(5)));
  const Knowledge worst = stage.report("a network without multicast", {from, now_ns()});
  expect_served(stage, worst);
  stage.outcome.expect(worst.robots == everybody(6), "all robots in all models");
  return stage.outcome;
}

Outcome opponents(const ScenarioOptions& options) {
  Stage stage("opponents", options, team_of(options), 2);
  TeamOptions others = team_of(options);
  others.name = "others";
  others.first_host = 7;
  others.robots = 2;
  others.has_coach = false;
  Team opponents(stage.hosts, others);
  opponents.start_all();
  stage.start();
  const Interval interval = stage.run_for(stage.observed(seconds(4)));
  const Knowledge worst = stage.report("another team with the same domain id", interval);
  expect_served(stage, worst);
  stage.outcome.expect(worst.leaders == std::set<int>{6}, "nobody hears the other team");
  const Knowledge theirs = knowledge_of(opponents.sights(1), interval);
  stage.outcome.expect(theirs.leaders == std::set<int>{2}, "the other team hears only itself");
  return stage.outcome;
}

Outcome flood(const ScenarioOptions& options) {
  Stage stage("flood", options, team_of(options), 1);
  stage.start();
  const std::size_t host = stage.hosts.count() - 1;
  test::ChildProcess flooder(stage.hosts.on_host(host, {BENCH_FLOOD, "40", "1000"}));
  const Knowledge worst = stage.report("a host floods", stage.run_for(stage.observed(seconds(5))));
  stage.outcome.expect(flooder.is_running(), "the flood went on: " + flooder.err());
  flooder.end();
  stage.outcome.expect(worst.served >= 0.99, "every behaviour has a model of at most 300 ms");
  stage.outcome.expect(worst.robots == everybody(6), "all robots in all models");
  expect_recovery(stage, "whole again", await_whole(stage, now_ns(), seconds(5)), 1000.0);
  return stage.outcome;
}

}  // namespace

const std::vector<Scenario>& all_scenarios() {
  static const std::vector<Scenario> all{
      {"calm", "five robots, nothing wrong; rate on the wire", calm},
      {"loss-10", "10 % of the frames are lost", loss_10},
      {"loss-30", "30 % of the frames are lost", loss_30},
      {"bursts", "losses of five frames in a row", bursts},
      {"delay", "200 ms delay with 60 ms jitter and reordering", delay},
      {"split-5", "two halves for 5 s", split_5},
      {"split-60", "two halves for 60 s", split_60},
      {"vanish", "the leader's host vanishes without a word", vanish},
      {"freeze", "the leader's host freezes for 2 s", freeze},
      {"hang", "the leading fusion's main loop hangs for 2 s, its other threads go on", hang},
      {"kill", "the leading fusion is killed", kill_leader},
      {"late-robot", "a robot starts four seconds after the others", late_robot},
      {"late-robot-lossy", "the same while 30 % of the frames are lost", late_robot_lossy},
      {"clock-jump", "the wall clock of the leader's host jumps", clock_jump},
      {"no-multicast", "a network that drops multicast, with the unicast profile", no_multicast},
      {"opponents", "another team with the same domain id", opponents},
      {"security",
       "the same team without and with DDS Security; strangers and impostors",
       security},
      {"attack", "a stranger replays, truncates and forges; security off", attack_off},
      {"attack-secured", "the same with security on", attack_on},
      {"twin", "a second computer with the robot file of a first one", twin},
      {"flood", "a host floods the team's ports, 1000 packets a second", flood},
  };
  return all;
}

}  // namespace teamsight::network
