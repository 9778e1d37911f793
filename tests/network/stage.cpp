// tests/network/stage.cpp: see stage.hpp.
#include "tests/network/stage.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "bus/profile.hpp"

namespace teamsight::network {
namespace {

constexpr const char* kCard = "wlan0";
const std::string kNoTopic = "discovery, acknowledgements, other";

double ms_since(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-6 * static_cast<double>(to_ns - from_ns);
}

void keep_worst(Knowledge& worst, const Knowledge& one) {
  worst.served = std::min(worst.served, one.served);
  worst.oldest_ms = std::max(worst.oldest_ms, one.oldest_ms);
  worst.own_rate_hz = std::min(worst.own_rate_hz, one.own_rate_hz);
  worst.air_gap_ms = std::max(worst.air_gap_ms, one.air_gap_ms);
  worst.air_age_ms = std::max(worst.air_age_ms, one.air_age_ms);
  worst.leaders.insert(one.leaders.begin(), one.leaders.end());
  worst.robots = static_cast<std::uint8_t>(worst.robots & one.robots);
}

std::string leaders_of(const Knowledge& one) {
  std::string all;
  for (const int leader : one.leaders) all += (all.empty() ? "" : ",") + std::to_string(leader);
  return all.empty() ? "-" : all;
}

}  // namespace

std::string number(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

std::uint8_t everybody(RobotId robots) {
  return static_cast<std::uint8_t>((1U << robots) - 1U);
}

TeamOptions team_of(const ScenarioOptions& options) {
  TeamOptions team;
  team.profile = options.profile;
  team.more_team_lines = options.more_team_lines;
  return team;
}

milliseconds lease_of(const ScenarioOptions& options) {
  const auto path = test::source_path("config/dds/" + options.profile + ".xml").string();
  return std::chrono::duration_cast<milliseconds>(bus::load_profile(path, "").lease);
}

Stage::Stage(const std::string& scenario,
             const ScenarioOptions& options,
             const TeamOptions& team_options,
             std::size_t more_hosts)
    : hosts(team_options.robots + (team_options.has_coach ? 1U : 0U) + more_hosts,
            kCard,
            options.seed),
      team(hosts, team_options),
      length_(options.length) {
  outcome.scenario = scenario;
}

milliseconds Stage::observed(milliseconds base) const {
  return std::chrono::duration_cast<milliseconds>(base * length_);
}

double Stage::start() {
  const std::int64_t begin = started_ns_ = now_ns();
  team.start_all();
  const std::uint8_t all = everybody(team.robots());
  const double took = await(Channel::kChoice, begin, seconds(10), [all](const Sight& sight) {
    return is_fresh(sight) && sight.robots == all;
  });
  outcome.say("all robots in all models " + number(took, 0) + " ms after the first was started");
  outcome.expect(took >= 0, "all robots come into all models: " + team.complaints());
  const RobotId strongest = team.robots();
  const double led = await(Channel::kLeader, begin, seconds(10), [strongest](const Sight& sight) {
    return sight.maker == strongest;
  });
  outcome.expect(led >= 0, "the strongest leads: " + team.complaints());
  wire_at_start_ = hosts.network().bytes_by_writer();
  double sent = 0.0;
  for (std::size_t host = 0; host < hosts.count(); ++host) {
    sent += static_cast<double>(hosts.network().counters(host).bytes);
  }
  outcome.say("until then on the wire, mostly discovery: " + number(1e-3 * sent, 0) + " kB in " +
              number(ms_since(begin, now_ns()), 0) + " ms");
  marked_ = mark();
  return took;
}

Interval Stage::run_for(milliseconds duration) const {
  const std::int64_t from = now_ns();
  pause(duration);
  return {from, now_ns()};
}

Knowledge Stage::report(const std::string& title, const Interval& interval) {
  outcome.say(title);
  if (marked_) say_wire(*marked_);
  marked_ = mark();
  outcome.say(
      "  robot  served  oldest ms  own Hz  air share  air gap ms  ball m  bound m  leaders  "
      "robots");
  std::optional<Knowledge> worst;
  double air_share = 0.0;
  double ball_error = 0.0;
  double ball_variance = 0.0;
  int readers = 0;
  for (RobotId robot = 1; robot <= team.robots(); ++robot) {
    const Knowledge one = knowledge_of(team.sights(robot), interval);
    std::array<char, 160> line{};
    std::snprintf(line.data(),
                  line.size(),
                  "  %5d  %6.3f  %9.0f  %6.1f  %9.3f  %10.0f  %6.3f  %7.3f  %7s  %6x",
                  static_cast<int>(robot),
                  one.served,
                  one.oldest_ms,
                  one.own_rate_hz,
                  one.air_share,
                  one.air_gap_ms,
                  one.ball_rmse_m,
                  one.ball_bound_m,
                  leaders_of(one).c_str(),
                  static_cast<unsigned>(one.robots));
    outcome.say(line.data());
    ball_error += one.ball_rmse_m * one.ball_rmse_m / team.robots();
    ball_variance += one.ball_bound_m * one.ball_bound_m / team.robots();
    if (!one.leaders.contains(robot)) {
      air_share += one.air_share;
      ++readers;
    }
    if (worst) {
      keep_worst(*worst, one);
    } else {
      worst = one;
    }
  }
  if (!worst) return {};
  if (readers > 0) worst->air_share = air_share / readers;
  worst->ball_rmse_m = std::sqrt(ball_error);
  worst->ball_bound_m = std::sqrt(ball_variance);
  return *worst;
}

WireMark Stage::mark() {
  WireMark mark{now_ns(), {}};
  for (std::size_t host = 0; host < hosts.count(); ++host) {
    mark.bytes.push_back(hosts.network().counters(host).bytes);
  }
  return mark;
}

// Says what went over the wire since then, by host, and returns the sum in Mbit/s.
double Stage::say_wire(const WireMark& since) {
  const WireMark now = mark();
  const double passed_s = 1e-3 * ms_since(since.at_ns, now.at_ns);
  double sum = 0.0;
  std::string line = "on the wire, kB/s per host:";
  for (std::size_t host = 0; host < hosts.count(); ++host) {
    const double rate = static_cast<double>(now.bytes[host] - since.bytes[host]) / passed_s;
    sum += rate;
    line += " " + number(1e-3 * rate);
  }
  const double mbit = 8e-6 * sum;
  outcome.say(line + "; together " + number(mbit, 2) + " Mbit/s");
  return mbit;
}

double Stage::report_wire(milliseconds duration) {
  const WireMark before = mark();
  wire_before_ = hosts.network().bytes_by_writer();
  const Interval interval = run_for(duration);
  wire_after_ = hosts.network().bytes_by_writer();
  wire_seconds_ = 1e-3 * ms_since(interval.from_ns, interval.to_ns);
  const double mbit = say_wire(before);
  marked_.reset();  // it has been said
  return mbit;
}

// One topic's row: of each host in the stretch of calm, of all together, and of all at the start.
std::string Stage::topic_line(const std::string& topic,
                              const std::map<WriterGuid, std::string>& topics) const {
  const auto bytes = [&](const BytesByWriter& wire, std::size_t host) {
    double sum = 0.0;
    for (const auto& [writer, count] : wire.at(host)) {
      const auto named = topics.find(writer);
      const std::string& name = named == topics.end() ? kNoTopic : named->second;
      if (name == topic) sum += 1e-3 * static_cast<double>(count);
    }
    return sum;
  };
  std::array<char, 32> text{};
  std::string line;
  double together = 0.0;
  double at_start = 0.0;
  for (std::size_t host = 0; host < hosts.count(); ++host) {
    const double rate = (bytes(wire_after_, host) - bytes(wire_before_, host)) / wire_seconds_;
    std::snprintf(text.data(), text.size(), "%7.2f", rate);
    line += text.data();
    together += rate;
    at_start += bytes(wire_at_start_, host);
  }
  std::snprintf(text.data(), text.size(), "%9.2f %9.1f  ", together, at_start);
  return line + text.data() + topic;
}

void Stage::report_topics() {
  const double seconds_so_far = 1e-3 * ms_since(started_ns_, now_ns());
  double bytes = 0.0;
  for (std::size_t host = 0; host < hosts.count(); ++host) {
    bytes += static_cast<double>(hosts.network().counters(host).bytes);
  }
  outcome.say(
      "on the wire since the first process began: " + number(8e-6 * bytes / seconds_so_far, 2) +
      " Mbit/s on average over " + number(seconds_so_far, 1) + " s");
  const auto topics = team.writers(1);
  std::set<std::string> names{kNoTopic};
  for (const auto& [writer, topic] : topics) names.insert(topic);
  outcome.say("kB/s per host, kB/s together, and kB together until all were whole, by topic:");
  for (const std::string& name : names) outcome.say(topic_line(name, topics));
}

double Stage::await(Channel channel, std::int64_t from_ns, milliseconds bound, const Claim& claim) {
  constexpr std::int64_t kHold = 500'000'000;
  double last = -1.0;
  const bool all = test::wait_until(
      [&] {
        pause(milliseconds(50));
        last = -1.0;
        for (RobotId robot = 1; robot <= team.robots(); ++robot) {
          const auto since = settled(team.sights(robot), channel, from_ns, claim);
          if (!since || now_ns() - *since < kHold) return false;
          last = std::max(last, ms_since(from_ns, *since));
        }
        return true;
      },
      bound);
  return all ? last : -1.0;
}

}  // namespace teamsight::network
