// tools/camera_games.hpp: made-up games seen through cameras, rendered or kept from before.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "bench/camera_play/camera_eyes.hpp"
#include "bench/play/play_log.hpp"

namespace teamsight::tools {

struct CameraGames {
  camera_play::CameraSetup setup;
  std::string camera_sum;      ///< of the camera file, and of the profile that it names
  std::string field_sum;       ///< of the field file
  std::filesystem::path kept;  ///< folder of kept games; empty: none are kept
};

/// @param samples  drawn per pixel and axis
/// @throws std::exception naming file, key, what was found and what was expected
[[nodiscard]] CameraGames load_camera_games(const std::string& camera,
                                            const std::string& field,
                                            int samples);

/// One game. With a folder of kept games it is read from there, or rendered and put there; a file
/// that is damaged is replaced, with a word on stderr. The log is the same to the last bit.
///
/// @throws kept_play::OtherGame if the file that should hold it was kept with other settings, or
///         by other code
[[nodiscard]] play::PlayLog camera_game(const play::Scenario& scenario,
                                        std::uint64_t seed,
                                        double seconds,
                                        const CameraGames& games);

}  // namespace teamsight::tools
