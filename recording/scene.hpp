// recording/scene.hpp: field and world as scenes that Foxglove, Lichtblick and PlotJuggler draw.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "geometry/field_model.hpp"
#include "geometry/time.hpp"
#include "geometry/world_model.hpp"
#include "recording/message_sink.hpp"

namespace teamsight::recording {

/// Field and world as messages of Foxglove's own types ([Foxglove]; idl/foxglove.proto),
/// serialised. All in F, metres; `log_ns` is the time that the message is filed under. Ellipses
/// hold 95 %.
///
/// A thing that no later world names is gone after half a second of message time.
[[nodiscard]] std::string field_scene(const FieldModel& field, std::int64_t log_ns);
[[nodiscard]] std::string ball_scene(const WorldModel& world, std::int64_t log_ns);
[[nodiscard]] std::string robot_scene(const WorldModel& world, std::int64_t log_ns);
[[nodiscard]] std::string obstacle_scene(const WorldModel& world, std::int64_t log_ns);

/// Where each robot's frame, "robot_3", stands in "field".
[[nodiscard]] std::string robot_frames(const WorldModel& world, std::int64_t log_ns);

/// How loud an entry of the viewers' log is; the numbers are Foxglove's.
enum class LogLevel : std::uint8_t { kInfo = 2, kWarning = 3, kError = 4 };

/// One entry for the viewers' log.
///
/// @param name  who says it
[[nodiscard]] std::string log_entry(LogLevel level,
                                    const std::string& name,
                                    const std::string& text,
                                    std::int64_t log_ns);

/// The channel of `log_entry`.
[[nodiscard]] Channel log_channel();

/// The channels of all scenes in one sink.
class SceneChannels {
 public:
  /// @param sink  outlives this
  explicit SceneChannels(MessageSink& sink);

  /// Once a second is often enough.
  void write(const FieldModel& field, HostTime now);

  /// Makes only what is wanted.
  void write(const WorldModel& world, HostTime received);

 private:
  using Make = std::string (*)(const WorldModel&, std::int64_t);

  struct WorldChannel {
    ChannelId id;
    Make make;
  };

  [[nodiscard]] std::int64_t log_ns(HostTime time) const;

  MessageSink* sink_;
  ChannelId field_;
  std::array<WorldChannel, 4> of_world_;
};

}  // namespace teamsight::recording
