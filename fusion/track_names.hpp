// fusion/track_names.hpp: by which ids tracks are known outside, so that ids outlive their maker.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fusion/assignment.hpp"
#include "fusion/track_book.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::fusion {

/// Where a track with a known name is, to compare others by; in F.
struct NamedPlace {
  std::uint32_t track{0};
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};      ///< m
  Eigen::Vector2d v_F{Eigen::Vector2d::Zero()};      ///< m/s
  Eigen::Matrix2d cov{Eigen::Matrix2d::Identity()};  ///< of p_F; m^2
};

/// A track as far as its name is concerned.
struct NamedTrack {
  std::uint32_t key{0};
  bool is_confirmed{false};
  HostTime time{kNever};                             ///< what it is predicted to; not before `at`
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};      ///< m
  Eigen::Matrix2d cov{Eigen::Matrix2d::Identity()};  ///< of p_F; m^2
};

using NamedTracks = InlineList<NamedTrack, kMaxAssignmentColumns>;

/// Public ids of tracks, where they differ from the tracks' keys.
class TrackNames {
 public:
  /// The public id of the track with this key.
  [[nodiscard]] std::uint32_t name_of(std::uint32_t key) const;

  /// Gives tracks the ids of the places they lie at (global nearest neighbour within the gate;
  /// a track that has the id already is preferred). An id is never given twice.
  ///
  /// @param at  when the places were
  void adopt(const std::vector<NamedPlace>& places,
             const NamedTracks& tracks,
             HostTime at,
             double gate_probability);

  /// Forgets the names of tracks for which `is_alive(key)` does not hold.
  template <class Predicate>
  void keep_if(Predicate is_alive) {
    std::erase_if(aliases_, [&](const Alias& alias) { return !is_alive(alias.key); });
  }

 private:
  struct Alias {
    std::uint32_t key{0};
    std::uint32_t name{0};
  };

  [[nodiscard]] double pair_cost(const NamedPlace& place,
                                 const NamedTrack& track,
                                 HostTime at,
                                 double gate_probability) const;
  void set(std::uint32_t key, std::uint32_t name);
  void rename_strays(const std::vector<NamedPlace>& places,
                     const NamedTracks& tracks,
                     const std::array<bool, kMaxAssignmentColumns>& is_named);

  std::vector<Alias> aliases_;
};

}  // namespace teamsight::fusion
