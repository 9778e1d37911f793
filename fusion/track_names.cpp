// fusion/track_names.cpp: see fusion/track_names.hpp.
#include "fusion/track_names.hpp"

#include <algorithm>

#include "geometry/uncertainty.hpp"

namespace teamsight::fusion {
namespace {

constexpr double kAlonePrice = 1e4;      // dearer than any pair within the gate
constexpr double kSameNameBonus = 20.0;  // two tracks side by side do not swap their names
constexpr double kTentativePenalty = 15.0;
// Two instances that lost different packets see the same thing this much apart; m^2.
constexpr double kSlackVar = 0.01;

}  // namespace

std::uint32_t TrackNames::name_of(std::uint32_t key) const {
  for (const Alias& alias : aliases_) {
    if (alias.key == key) return alias.name;
  }
  return key;
}

void TrackNames::set(std::uint32_t key, std::uint32_t name) {
  for (Alias& alias : aliases_) {
    if (alias.key == key) {
      alias.name = name;
      return;
    }
  }
  if (key != name) aliases_.push_back({key, name});
}

double TrackNames::pair_cost(const NamedPlace& place,
                             const NamedTrack& track,
                             HostTime at,
                             double gate_probability) const {
  const Eigen::Matrix2d cov = place.cov + track.cov + kSlackVar * Eigen::Matrix2d::Identity();
  // A track may already be later than the places are.
  const double later = std::max(0.0, to_seconds(track.time - at));
  const double distance = squared_mahalanobis(place.p_F + later * place.v_F - track.p_F, cov);
  if (!(distance <= chi_square_gate(2, gate_probability))) return kForbidden;
  return distance - (name_of(track.key) == place.track ? kSameNameBonus : 0.0) +
         (track.is_confirmed ? 0.0 : kTentativePenalty);
}

void TrackNames::adopt(const std::vector<NamedPlace>& places,
                       const NamedTracks& tracks,
                       HostTime at,
                       double gate_probability) {
  const auto rows = std::min(places.size(), static_cast<std::size_t>(kMaxAssignmentRows));
  CostMatrix cost(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(tracks.size()));
  for (std::size_t column = 0; column < tracks.size(); ++column) {
    for (std::size_t row = 0; row < rows; ++row) {
      cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          pair_cost(places[row], tracks[column], at, gate_probability);
    }
  }
  const Assignment assignment = assign(cost, kAlonePrice);
  std::array<bool, kMaxAssignmentColumns> is_named{};
  for (std::size_t row = 0; row < rows; ++row) {
    if (assignment[row] == kUnassigned) continue;
    const auto column = static_cast<std::size_t>(assignment[row]);
    set(tracks[column].key, places[row].track);
    is_named[column] = true;
  }
  rename_strays(places, tracks, is_named);
}

/// Whoever bears the name of one of the places without lying there gets a new one.
void TrackNames::rename_strays(const std::vector<NamedPlace>& places,
                               const NamedTracks& tracks,
                               const std::array<bool, kMaxAssignmentColumns>& is_named) {
  for (std::size_t column = 0; column < tracks.size(); ++column) {
    const std::uint32_t key = tracks[column].key;
    const std::uint32_t name = name_of(key);
    const bool is_taken = std::any_of(
        places.begin(), places.end(), [name](const auto& place) { return place.track == name; });
    if (!is_named[column] && is_taken) set(key, track_key({kNobody, key, name}, 0));
  }
}

}  // namespace teamsight::fusion
