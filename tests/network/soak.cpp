// tests/network/soak.cpp: random faults for minutes. See scenarios.hpp.
#include <algorithm>
#include <csignal>
#include <map>
#include <random>

#include "tests/network/stage.hpp"

namespace teamsight::network {
namespace {

using Sizes = std::map<std::string, ProcessSize>;

Sizes sizes_of(Team& team) {
  const auto list = team.sizes();
  return {list.begin(), list.end()};
}

/// One fault, from its beginning to its end.
class Faults {
 public:
  Faults(Stage& stage, std::uint64_t seed) : stage_(&stage), random_(seed) {}

  std::string one() {
    const auto robot = static_cast<RobotId>(draw(1, 6));
    switch (draw(0, 6)) {
      case 0:
        return weather("loss", {.loss = 0.01 * draw(5, 30)});
      case 1:
        return weather("bursts", {.burst_begins = 0.04});
      case 2:
        return weather("delay", {.delay = milliseconds(draw(20, 200)), .jitter = milliseconds(60)});
      case 3:
        return split();
      case 4:
        return vanish(robot);
      case 5:
        return freeze(robot);
      default:
        return kill(robot);
    }
  }

 private:
  int draw(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  void wait() { pause(milliseconds(draw(500, 6000))); }

  std::string weather(const std::string& name, const Weather& weather) {
    stage_->hosts.network().set_weather(weather);
    wait();
    stage_->hosts.network().set_weather({});
    return name;
  }

  std::string split() {
    std::vector<int> groups;
    for (std::size_t host = 0; host < stage_->hosts.count(); ++host) groups.push_back(draw(0, 1));
    stage_->hosts.network().set_groups(groups);
    wait();
    stage_->hosts.network().set_groups(std::vector<int>(stage_->hosts.count(), 0));
    return "split";
  }

  std::string vanish(RobotId robot) {
    stage_->hosts.network().cut(stage_->team.host(robot), true);
    wait();
    stage_->hosts.network().cut(stage_->team.host(robot), false);
    return "vanish";
  }

  std::string freeze(RobotId robot) {
    stage_->team.fusion(robot).kill(SIGSTOP);
    stage_->team.agent(robot).kill(SIGSTOP);
    wait();
    stage_->team.agent(robot).kill(SIGCONT);
    stage_->team.fusion(robot).kill(SIGCONT);
    return "freeze";
  }

  std::string kill(RobotId robot) {
    stage_->team.agent(robot).kill(SIGKILL);
    stage_->team.fusion(robot).kill(SIGKILL);
    wait();
    stage_->team.start(robot);
    return "kill";
  }

  Stage* stage_;
  std::mt19937_64 random_;
};

// A restarted process begins anew: it is compared with the size it had when it last was new enough.
void compare(const Sizes& before, const Sizes& after, Outcome& outcome) {
  constexpr std::uint64_t kSlack_kb = 2500;
  for (const auto& [name, now] : after) {
    const auto found = before.find(name);
    if (found == before.end()) continue;
    const ProcessSize& then = found->second;
    outcome.say(name + ": " + std::to_string(then.resident_kb) + " -> " +
                std::to_string(now.resident_kb) + " kB, " + std::to_string(then.threads) + " -> " +
                std::to_string(now.threads) + " threads, " + std::to_string(then.handles) + " -> " +
                std::to_string(now.handles) + " handles");
    outcome.expect(now.resident_kb <= then.resident_kb + kSlack_kb, name + " does not grow");
    outcome.expect(now.threads <= then.threads, name + " starts no more threads");
    outcome.expect(now.handles <= then.handles, name + " opens no more handles");
  }
}

}  // namespace

Outcome soak(const ScenarioOptions& options, double minutes) {
  Stage stage("soak", options, team_of(options));
  stage.start();
  const std::uint8_t all = everybody(stage.team.robots());
  const auto is_whole = [all](const Sight& sight) {
    return is_fresh(sight) && sight.robots == all;
  };
  Faults faults(stage, options.seed);
  std::map<std::string, int> counts;
  std::optional<Sizes> before;
  const std::int64_t end = now_ns() + static_cast<std::int64_t>(60e9 * minutes);
  const std::int64_t begin = now_ns();
  double slowest = 0.0;
  while (now_ns() < end) {
    ++counts[faults.one()];
    const double took = stage.await(Channel::kChoice, now_ns(), seconds(20), is_whole);
    stage.outcome.expect(took >= 0, "whole again after each fault: " + stage.team.complaints());
    slowest = std::max(slowest, took);
    // Caches, pools and the first peers of every kind have been seen after a tenth of the time.
    if (!before && now_ns() - begin > (end - begin) / 10) before = sizes_of(stage.team);
  }
  for (const auto& [name, count] : counts) stage.outcome.say(name + ": " + std::to_string(count));
  stage.outcome.say("slowest recovery of all robots in all models: " + number(slowest, 0) + " ms");
  compare(before.value_or(Sizes{}), sizes_of(stage.team), stage.outcome);
  return stage.outcome;
}

}  // namespace teamsight::network
