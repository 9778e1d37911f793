// tools/shirt_score.hpp: whether team mates told by their shirts are so as often as is said.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/field_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/shirt_votes.hpp"

namespace teamsight::tools {

/// A robot that was found, and whose it is.
struct ShirtSample {
  vision::ShirtVotes votes;
  double range{0.0};  ///< to its foot, m
  bool is_own{false};
};

/// Where shirts are looked at: lights and paints are drawn anew around these.
struct ShirtField {
  vision::CameraParameters camera;
  FieldModel field;
  std::size_t lights{10};    ///< each in a hall of its own
  std::size_t frames{25};    ///< of each light
  double light_sigma{0.2};   ///< of the logarithm of each colour's gain; it is not followed
  double paint_sigma{25.0};  ///< of each shirt's red, green and blue; levels of 255
  std::uint32_t seed{1};
};

/// What both teams wear: the classes that the team file names.
struct ShirtPair {
  const char* name{""};
  vision::TeamShirts shirts;
  vision::ColourClass others{vision::ColourClass::kNone};  ///< what the others truly wear
};

/// Pairs that are told easily, and hardly; in one only the own colour is known.
[[nodiscard]] std::span<const ShirtPair> shirt_pairs();

/// Renders crowded scenes, a robot's team by lot, and asks perception for the robots in them.
/// What it takes for a robot where none stands within 0.5 m is left out.
[[nodiscard]] std::vector<ShirtSample> look_at_shirts(const ShirtField& where,
                                                      const ShirtPair& pair);

/// Some samples' likelihoods of being a team mate against the truth.
struct Calibration {
  std::size_t count{0};  ///< robots
  std::size_t told{0};   ///< of those, with any vote; all below is of them
  double right{0.0};     ///< share whose likelier team is theirs
  double claimed{0.0};   ///< mean likelihood of the likelier team: as large if calibrated
  double log_loss{0.0};  ///< mean; 0.693 says nothing
  double brier{0.0};     ///< mean square of likelihood less truth; 0.25 says nothing
};

[[nodiscard]] Calibration calibration_of(std::span<const ShirtSample> samples,
                                         const vision::VoteModel& model);

/// Of robots whose likelihood lies in one range: what was said, and what was true.
struct ReliabilityBin {
  std::size_t count{0};
  double claimed{0.0};  ///< mean likelihood
  double own{0.0};      ///< share of team mates
};

/// Ten bins of equal width, without the empty ones; robots with votes only.
[[nodiscard]] std::vector<ReliabilityBin> reliability_of(std::span<const ShirtSample> samples,
                                                         const vision::VoteModel& model);

/// The model with the least log loss, of a grid: wrong 0.002 to 0.13, correlation 0.05 to 0.95.
[[nodiscard]] vision::VoteModel fitted_votes(std::span<const ShirtSample> samples);

}  // namespace teamsight::tools
