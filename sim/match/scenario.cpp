// sim/match/scenario.cpp: see scenario.hpp.
#include "sim/match/scenario.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace teamsight::sim {
namespace {

// What a scenario changes in an ordinary match.
struct Director {
  MatchParameters& match;
  const Pitch& pitch;
  Random& random;

  void say(double at, const Happening& happening) const { match.script.push_back({at, happening}); }

  [[nodiscard]] Point<Field> somewhere() const {
    return pitch.at(random.uniform(-0.85, 0.85), random.uniform(-0.85, 0.85));
  }

  [[nodiscard]] double direction() const {
    return random.uniform(-std::numbers::pi, std::numbers::pi);
  }
};

void free_play(const Director&) {}

void stand(const Director& director) {
  director.match.style.plays = false;
  director.match.body.slips_per_second = 0.0;
}

void fast_passes(const Director& director) {
  PlayStyle& style = director.match.style;
  style.shortest_hold = 0.1;
  style.longest_hold = 0.5;
  style.shot_share = 0.0;
  style.lofted_share = 0.0;
  style.pass_arrival = 4.0;
}

void kicks(const Director& director) {
  PlayStyle& style = director.match.style;
  style.shortest_hold = 0.1;
  style.longest_hold = 0.8;
  style.shot_share = 1.0;
  style.lofted_share = 0.0;
  style.slowest_shot = 10.0;
  style.fastest_shot = 10.0;
}

void high_balls(const Director& director) {
  PlayStyle& style = director.match.style;
  style.shortest_hold = 0.1;
  style.longest_hold = 0.8;
  style.lofted_share = 1.0;
  style.steepest_loft = 0.9;
  style.pass_arrival = 6.0;
}

void crowd(const Director& director) {
  director.match.style.formation_size = 0.25;
  director.match.style.shot_share = 0.0;
  director.match.style.fastest_shot = 3.0;
}

// A second ball rolls through the match for a while, three times.
void two_balls(const Director& director) {
  for (int i = 0; i < 3; ++i) {
    const double at = 5.0 + 20.0 * i;
    const Point<Field> p = director.somewhere();
    const double angle = director.direction();
    const double speed = director.random.uniform(0.0, 4.0);
    const double radius = director.match.ball.radius;
    director.say(
        at,
        PutBall{1, {p.x, p.y, radius}, {speed * std::cos(angle), speed * std::sin(angle), 0.0}});
    director.say(at + 12.0, TakeBall{});
  }
}

// A player leaves once and comes back elsewhere.
void leave_and_join(const Director& director, std::uint8_t number) {
  const double leaves = director.random.uniform(5.0, 30.0);
  const Point<Field> p = director.somewhere();
  director.say(leaves, TakePlayer{number});
  director.say(leaves + director.random.uniform(5.0, 20.0),
               PlacePlayer{number, {p.x, p.y, director.direction()}});
}

// The second to fourth of both teams.
void join_and_leave(const Director& director) {
  for (std::size_t i = 1; i < std::min<std::size_t>(director.match.own.size(), 4); ++i) {
    leave_and_join(director, director.match.own[i]);
  }
  for (std::uint32_t i = 1; i < std::min<std::uint32_t>(director.match.opponents, 4); ++i) {
    leave_and_join(director, static_cast<std::uint8_t>(kFirstOpponent + i));
  }
}

// Own robots are lifted and put down elsewhere, one every ten seconds.
void kidnap(const Director& director) {
  double at = 10.0;
  for (const RobotId number : director.match.own) {
    const Point<Field> p = director.somewhere();
    director.say(at, PlacePlayer{number, {p.x, p.y, director.direction()}});
    at += 10.0;
  }
}

void slippery(const Director& director) {
  director.match.body.slips_per_second = 0.5;
  director.match.body.longest_slip = 0.8;
}

struct Known {
  ScenarioName name;
  void (*direct)(const Director&){nullptr};
};

constexpr std::array kKnown{
    Known{{"play", "an ordinary match: dribbling, passes, shots, a quarter of them lofted"},
          free_play},
    Known{{"stand", "everybody and the ball stand still"}, stand},
    Known{{"fast_passes", "the ball is held shortly and passed hard along the floor"}, fast_passes},
    Known{{"kicks", "flat kicks at 10 m/s at the goals"}, kicks},
    Known{{"high_balls", "every kick flies, up to some metres high, and bounces"}, high_balls},
    Known{{"crowd", "all ten within some metres of the ball, which is often hidden"}, crowd},
    Known{{"two_balls", "a second ball is on the field for 12 of every 20 s"}, two_balls},
    Known{{"join_and_leave", "three of each team leave the field and come back"}, join_and_leave},
    Known{{"kidnap", "own robots are put down elsewhere, one every 10 s"}, kidnap},
    Known{{"slippery", "wheels slip every other second"}, slippery}};

constexpr auto kNames = [] {
  std::array<ScenarioName, kKnown.size()> names{};
  for (std::size_t i = 0; i < kKnown.size(); ++i) {
    names[i] = kKnown[i].name;
  }
  return names;
}();

}  // namespace

std::span<const ScenarioName> scenario_names() {
  return kNames;
}

std::optional<MatchParameters> make_scenario(std::string_view name,
                                             std::uint32_t seed,
                                             const FieldModel& field) {
  MatchParameters base;
  base.seed = seed;
  base.own = {1, 2, 3, 4, 5};
  return make_scenario(name, std::move(base), field);
}

std::optional<MatchParameters> make_scenario(std::string_view name,
                                             MatchParameters base,
                                             const FieldModel& field) {
  const auto known = std::find_if(
      kKnown.begin(), kKnown.end(), [name](const Known& one) { return one.name.name == name; });
  if (known == kKnown.end()) {
    return std::nullopt;
  }
  const Pitch pitch(field);
  Random random(base.seed ^ 0x5CE9A210U);
  known->direct({base, pitch, random});
  return base;
}

}  // namespace teamsight::sim
