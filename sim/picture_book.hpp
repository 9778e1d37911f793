// sim/picture_book.hpp: a match as image files, with the truth beside them.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "sim/setup.hpp"

namespace teamsight::sim {

/// Told after every frame how many of how many are written.
using Progress = std::function<void(int frames, int all)>;

struct PictureBook {
  std::filesystem::path folder;     ///< must not exist yet
  double seconds{10.0};             ///< of the match; frames at the match file's rate
  std::optional<int> jpeg_quality;  ///< 1 to 100; nothing: PNG, without loss
};

/// Plays a match and writes what every own robot sees: `robotN_000042.png` (or .jpg), and in
/// `truth.jsonl` one line per image: image, robot, time_s, x_m, y_m, theta_rad, odometry {x_m, y_m,
/// theta_rad}, balls [{x_m, y_m, z_m, vx_mps, vy_mps, vz_mps, u_px, v_px}] (pixel null where the
/// mirror does not show it; what hides it is not looked at), robots [{number, x_m, y_m}], all in F.
///
/// The folder appears when it is complete, under FOLDER.part until then (what is there is removed);
/// on failure there is none.
///
/// @throws std::runtime_error naming a folder that exists already or cannot be written
void write_picture_book(const Setup& setup, const PictureBook& book, const Progress& told);

}  // namespace teamsight::sim
