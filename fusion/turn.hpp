// fusion/turn.hpp: one frame's work on all tracks of one kind: predict, assign, update, count,
// begin, drop.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "fusion/assignment.hpp"
#include "fusion/track_book.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::fusion {

/// How far a candidate lies from a track.
struct Gap {
  double squared_distance{0.0};  ///< Mahalanobis; chi-square if right
  int degrees{2};
  double log_determinant{0.0};  ///< of the gap's covariance
  double probability{1.0};      ///< that what was seen was the track's thing, once it is taken in
};

/// Takes everything of one kind that one frame shows into the tracks of that kind.
///
/// Global nearest neighbour within the gate; misses count where the observer should have seen
/// something and nothing nearer hides it; two tracks in one place are one.
///
/// `Kind` knows what is special: `Track` (with a TrackBook `book`), predict, gap, hit, missed
/// (with what probability the frame would have shown it), begin, place, may_be_one (of two in one
/// place).
template <class Kind, class List>
class Turn {
 public:
  using Track = typename Kind::Track;

  Turn(const Kind& kind,
       List& tracks,
       const CandidateList& candidates,
       const Scene& scene,
       const TrackParameters& parameters)
      : kind_(kind),
        tracks_(tracks),
        candidates_(candidates),
        glance_(scene.glance),
        parameters_(parameters) {}

  /// @return how many candidates fitted no track and were not used to begin one
  std::uint32_t take() {
    for (Track& track : tracks_) {
      const double dt = to_seconds(glance_.exposure - track.book.time);
      if (dt <= 0.0) continue;
      kind_.predict(track, dt);
      turn_page(track.book, glance_.exposure, parameters_);
    }
    associate();
    update();
    count_misses();
    const std::uint32_t unused = begin_tracks();
    drop_and_merge();
    return unused;
  }

 private:
  // Dearer than any pair within the gate, so that as many pairs as possible are made.
  static constexpr double kAlonePrice = 1e4;
  // An established track is preferred to one that is just beginning.
  static constexpr double kTentativePenalty = 6.0;

  void associate() {
    CostMatrix cost(static_cast<Eigen::Index>(candidates_.size()),
                    static_cast<Eigen::Index>(tracks_.size()));
    for (std::size_t row = 0; row < candidates_.size(); ++row) {
      for (std::size_t column = 0; column < tracks_.size(); ++column) {
        cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
            pair_cost(candidates_[row], tracks_[column]);
      }
    }
    column_of_ = assign(cost, kAlonePrice);
  }

  [[nodiscard]] double pair_cost(const Candidate& candidate, const Track& track) const {
    // Too far apart for whatever the covariances are: spare the arithmetic.
    const double reach = (candidate.measurement.p_F - kind_.place(track)).norm();
    if (reach > kind_.farthest(track)) return kForbidden;
    const Gap gap = kind_.gap(track, candidate);
    if (!(gap.squared_distance <= chi_square_gate(gap.degrees, parameters_.gate_probability))) {
      return kForbidden;
    }
    return gap.squared_distance + gap.log_determinant +
           (track.book.is_confirmed ? 0.0 : kTentativePenalty);
  }

  void update() {
    for (std::size_t row = 0; row < candidates_.size(); ++row) {
      if (column_of_[row] == kUnassigned) continue;
      const auto column = static_cast<std::size_t>(column_of_[row]);
      is_hit_[column] = true;
      const Candidate& candidate = candidates_[row];
      Track& track = tracks_[column];
      const Gap gap = kind_.hit(track, candidate);
      if (gap.probability < 0.5) {
        mark_rejected(track.book);
        continue;
      }
      write_hit(track.book,
                {glance_.robot, glance_.exposure, candidate.confidence},
                gap.squared_distance / gap.degrees,
                parameters_);
    }
  }

  /// The robot saw only others of the kind.
  void mark_rejected(TrackBook& book) const {
    book.rejected[static_cast<std::size_t>(glance_.robot) - 1U] = glance_.exposure;
  }

  void count_misses() {
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      if (is_hit_[i]) continue;
      Track& track = tracks_[i];
      if (!candidates_.empty()) mark_rejected(track.book);
      write_miss(track.book, glance_.robot, kind_.missed(track), parameters_);
    }
  }

  std::uint32_t begin_tracks() {
    std::uint32_t unused = 0;
    for (std::size_t row = 0; row < candidates_.size(); ++row) {
      if (column_of_[row] != kUnassigned) continue;
      const bool may_begin = !tracks_.is_full() && candidates_[row].may_begin;
      const auto track = may_begin ? kind_.begin(candidates_[row]) : std::nullopt;
      if (track) {
        tracks_.push_back(*track);
      } else {
        ++unused;
      }
    }
    return unused;
  }

  void drop_and_merge() {
    for (std::size_t i = tracks_.size(); i-- > 0;) {
      if (is_over(tracks_[i].book, glance_.exposure, parameters_) || is_doubled(i)) {
        tracks_.erase(i);
      }
    }
  }

  /// Whether a track that it yields to covers this one.
  [[nodiscard]] bool is_doubled(std::size_t index) const {
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      if (i == index || !yields(index, i)) continue;
      const Eigen::Vector2d gap_F = kind_.place(tracks_[index]) - kind_.place(tracks_[i]);
      if (gap_F.norm() < parameters_.merge_distance && kind_.may_be_one(tracks_[index], tracks_[i]))
        return true;
    }
    return false;
  }

  /// Of two in one place the younger yields (they stand in order of birth), unless the older one is
  /// rather not there and the younger one is.
  [[nodiscard]] bool yields(std::size_t one, std::size_t other) const {
    const bool is_here = stands(tracks_[one].book);
    return is_here == stands(tracks_[other].book) ? other < one : !is_here;
  }

  [[nodiscard]] bool stands(const TrackBook& book) const {
    return log_odds_of(book) > 0.0 || book.proven >= parameters_.lasting_log_odds;
  }

  const Kind& kind_;
  List& tracks_;
  const CandidateList& candidates_;
  const Glance& glance_;
  const TrackParameters& parameters_;
  std::array<bool, List::kCapacity> is_hit_{};
  Assignment column_of_{};
};

}  // namespace teamsight::fusion
