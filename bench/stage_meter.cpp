// bench/stage_meter.cpp: see stage_meter.hpp.
#include "bench/stage_meter.hpp"

#include <algorithm>
#include <chrono>

namespace teamsight::bench {
namespace {

// Ages travel in whole milliseconds; frames are at least 10 ms apart.
constexpr Duration kSameFrame = std::chrono::microseconds(1500);

constexpr std::size_t kRemembered = 64;  // frames of one robot: more than a second of them

}  // namespace

std::string_view to_string(Stage stage) {
  constexpr std::array<std::string_view, kStages> kNames{"exposure_to_sightings_written",
                                                         "sightings_written_to_world_stamp",
                                                         "world_stamp_to_world_received",
                                                         "exposure_to_world_received",
                                                         "sightings_written_to_sightings_received"};
  return kNames.at(static_cast<std::size_t>(stage));
}

void StageMeter::put(Stage stage, Duration duration) {
  stages_.at(static_cast<std::size_t>(stage)).push_back(duration);
}

const std::vector<Duration>& StageMeter::of(Stage stage) const {
  return stages_.at(static_cast<std::size_t>(stage));
}

void StageMeter::add(const bus::Sightings& sightings, HostTime received) {
  if (sightings.id.robot > kMaxRobotId) {
    return;
  }
  const Duration published = sightings.published.time_since_epoch();
  put(Stage::kSightings, received.time_since_epoch() - published);
  std::deque<Frame>& frames = frames_.at(sightings.id.robot);
  frames.push_back({sightings.id, sightings.exposure.time_since_epoch(), published, false});
  if (frames.size() > kRemembered) {
    frames.pop_front();
  }
}

void StageMeter::count(Frame& frame, const WorldModel& world, HostTime received) {
  const Duration stamp = world.stamp.time_since_epoch();
  const Duration arrival = received.time_since_epoch();
  frame.counted = true;
  put(Stage::kAgent, frame.published - frame.exposure);
  put(Stage::kTurn, stamp - frame.published);
  put(Stage::kWorld, arrival - stamp);
  put(Stage::kWhole, arrival - frame.exposure);
}

void StageMeter::add(const WorldModel& world, HostTime received) {
  for (const WorldTeammate& mate : world.teammates) {
    if (mate.robot > kMaxRobotId) {
      continue;
    }
    const Duration exposure = world.stamp.time_since_epoch() - mate.age;
    std::deque<Frame>& frames = frames_.at(mate.robot);
    const auto frame = std::find_if(frames.begin(), frames.end(), [&](const Frame& candidate) {
      return std::chrono::abs(candidate.exposure - exposure) < kSameFrame;
    });
    if (frame != frames.end() && !frame->counted) {
      count(*frame, world, received);
    }
  }
}

}  // namespace teamsight::bench
