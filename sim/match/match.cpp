// sim/match/match.cpp: see match.hpp.
#include "sim/match/match.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/angle.hpp"
#include "geometry/expect.hpp"

namespace teamsight::sim {
namespace {

constexpr double kReach = 0.06;        // m between body and ball, to take hold of it
constexpr double kMouth = 0.7;         // rad to both sides of ahead where a ball can be held
constexpr double kFastestCatch = 3.5;  // m/s, of the ball against the player
constexpr double kHoldDepth = 0.03;    // m that a held ball lies inside the body's circle
constexpr double kHoldSpeed = 3.0;     // m/s at which a ball is drawn into its place
constexpr double kTacklesPerSecond = 1.0;
constexpr double kAfterLoss = 0.6;   // s before the same player can hold it again
constexpr double kDeadTime = 1.5;    // s outside before somebody rolls the ball back
constexpr double kDeadSpeed = 0.15;  // m/s

double flat_speed(const Velocity3<Field>& v) {
  return std::hypot(v.x, v.y);
}

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace

Match::Match(MatchParameters parameters, const FieldModel& field)
    : parameters_(std::move(parameters)),
      pitch_(field),
      random_(parameters_.seed),
      play_(parameters_.style, parameters_.own.size() + parameters_.opponents) {
  TEAMSIGHT_EXPECT(!parameters_.own.empty());
  TEAMSIGHT_EXPECT(parameters_.opponents <= 15);
  std::stable_sort(parameters_.script.begin(),
                   parameters_.script.end(),
                   [](const ScriptLine& a, const ScriptLine& b) { return a.at < b.at; });
  for (const RobotId id : parameters_.own) {
    place(id, -1.0);
  }
  for (std::uint32_t i = 0; i < parameters_.opponents; ++i) {
    place(static_cast<std::uint8_t>(kFirstOpponent + i), 1.0);
  }
  sent_to_.resize(state_.players.size());
  may_hold_at_.resize(state_.players.size());
  const Point<Field> centre = pitch_.at(0.0, 0.0);
  state_.balls.push_back({{centre.x, centre.y, parameters_.ball.radius}, {}, 0});
  keep_apart(state_.players, parameters_.body);
  follow_script();
}

void Match::place(std::uint8_t number, double side) {
  const Point<Field> p = pitch_.at(side * random_.uniform(0.1, 0.8), random_.uniform(-0.8, 0.8));
  Player player;
  player.number = number;
  player.X_FR = {p.x, p.y, side < 0.0 ? 0.0 : std::numbers::pi};
  state_.players.push_back(player);
}

void Match::advance_to(double seconds) {
  while (time() + kStep <= seconds + 1e-9) {
    step();
  }
}

void Match::step() {
  move_players();
  for (Ball& ball : state_.balls) {
    const Point3<Field> before = ball.p_FB;
    move_ball(ball);
    ball.turn_F = rolled(ball, before, parameters_.ball);
  }
  ++steps_;
  follow_script();
}

void Match::follow_script() {
  while (line_ < parameters_.script.size() && parameters_.script[line_].at <= time() + 1e-9) {
    happen(parameters_.script[line_++].happening);
  }
}

std::size_t Match::index_of(std::uint8_t number) const {
  const auto found =
      std::find_if(state_.players.begin(), state_.players.end(), [number](const Player& player) {
        return player.number == number;
      });
  TEAMSIGHT_EXPECT(found != state_.players.end());
  return static_cast<std::size_t>(found - state_.players.begin());
}

void Match::happen(const Happening& happening) {
  const auto player = [this](std::uint8_t number) -> Player& {
    return state_.players[index_of(number)];
  };
  std::visit(
      Overloaded{[&](const PlacePlayer& place) {
                   Player fresh;
                   fresh.number = place.number;
                   fresh.X_FR = place.X_FR;
                   player(place.number) = fresh;
                 },
                 [&](const TakePlayer& take) { player(take.number).on_field = false; },
                 [&](const SendPlayer& send) { sent_to_[index_of(send.number)] = send.target; },
                 [&](const FreePlayer& free) { sent_to_[index_of(free.number)].reset(); },
                 [&](const SlipPlayer& slip) { player(slip.number).slippery_for = slip.seconds; },
                 [&](const PutBall& put) {
                   TEAMSIGHT_EXPECT(put.ball <= state_.balls.size());
                   state_.balls.resize(std::max(state_.balls.size(), put.ball + 1));
                   state_.balls[put.ball] = {put.p_FB, put.v_FB, 0};
                 },
                 [&](const KickBall& kick) {
                   TEAMSIGHT_EXPECT(kick.ball < state_.balls.size());
                   release(state_.balls[kick.ball], kick.v_FB);
                 },
                 [&](const TakeBall&) {
                   state_.balls.resize(std::max<std::size_t>(state_.balls.size() - 1, 1));
                 }},
      happening);
}

void Match::move_players() {
  const auto& decisions = play_.decide(state_, pitch_, parameters_.body, time(), random_);
  Ball& ball = state_.balls.front();
  for (std::size_t i = 0; i < state_.players.size(); ++i) {
    Player& player = state_.players[i];
    if (!player.on_field) {
      continue;
    }
    Intention intention = decisions[i].intention;
    if (sent_to_[i].has_value()) {
      intention.velocity_F = velocity_to(*sent_to_[i], i, state_.players, parameters_.body);
    }
    if (decisions[i].kick.has_value() && ball.holder == player.number) {
      release(ball, decisions[i].kick->v_FB);
    }
    if (random_.chance(parameters_.body.slips_per_second * kStep)) {
      player.slippery_for = random_.uniform(0.1, parameters_.body.longest_slip);
    }
    drive(player, intention, kStep, parameters_.body);
  }
  keep_apart(state_.players, parameters_.body);
}

void Match::move_ball(Ball& ball) {
  const Point3<Field> before = ball.p_FB;
  change_holder(ball);
  if (ball.holder != 0) {
    dribble(ball, state_.players[index_of(ball.holder)]);
    return;
  }
  ball = moved(ball, kStep, parameters_.ball);
  meet_players(ball, state_.players, parameters_.ball.radius, parameters_.body);
  ball = pitch_.kept(before, ball, parameters_.ball.radius);
  if (&ball == &state_.balls.front()) {
    bring_back(ball);
  }
}

void Match::dribble(Ball& ball, const Player& holder) {
  const double reach = parameters_.body.radius + parameters_.ball.radius - kHoldDepth;
  const Point<Field> mouth = holder.X_FR * Point<Robot>{reach, 0.0};
  const Eigen::Vector2d here = ball.p_FB.on_floor().vector();
  // Goes along with the holder, and is drawn into its place.
  const Eigen::Vector2d carried = here + holder.v_FR.vector() * kStep;
  const Eigen::Vector2d missing = mouth.vector() - carried;
  const double most = kHoldSpeed * kStep;
  const Eigen::Vector2d drawn =
      missing.norm() > most ? Eigen::Vector2d(missing * (most / missing.norm())) : missing;
  const Eigen::Vector2d next = carried + drawn;
  const Eigen::Vector2d v = (next - here) / kStep;
  ball.p_FB = {next.x(), next.y(), parameters_.ball.radius};
  ball.v_FB = {v.x(), v.y(), 0.0};
  if (missing.norm() > 0.25) {
    release(ball, ball.v_FB);  // it was torn off
  }
}

void Match::release(Ball& ball, const Velocity3<Field>& v_FB) {
  if (ball.holder != 0) {
    may_hold_at_[index_of(ball.holder)] = time() + kAfterLoss;
  }
  ball.holder = 0;
  ball.v_FB = v_FB;
}

// A player of the other team at the ball may knock it out of its holder's hold; a player in whose
// mouth a free ball lies takes hold of it.
void Match::change_holder(Ball& ball) {
  if (ball.holder != 0 && !state_.players[index_of(ball.holder)].on_field) {
    release(ball, {});
  }
  const double reach = parameters_.body.radius + parameters_.ball.radius + kReach;
  for (std::size_t i = 0; i < state_.players.size() && parameters_.style.plays; ++i) {
    const Player& player = state_.players[i];
    const Eigen::Vector2d way = ball.p_FB.on_floor().vector() - player.X_FR.origin().vector();
    if (!player.on_field || way.norm() > reach) {
      continue;
    }
    if (ball.holder != 0) {
      tackle(ball, player);
    } else if (time() >= may_hold_at_[i] && can_hold(ball, player)) {
      ball.holder = player.number;
    }
  }
}

void Match::tackle(Ball& ball, const Player& player) {
  const bool other_team = player.is_own() != (ball.holder < kFirstOpponent);
  if (other_team && random_.chance(kTacklesPerSecond * kStep)) {
    const double angle = random_.uniform(-std::numbers::pi, std::numbers::pi);
    const double speed = random_.uniform(1.0, 2.5);
    release(ball, {speed * std::cos(angle), speed * std::sin(angle), 0.0});
  }
}

bool Match::can_hold(const Ball& ball, const Player& player) const {
  const Eigen::Vector2d way = ball.p_FB.on_floor().vector() - player.X_FR.origin().vector();
  const double off = angle_difference(std::atan2(way.y(), way.x()), player.X_FR.theta());
  const Eigen::Vector2d v = Eigen::Vector2d(ball.v_FB.x, ball.v_FB.y) - player.v_FR.vector();
  return std::abs(off) < kMouth && v.norm() < kFastestCatch && !is_flying(ball, parameters_.ball);
}

// A ball that came to rest outside is rolled towards the centre, as people around the field do.
void Match::bring_back(Ball& ball) {
  const bool is_dead = !pitch_.is_inside(ball.p_FB.on_floor(), -0.05) &&
                       flat_speed(ball.v_FB) < kDeadSpeed && !is_flying(ball, parameters_.ball);
  dead_for_ = is_dead ? dead_for_ + kStep : 0.0;
  if (dead_for_ < kDeadTime) {
    return;
  }
  const Eigen::Vector2d way = pitch_.at(0.0, 0.0).vector() - ball.p_FB.on_floor().vector();
  const double length = 0.5 * way.norm();
  const double speed = std::sqrt(2.0 * parameters_.ball.deceleration * length);
  const Eigen::Vector2d v = way.normalized() * speed;
  ball.v_FB = {v.x(), v.y(), 0.0};
  dead_for_ = 0.0;
}

}  // namespace teamsight::sim
