// tests/fuzz/camera_file_subject.cpp: a camera file is refused in one line, or makes an eye.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>
#include <vector>

#include "settings/load.hpp"
#include "tests/fuzz/observation_fault.hpp"
#include "tests/fuzz/small_field.hpp"
#include "tests/fuzz/subjects.hpp"
#include "tests/settings/camera_text.hpp"
#include "tests/settings/temporary_files.hpp"
#include "vision/perception.hpp"

namespace teamsight::fuzz {
namespace {

using vision::CameraParameters;

// Making the tables of a larger picture, or of more rays, takes longer but does nothing else.
constexpr std::uint32_t kMostPixels = 64 * 48;
constexpr std::uint16_t kMostRays = 90;

/// With the mirror's profile that some cameras ask for.
const settings::TemporaryFolder& folder() {
  static const settings::TemporaryFolder made;
  static const auto profile = made.write("eye.csv", settings::kProfileCsv);
  return made;
}

/// Every byte differs from those beside it, so that there is something everywhere.
std::string fault_of_looking(const CameraParameters& camera) {
  vision::Perception perception(camera, small_field());
  std::vector<std::uint8_t> bytes(
      vision::frame_bytes(camera.format, camera.width_px, camera.height_px));
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * i / 7);
  const auto seen = perception.see({bytes, camera.width_px, camera.height_px, camera.format}, {});
  return seen ? fault_of(**seen) : "the eye takes no frame";
}

std::string fault_of_complaint(const std::string& said, const std::filesystem::path& path) {
  const bool one_line =
      said.starts_with(path.parent_path().string()) && said.find('\n') == std::string::npos &&
      said.find("found ") != std::string::npos && said.find(", expected ") != std::string::npos;
  return one_line ? "" : "says: " + said;
}

std::string fault_of_writing(const CameraParameters& camera) {
  const auto path = folder().path() / "written";
  try {
    settings::save_camera(path, camera);
    const CameraParameters again = settings::load_camera(path);
    const bool same = again.name == camera.name && again.width_px == camera.width_px &&
                      again.height_px == camera.height_px && again.format == camera.format &&
                      again.colours.samples == camera.colours.samples &&
                      again.sensors == camera.sensors && again.scan == camera.scan &&
                      again.mirror.index() == camera.mirror.index();
    return same ? "" : "comes back changed";
  } catch (const settings::SettingsError& error) {
    return std::string("cannot be written and read: ") + error.what();
  }
}

}  // namespace

std::string fault_of_camera_file(std::span<const std::uint8_t> bytes) {
  const std::string text(bytes.begin(), bytes.end());
  const auto path = folder().write("eye", text);
  CameraParameters camera;
  try {
    camera = settings::load_camera(path);
  } catch (const settings::SettingsError& error) {
    return fault_of_complaint(error.what(), path);
  }
  if (std::string fault = fault_of_writing(camera); !fault.empty()) return fault;
  const bool is_small =
      camera.width_px * camera.height_px <= kMostPixels && camera.scan.rays <= kMostRays;
  return is_small ? fault_of_looking(camera) : "";
}

}  // namespace teamsight::fuzz
