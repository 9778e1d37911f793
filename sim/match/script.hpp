// sim/match/script.hpp: what is to happen in a match whatever the players want.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "geometry/frames.hpp"
#include "geometry/pose.hpp"

namespace teamsight::sim {

/// Players are named by their number; a number that does not play is a broken precondition.
struct PlacePlayer {
  std::uint8_t number{0};
  Pose<Field, Robot> X_FR;  ///< stands there from now on: a kidnapping, or a return to the field
};

struct TakePlayer {
  std::uint8_t number{0};  ///< leaves the field, with its camera and its wheels
};

struct SendPlayer {
  std::uint8_t number{0};
  Point<Field> target;  ///< drives there and stays, until FreePlayer
};

struct FreePlayer {
  std::uint8_t number{0};
};

struct SlipPlayer {
  std::uint8_t number{0};
  double seconds{0.3};  ///< its wheels have little grip for so long
};

/// Balls are named by their index; the next free one adds a ball.
struct PutBall {
  std::size_t ball{0};
  Point3<Field> p_FB;
  Velocity3<Field> v_FB;
};

struct KickBall {
  std::size_t ball{0};
  Velocity3<Field> v_FB;  ///< from where it is, out of anybody's hold
};

/// Takes the last ball away, if there is more than one.
struct TakeBall {};

using Happening = std::variant<PlacePlayer,
                               TakePlayer,
                               SendPlayer,
                               FreePlayer,
                               SlipPlayer,
                               PutBall,
                               KickBall,
                               TakeBall>;

/// Something that happens at its time.
struct ScriptLine {
  double at{0.0};  ///< since the start; s
  Happening happening;
};

}  // namespace teamsight::sim
