// bench/locate_score/methods.hpp: every way to locate a robot, asked about the same line points.
#pragma once

#include <map>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "bench/locate_rivals/distance_table.hpp"
#include "bench/locate_score/tally.hpp"
#include "geometry/field_model.hpp"
#include "vision/hough2001/hough2001.hpp"
#include "vision/localisation/localisation.hpp"

namespace teamsight::locate_score {

/// One look at the field with its truth.
struct Look {
  Pose<Field, Robot> truth;
  Pose<Field, Robot> prior;  ///< where a tracker thinks it is
  std::span<const vision::LinePoint> points;
};

/// Sigmas of `Look::prior`.
inline constexpr double kPriorSigma = 0.05;      // m
inline constexpr double kPriorSigmaTurn = 0.03;  // rad

/// Which methods a case asks; the rivals take most of the time.
struct MethodChoice {
  bool tracking{true};
  bool global{true};
  bool rivals{true};
  bool hough{true};  ///< of the rivals, "hough2001" on the points
};

/// The founding paper's method on line points instead of the image's own transitions.
class PointHough {
 public:
  explicit PointHough(const FieldModel& field);

  /// Modulo the field's symmetry.
  [[nodiscard]] Answer locate(std::span<const vision::LinePoint> points);

 private:
  FieldModel field_;
  vision::FieldLines lines_;
  vision::LineHough hough_;
  std::vector<Point<Robot>> transitions_;
};

/// The product and its rivals on one field. Methods: "track" (vision::Localiser from the prior),
/// "global" (vision::BackgroundSearch, modulo symmetry), "rprop10" and "mcl500" (from the prior),
/// "hough2001" (the founding paper's steps on the same points, modulo symmetry).
class Methods {
 public:
  Methods(const FieldModel& field,
          const vision::LocalisationParameters& parameters,
          const MethodChoice& choice,
          std::uint32_t seed);

  /// Asks all methods, and adds to their tallies.
  ///
  /// @param with_bound  whether the points are good enough for a bound to mean something
  void ask(const Look& look, bool with_bound);

  [[nodiscard]] const std::map<std::string, Tally>& tallies() const { return tallies_; }

 private:
  [[nodiscard]] Answer track(const Look& look);
  [[nodiscard]] Answer global(const Look& look);
  [[nodiscard]] Answer rprop10(const Look& look) const;
  [[nodiscard]] Answer mcl500(const Look& look);

  FieldModel field_;
  vision::LocalisationParameters parameters_;
  MethodChoice choice_;
  std::uint32_t seed_;
  vision::Localiser localiser_;
  vision::LocalisationState begun_;
  vision::BackgroundSearch search_;
  std::optional<Point<Field>> symmetry_;
  locate_rivals::DistanceTable table_;
  PointHough hough_;
  std::map<std::string, Tally> tallies_;
};

/// Trace of the position block, and heading variance, of the Cramer-Rao bound of these points at
/// the truth. Their noise is measured at the truth, because a bound from a claim would be a claim.
///
/// @param sigma_tilt  of the head, unknown to the method; 0: known; rad
/// @return nothing if the points leave a direction open
[[nodiscard]] std::optional<Eigen::Vector2d> bound_of(const vision::LineMap& map,
                                                      const Look& look,
                                                      const vision::HeadTilt& tilt);

}  // namespace teamsight::locate_score
