// sim/match/play.cpp: see play.hpp.
#include "sim/match/play.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"

namespace teamsight::sim {
namespace {

constexpr double kFieldMargin = 0.4;    // m inside the lines that places keep
constexpr double kHunterMargin = -0.6;  // a hunter may leave the lines so far
constexpr double kAimed = 0.08;         // rad, from where on a kicker faces its aim
constexpr double kPatience = 1.5;       // s that it tries to face it

// Which way a player's team attacks.
double side_of(const Player& player) {
  return player.is_own() ? 1.0 : -1.0;
}

double bearing(const Point<Field>& from, const Point<Field>& to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

double distance(const Point<Field>& a, const Point<Field>& b) {
  return (a.vector() - b.vector()).norm();
}

std::size_t nearest_to(const Point<Field>& p_F, bool own, const std::vector<Player>& players) {
  std::size_t best = players.size();
  double least = 1e9;
  for (std::size_t i = 0; i < players.size(); ++i) {
    const double far = distance(players[i].X_FR.origin(), p_F);
    if (players[i].on_field && players[i].is_own() == own && far < least) {
      least = far;
      best = i;
    }
  }
  return best;
}

// Where a ball can be met: it is led by the time that the way to it takes.
Point<Field> meeting_point(const Ball& ball, const Point<Field>& from, double speed) {
  const double seconds = std::min(distance(from, ball.p_FB.on_floor()) / speed, 1.2);
  return {ball.p_FB.x + 0.8 * seconds * ball.v_FB.x, ball.p_FB.y + 0.8 * seconds * ball.v_FB.y};
}

}  // namespace

Play::Play(const PlayStyle& style, std::size_t players)
    : style_(style),
      plans_(players),
      decisions_(players) {}

const std::vector<Play::Decision>& Play::decide(const MatchState& state,
                                                const Pitch& pitch,
                                                const BodyParameters& body,
                                                double time,
                                                Random& random) {
  const Moment moment{state, pitch, body, time};
  const Ball& ball = state.balls.front();
  const std::array<std::size_t, 2> hunters{nearest_to(ball.p_FB.on_floor(), false, state.players),
                                           nearest_to(ball.p_FB.on_floor(), true, state.players)};
  for (std::size_t i = 0; i < state.players.size(); ++i) {
    const Player& player = state.players[i];
    decisions_[i] = {{{0.0, 0.0}, player.X_FR.theta()}, {}};
    if (!player.on_field || !style_.plays) {
      continue;
    }
    if (ball.holder == player.number) {
      hold(i, moment, random);
      continue;
    }
    plans_[i].kick_at = -1.0;
    const bool mate_holds = ball.holder != 0 && (ball.holder < kFirstOpponent) == player.is_own();
    if (i == hunters[player.is_own() ? 1 : 0] && !mate_holds) {
      hunt(i, moment);
    } else {
      take_place(i, moment, random);
    }
  }
  return decisions_;
}

void Play::hold(std::size_t player, const Moment& moment, Random& random) {
  Plan& plan = plans_[player];
  const Player& self = moment.state.players[player];
  if (plan.kick_at < 0.0) {
    plan.kick_at = moment.time + random.uniform(style_.shortest_hold, style_.longest_hold);
    plan_kick(player, moment, random);
  }
  const double heading = bearing(self.X_FR.origin(), plan.aim);
  const Point<Field> ahead =
      moment.pitch.clamped(moment.pitch.at(0.8 * side_of(self), 0.0), kFieldMargin);
  Decision& decision = decisions_[player];
  decision.intention = {0.7 * velocity_to(ahead, player, moment.state.players, moment.body),
                        heading};
  const bool faces = std::abs(angle_difference(heading, self.X_FR.theta())) < kAimed;
  if (moment.time < plan.kick_at || (!faces && moment.time < plan.kick_at + kPatience)) {
    return;
  }
  const double theta = self.X_FR.theta() + random.normal(0.02);
  const double flat = plan.speed * std::cos(plan.loft);
  decision.kick =
      Kick{{flat * std::cos(theta), flat * std::sin(theta), plan.speed * std::sin(plan.loft)}};
  plan.kick_at = -1.0;
}

void Play::plan_kick(std::size_t player, const Moment& moment, Random& random) {
  Plan& plan = plans_[player];
  const Player& self = moment.state.players[player];
  const Point<Field> here = self.X_FR.origin();
  const Point<Field> goal = moment.pitch.goal(side_of(self));
  const auto mate = draw_mate(player, moment, random);
  const bool near = distance(here, goal) < style_.shot_range;
  if (!mate.has_value() || (near && random.chance(style_.shot_share)) || style_.shot_share >= 1.0) {
    plan.aim = {goal.x, goal.y + random.uniform(-0.8, 0.8)};
    plan.speed = random.uniform(style_.slowest_shot, style_.fastest_shot);
  } else {
    plan.aim = moment.state.players[*mate].X_FR.origin();
    const double rolling = 2.0 * BallParameters{}.deceleration * distance(here, plan.aim);
    plan.speed = std::clamp(std::sqrt(style_.pass_arrival * style_.pass_arrival + 1.3 * rolling),
                            2.0,
                            style_.fastest_shot);
  }
  const bool lofted = random.chance(style_.lofted_share);
  plan.loft = lofted ? random.uniform(style_.steepest_loft / 3.0, style_.steepest_loft) : 0.0;
  if (lofted) {
    plan.speed = std::max(plan.speed, 0.6 * style_.fastest_shot);
  }
}

std::optional<std::size_t> Play::draw_mate(std::size_t player,
                                           const Moment& moment,
                                           Random& random) const {
  const std::vector<Player>& players = moment.state.players;
  std::array<std::size_t, 32> mates{};
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < players.size() && count < mates.size(); ++i) {
    if (i != player && players[i].on_field && players[i].is_own() == players[player].is_own()) {
      mates[count++] = i;
    }
  }
  if (count == 0) {
    return std::nullopt;
  }
  return mates[random.below(count)];
}

void Play::hunt(std::size_t player, const Moment& moment) {
  const Player& self = moment.state.players[player];
  const Ball& ball = moment.state.balls.front();
  const Point<Field> here = self.X_FR.origin();
  const Point<Field> target =
      moment.pitch.clamped(meeting_point(ball, here, moment.body.max_speed), kHunterMargin);
  decisions_[player].intention = {velocity_to(target, player, moment.state.players, moment.body),
                                  bearing(here, ball.p_FB.on_floor())};
}

void Play::take_place(std::size_t player, const Moment& moment, Random& random) {
  Plan& plan = plans_[player];
  if (moment.time >= plan.wander_until) {
    const double reach = 2.0 * style_.formation_size;
    plan.wander = {random.uniform(-reach, reach), random.uniform(-reach, reach)};
    plan.wander_until = moment.time + random.uniform(2.0, 6.0);
  }
  const Player& self = moment.state.players[player];
  const Point<Field> target = moment.pitch.clamped(
      Point<Field>::from(place_of(player, moment).vector() + plan.wander), kFieldMargin);
  decisions_[player].intention = {
      velocity_to(target, player, moment.state.players, moment.body),
      bearing(self.X_FR.origin(), moment.state.balls.front().p_FB.on_floor())};
}

// A ring around a middle between the ball and the own half; a team's first player keeps its goal.
Point<Field> Play::place_of(std::size_t player, const Moment& moment) const {
  const std::vector<Player>& players = moment.state.players;
  const bool own = players[player].is_own();
  const auto is_mate = [own](const Player& other) {
    return other.is_own() == own;
  };
  const auto first = std::find_if(players.begin(), players.end(), is_mate);
  const auto index =
      static_cast<std::size_t>(players.begin() + static_cast<std::ptrdiff_t>(player) - first);
  const double side = own ? 1.0 : -1.0;
  const Ball& ball = moment.state.balls.front();
  if (index == 0 && style_.formation_size > 0.5) {
    const Point<Field> goal = moment.pitch.at(-0.93 * side, 0.0);
    return {goal.x, goal.y + std::clamp(0.2 * (ball.p_FB.y - goal.y), -1.0, 1.0)};
  }
  const double angle = std::numbers::pi * (0.25 + 0.5 * static_cast<double>(index));
  const Eigen::Vector2d ring(0.45 * moment.pitch.half_length() * std::cos(angle),
                             0.65 * moment.pitch.half_width() * std::sin(angle));
  const Eigen::Vector2d home = moment.pitch.at(-0.15 * side, 0.0).vector();
  const double share = style_.formation_size > 0.5 ? 0.4 : 1.0;
  const Eigen::Vector2d middle = home + share * (ball.p_FB.on_floor().vector() - home);
  return Point<Field>::from(middle + style_.formation_size * side * ring);
}

}  // namespace teamsight::sim
