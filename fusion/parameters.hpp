// fusion/parameters.hpp: every number that fusion was given rather than told by the robots.
#pragma once

#include <cstdint>
#include <limits>

#include "fusion/ball_motion.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// How one kind of thing moves, is seen, begins and ends.
struct TrackParameters {
  /// Power spectral density of the white acceleration, m^2/s^3.
  double acceleration_psd{1.0};
  /// Rate at which an undisturbed velocity fades, 1/s; stands for rolling friction.
  double velocity_decay{0.0};
  /// Of each component of a newborn track's velocity, m/s.
  double sigma_speed_at_birth{2.0};
  /// Share of the right observations that pass the gate, in (0, 1).
  double gate_probability{0.997};
  /// That a robot right beside it reports it; falls linearly to 0 at `detection_range`.
  double detection_probability{0.5};
  double detection_range{6.0};  ///< m
  /// Observations with a smaller confidence are left out, in [0, 1].
  double min_confidence{0.2};
  /// A wider observation (larger semi-axis, m) updates a track but never begins one.
  double max_sigma_at_birth{0.7};
  /// A track is published after so many observations (M of N: N is `birth_window`).
  int birth_hits{3};
  Duration birth_window{std::chrono::seconds(1)};
  /// A track that nobody has seen for so long is dropped.
  Duration death_age{std::chrono::seconds(3)};
  /// A track whose log-odds of existence fall below this is dropped.
  double death_log_odds{-2.0};
  /// ... unless they once were above this: then it is hidden somewhere, however long nobody sees
  /// it.
  double lasting_log_odds{std::numeric_limits<double>::infinity()};
  double most_vote{3.0};  ///< log-odds that one robot adds, or takes away: 95 %
  Duration vote_memory{std::chrono::seconds(2)};
  /// What one robot alone goes on to see for longer is where that robot says, see `take_back`.
  Duration led_astray{std::chrono::milliseconds(200)};
  /// False ones that one frame shows, per m^2 of floor: one in a hundred frames, on 110 m^2.
  double false_density{1e-4};
  /// Mean of how long one robot goes on seeing a false one.
  Duration false_life{std::chrono::milliseconds(1500)};
  /// A track less probable than this is not published.
  double least_existence{0.5};
  /// A ball whose place is known worse (larger semi-axis of one sigma, m) is kept, and may be found
  /// again under its id, but not published: nobody can act on it. Obstacles go by
  /// Parameters::obstacle_reach.
  double max_sigma_published{1.0};
  /// Two tracks nearer than this (m) are one thing: the younger is dropped.
  double merge_distance{0.15};
};

[[nodiscard]] constexpr TrackParameters default_ball_parameters() {
  TrackParameters ball;
  ball.sigma_speed_at_birth = 4.0;
  ball.detection_probability = 0.6;
  ball.death_age = std::chrono::seconds(6);
  ball.lasting_log_odds = 4.0;     // more than one robot's word; the game goes on with its ball
  ball.max_sigma_published = 3.0;  // even a rough memory of the ball says where to look
  return ball;
}

[[nodiscard]] constexpr TrackParameters default_obstacle_parameters() {
  TrackParameters obstacle;
  obstacle.acceleration_psd = 0.8;
  obstacle.detection_range = 5.0;
  obstacle.least_existence = 0.55;  // a false one costs a behaviour more than one that comes late
  obstacle.death_age = std::chrono::seconds(2);
  obstacle.merge_distance = 0.3;
  return obstacle;
}

/// How teammates move and when they are believed.
struct TeammateParameters {
  double acceleration_psd{0.3};          ///< m^2/s^3
  double angular_acceleration_psd{4.0};  ///< rad^2/s^3
  double sigma_speed_at_start{2.0};      ///< m/s, per component
  double sigma_omega_at_start{3.0};      ///< rad/s
  /// A posture further from the prediction (chi-square, 3 degrees) is a jump: velocity starts anew.
  double jump_probability{0.9999};
  /// An ambiguous posture counts as resolved from these log-odds on (own evidence only): 95 %.
  double resolved_log_odds{2.94};
  /// How far a robot's visible body may lie aside from its posture; m.
  double sigma_body{0.05};
  /// Nothing but the robot itself can be seen so near to its posture; m.
  double body_reach{0.55};
  /// Other bodies per m^2 where robots crowd, that may be taken for a teammate that they hide.
  double other_density{0.3};
  /// How long a posture's error lasts while the robot's own covariance stays; see TeamErrors.
  Duration posture_memory{std::chrono::seconds(1)};
  Duration bias_memory{std::chrono::seconds(8)};  ///< ... while it is found to be biased
  /// Over how long it is measured how much of a posture's error is new; see PostureJitter.
  Duration jitter_memory{std::chrono::seconds(2)};
  double sigma_scale{0.02};  ///< share by which a robot sees things too far away
  Duration scale_memory{std::chrono::seconds(300)};    ///< longer than it takes to learn it
  Duration forget_age{std::chrono::seconds(5)};        ///< silent for longer: not listed
  Duration duplicate_memory{std::chrono::seconds(2)};  ///< see Quarantine::kDuplicateId
};

/// When a robot is believed, and when no more.
struct TrustParameters {
  Duration period{std::chrono::milliseconds(200)};  ///< between two looks at one robot's evidence
  Duration fresh{std::chrono::milliseconds(300)};   ///< what is older is no evidence
  Duration memory{std::chrono::seconds(8)};         ///< of evidence
  double slack{0.15};          ///< m: standard deviation added to what is compared
  double most_for{3.0};        ///< log-odds that one thing adds in one look
  double most_against{1.5};    ///< ... takes away
  double most_evidence{20.0};  ///< log-odds that a pair of robots gathers
  /// The most log-odds that a pair's agreement, or its contradiction, counts where it is asked who
  /// stands elsewhere than it says. From `agreement` on a robot that did is believed again.
  double agreement{3.0};
  double contradiction{4.0};
  double in_place{3.0};       ///< log-odds that a robot stands where it says: 95 %
  double place_margin{2.5};   ///< log-odds by which the best explanation leads over the next
  double mirror_gain{10.0};   ///< log-odds that a half must gain to be called wrong
  double mirror_margin{2.5};  ///< ... and lead over the next best explanation
  double most_own{4.0};       ///< of a robot's own log-odds of its half, however convinced it is
  double sigma_bias{0.5};     ///< m per axis: how far aside a biased posture may stand
  double least_bias{0.25};    ///< m, half a robot: what stands aside by less is not called biased
  double bias_margin{6.0};    ///< log-odds by which the best explanation leads over the next
  double biased{16.0};        ///< squared normalised offset of a posture that halves its trust
  Duration hold{std::chrono::milliseconds(700)};  ///< a quarantine lasts at least
  double jump{0.5};                               ///< m: a posture that jumps so far is held
};

/// What is to be expected of false balls, see fusion/ball_choice.hpp.
struct ChoiceParameters {
  /// So many in a square metre beside a ball that is hidden: five robots, each with one a minute,
  /// two seconds, 170 m^2 that they see.
  double false_density{1e-3};
  /// How often a ball that is hidden does what none of its possibilities foresees, 1/s.
  double lost_rate{0.05};
  double density_anywhere{4e-3};  ///< per m^2, of a ball that may be anywhere on the field
  double false_speed{2.0};  ///< m/s per component, of false balls: they move with who sees them
  Duration false_life{std::chrono::milliseconds(1500)};  ///< mean of how long one is seen
  double most_for_lasting{3.0};                          ///< log-odds; as much as one robot's vote
};

/// What is to be expected of obstacles that are seen for the first time, see fusion/unseen.hpp.
struct NewcomerParameters {
  /// Real ones where nobody looks, per m^2: a team of five on 300 m^2.
  double density{1.7e-2};
  double speed{1.5};  ///< m/s; how fast they come to where they are not expected
  /// False ones that begin and last, per m^2 and frame: one a minute of 25 frames a second, on 110
  /// m^2.
  double lasting_density{6e-6};
  double least_detected{0.05};  ///< that a robot reports one that it can hardly see, per frame
  double most_doubt{6.0};       ///< log-odds; as much as two robots' votes
  /// One that was lost is known again within this time; see fusion/obstacle_identity.hpp.
  Duration lost_memory{std::chrono::seconds(5)};
};

/// How fast it is learned how completely a robot reports what it should see (fusion/eyesight.hpp).
struct EyesightParameters {
  /// What TrackParameters say of detection weighs as much as so many looks at one distance.
  double given_weight{50.0};
  Duration memory{std::chrono::seconds(30)};
  double most{0.95};  ///< no robot's silence in one look is believed beyond this
  /// What hides a thing in one frame hides it in the next: frames within this time are one look.
  Duration look{std::chrono::milliseconds(100)};
  /// Things are learned from that lie so well known (one sigma, m) and ...
  double sigma{0.3};
  Duration fresh{std::chrono::milliseconds(200)};  ///< ... were seen by another robot just now
};

/// How far a hint reaches, and for how long.
struct HintParameters {
  /// It weighs as much as so many robots that watch the ball now, and from then on ever less.
  double robots{10.0};
  Duration lasting{std::chrono::seconds(8)};
  /// A ball passes as the one that was meant within this gate, in (0, 1).
  double gate_probability{0.997};
  /// Between what the operator saw and the hint: a ball that rolls is that far from it.
  Duration reaction{std::chrono::milliseconds(500)};
};

/// Parameters of the whole fusion; SI and radians.
struct Parameters {
  TrackParameters ball{default_ball_parameters()};
  BallMotion ball_motion;
  ChoiceParameters choice;
  NewcomerParameters newcomer;
  EyesightParameters eyesight;
  HintParameters hint;
  TrustParameters trust;
  TrackParameters obstacle{default_obstacle_parameters()};
  TeammateParameters teammate;
  double ball_radius{0.11};   ///< m
  double robot_radius{0.25};  ///< m, where a sighting has no width
  /// Observations that arrive later than this after their exposure are refused.
  Duration lag{std::chrono::milliseconds(500)};
  /// Observations whose exposure lies further ahead of the present are refused.
  Duration max_future{std::chrono::milliseconds(50)};
  /// For how long an observation makes its robot a supporter.
  Duration support_window{std::chrono::milliseconds(500)};
  /// An obstacle is published while it is likelier than not that it is there, and so near to its
  /// place (m).
  double obstacle_reach{1.0};
  double carpet_margin{0.5};  ///< m beyond the carpet within which things are still believed
};

}  // namespace teamsight::fusion
