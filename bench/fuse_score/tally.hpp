// bench/fuse_score/tally.hpp: what is counted while an estimator is compared with the truth.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "bench/fuse_score/gospa.hpp"

namespace teamsight::score {

/// Errors of one kind, and what they should be.
class ErrorTally {
 public:
  /// @param squared  error, squared
  void add(double squared);

  [[nodiscard]] int count() const { return static_cast<int>(squares_.size()); }

  [[nodiscard]] double rms() const;

  /// Of the errors' sizes; share in [0, 1].
  [[nodiscard]] double quantile(double share) const;

  /// Of the errors that are smaller than `size`, in [0, 1].
  [[nodiscard]] double share_within(double size) const;

  void merge(const ErrorTally& other);

 private:
  std::vector<double> squares_;
};

/// A mean that grows.
struct MeanTally {
  double sum{0.0};
  int count{0};

  void add(double value) {
    sum += value;
    ++count;
  }

  [[nodiscard]] double mean() const { return count == 0 ? 0.0 : sum / count; }

  void merge(const MeanTally& other) {
    sum += other.sum;
    count += other.count;
  }
};

struct BallTally {
  int needed{0};  ///< ticks at which the ball could be known
  ErrorTally position;
  ErrorTally velocity;
  ErrorTally high;           ///< in flight, seen by two or more within 0.1 s; in three dimensions
  MeanTally bound_position;  ///< variance
  MeanTally bound_velocity;
  MeanTally bound_high;
  MeanTally nees_position;  ///< per degree of freedom
  MeanTally nees_velocity;
  int second_balls{0};  ///< ticks with a second ball in the world that does not exist
};

struct ObstacleTally {
  MeanTally gospa;         ///< squared, per tick
  MeanTally localisation;  ///< squared distance per matched pair
  MeanTally missed;        ///< per tick
  MeanTally false_ones;    ///< per tick
  MeanTally nees;          ///< per degree of freedom
  int switches{0};         ///< of the id under which a true one is known
  int false_tracks{0};     ///< ids that were false for half a second
};

struct MateTally {
  ErrorTally position;  ///< as published
  ErrorTally said;      ///< as the robot itself said last
  MeanTally nees;       ///< per degree of freedom
};

struct TrustTally {
  std::vector<double> found_after;  ///< s, of each fault found
  /// ... of which there was something to compare, see shared_evidence_until; s
  std::vector<double> found_after_evidence;
  int not_found{0};  ///< of those that went on
  /// Of faults that ended by themselves: for how long the robot was sure of a posture that is wrong
  /// by more than 0.3 m; s.
  std::vector<double> over_after;
  int wrong_reason{0};
  int false_alarms{0};  ///< times that a sound robot went into quarantine
};

struct Tally {
  BallTally ball;
  ObstacleTally obstacles;
  MateTally mates;
  TrustTally trust;
  MeanTally insert_us;  ///< computing time per observation
  double minutes{0.0};

  void merge(const Tally& other);
};

}  // namespace teamsight::score
