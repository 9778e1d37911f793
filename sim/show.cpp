// sim/show.cpp: see show.hpp.
#include "sim/show.hpp"

#include "geometry/expect.hpp"
#include "sim/match/random.hpp"

namespace teamsight::sim {
namespace {

constexpr Paint kOwnShirt{40, 190, 210};    // cyan
constexpr Paint kTheirShirt{220, 40, 180};  // magenta

}  // namespace

std::vector<ScenePerson> people_around(const FieldModel& field, std::uint32_t seed) {
  Random random(seed);
  std::vector<ScenePerson> people;
  for (int i = 0; i < 6; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    const double along = random.uniform(-0.5, 0.5) * field.length;
    const double out = 0.5 * field.width + field.surround + random.uniform(0.3, 0.8);
    const auto dark = static_cast<std::uint8_t>(random.uniform(20.0, 70.0));
    const auto bright = static_cast<std::uint8_t>(random.uniform(60.0, 200.0));
    people.push_back({{field.centre.x + along, field.centre.y + side * out},
                      {dark, dark, static_cast<std::uint8_t>(dark + 12)},
                      {bright, bright, static_cast<std::uint8_t>(200 - bright / 2)}});
  }
  return people;
}

std::vector<BodyPart> low_body() {
  return {{0.25, 0.15, {24, 23, 25}, {46, 46, 50}},
          {0.06, 0.55, {70, 70, 74}, {30, 30, 32}},
          {0.035, 0.6, {16, 16, 18}, {10, 10, 12}}};
}

void show(const MatchState& state, std::size_t player, const Bodies& bodies, Scene& scene) {
  TEAMSIGHT_EXPECT(player < state.players.size());
  const Player& self = state.players[player];
  scene.X_FR = self.X_FR;
  scene.v_FR = self.v_FR;
  scene.omega = self.omega;
  scene.robots.clear();
  for (std::size_t i = 0; i < state.players.size(); ++i) {
    const Player& other = state.players[i];
    if (i != player && other.on_field) {
      scene.robots.push_back({other.X_FR.origin(),
                              other.v_FR,
                              bodies.robot_radius,
                              bodies.robot_height,
                              other.is_own() ? kOwnShirt : kTheirShirt});
    }
  }
  scene.balls.clear();
  for (const Ball& ball : state.balls) {
    scene.balls.push_back({ball.p_FB, ball.v_FB, bodies.ball_radius, bodies.ball});
    scene.balls.back().look.turn_F = ball.turn_F;
  }
  scene.people = bodies.people;
}

}  // namespace teamsight::sim
