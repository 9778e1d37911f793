// bench/stage_meter.hpp: how long a frame takes from its exposure to the world model, stage by
// stage.
#pragma once

#include <array>
#include <deque>
#include <string_view>
#include <vector>

#include "bus/messages.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::bench {

/// The stages, in the order in which a frame passes them.
enum class Stage : std::uint8_t {
  kAgent,      ///< middle of the exposure to just before the write of Sightings
  kTurn,       ///< from there to the stamp of the first world model that has this frame in it
  kWorld,      ///< from there to its arrival in this process
  kWhole,      ///< exposure to the arrival of the world model
  kSightings,  ///< beside them: write of Sightings to their arrival in this process
};

inline constexpr std::size_t kStages = 5;

[[nodiscard]] std::string_view to_string(Stage stage);

/// Matches world models with the frames in them and gathers the stages. All processes must run on
/// this computer: their stamps are compared with each other.
class StageMeter {
 public:
  void add(const bus::Sightings& sightings, HostTime received);

  /// Each teammate's age names the newest frame in this world, to the millisecond.
  void add(const WorldModel& world, HostTime received);

  [[nodiscard]] const std::vector<Duration>& of(Stage stage) const;

 private:
  struct Frame {
    ObservationId id;
    Duration exposure{0};  // all on this computer's clock
    Duration published{0};
    bool counted{false};
  };

  void count(Frame& frame, const WorldModel& world, HostTime received);
  void put(Stage stage, Duration duration);

  std::array<std::deque<Frame>, kMaxRobotId + 1> frames_;
  std::array<std::vector<Duration>, kStages> stages_;
};

}  // namespace teamsight::bench
