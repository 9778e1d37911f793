// settings/camera_file.cpp: a camera file becomes CameraParameters.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "config.pb.h"
#include "geometry/angle.hpp"
#include "settings/calibration_record.hpp"
#include "settings/camera_names.hpp"
#include "settings/camera_parts.hpp"
#include "settings/load.hpp"
#include "settings/profile_csv.hpp"
#include "settings/text_format.hpp"
#include "vision/image.hpp"

namespace teamsight::settings {

namespace {

using config::CameraFile;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

// Pixels beside or below each other may share their chroma.
void check_even(const TextFile& text, const vision::CameraParameters& camera) {
  const auto check = [&](const char* key, std::uint32_t width_px, std::uint32_t height_px) {
    if (vision::has_even_size(camera.format, width_px, height_px)) return;
    throw text.error(key,
                     std::to_string(std::max(width_px, height_px)),
                     "an even number: in this format pixels share their chroma");
  };
  check("width_px", camera.width_px, 0);
  check("height_px", 0, camera.height_px);
}

// ---- mirrors -----------------------------------------------------------------------------------

void check_grows(const TextFile& text, const std::string& key, double value, double before) {
  if (value > before) return;
  throw text.error(key, text_of(value), "more than in the row before, " + text_of(before));
}

vision::RadialTable radial_table(const TextFile& text, const CameraFile::RadialTable& file) {
  constexpr int kFewestRows = 3;
  if (file.row_size() < kFewestRows) {
    throw text.error("radial_table.row", std::to_string(file.row_size()) + " rows", "at least 3");
  }
  vision::RadialTable table;
  table.centre_u_px = file.centre_u_px();
  table.centre_v_px = file.centre_v_px();
  table.mirror_height = file.mirror_height_m();
  table.head_roll = radians(file.head_roll_deg());
  table.head_pitch = radians(file.head_pitch_deg());
  for (int i = 0; i < file.row_size(); ++i) {
    const auto& row = file.row(i);
    if (i > 0) {
      const std::string key = "radial_table." + key_of("row", i);
      check_grows(text, key + ".radius_px", row.radius_px(), file.row(i - 1).radius_px());
      check_grows(text, key + ".distance_m", row.distance_m(), file.row(i - 1).distance_m());
    }
    table.rows.push_back({row.radius_px(), row.distance_m(), row.sigma_px()});
  }
  return table;
}

vision::ProfileMirror profile_mirror(const TextFile& text, const CameraFile::ProfileMirror& file) {
  vision::ProfileMirror mirror;
  mirror.focal_x_px = file.focal_x_px();
  mirror.focal_y_px = file.focal_y_px();
  mirror.centre_u_px = file.centre_u_px();
  mirror.centre_v_px = file.centre_v_px();
  mirror.profile = read_profile(text.resolve("profile.profile_csv", file.profile_csv()));
  mirror.pinhole_height = file.pinhole_height_m();
  mirror.offset_C = {file.offset_x_m(), file.offset_y_m(), file.offset_z_m()};
  mirror.tilt_C = {radians(file.tilt_x_deg()), radians(file.tilt_y_deg())};
  mirror.head_roll = radians(file.head_roll_deg());
  mirror.head_pitch = radians(file.head_pitch_deg());
  return mirror;
}

void check_centre(const TextFile& text, const CameraFile& file, double u_px, double v_px) {
  const std::string block = file.has_profile() ? "profile." : "radial_table.";
  const auto check = [&](const char* key, double value, std::uint32_t size) {
    if (value >= 0.0 && value <= size - 1.0) return;
    throw text.error(
        block + key, text_of(value), "a place in the image, from 0 to " + std::to_string(size - 1));
  };
  check("centre_u_px", u_px, file.width_px());
  check("centre_v_px", v_px, file.height_px());
}

std::variant<vision::RadialTable, vision::ProfileMirror> mirror_of(const TextFile& text,
                                                                   const CameraFile& file) {
  switch (file.mirror_case()) {
    case CameraFile::kRadialTable:
      check_centre(
          text, file, file.radial_table().centre_u_px(), file.radial_table().centre_v_px());
      return radial_table(text, file.radial_table());
    case CameraFile::kProfile:
      check_centre(text, file, file.profile().centre_u_px(), file.profile().centre_v_px());
      return profile_mirror(text, file.profile());
    case CameraFile::MIRROR_NOT_SET:
      break;
  }
  throw text.error("mirror", "no mirror", "a block radial_table or profile");
}

// Pixels from the centre to the mirror's rim.
double rim_px(const vision::CameraParameters& camera) {
  if (const auto* table = std::get_if<vision::RadialTable>(&camera.mirror)) {
    return table->rows.back().radius_px;
  }
  const auto& mirror = std::get<vision::ProfileMirror>(camera.mirror);
  const vision::ProfilePoint& rim = mirror.profile.back();
  return mirror.focal_x_px * rim.x / (rim.y + mirror.offset_C[2]);
}

// A mirror that fills but a spot of the image, or less than the mask lets through, is not the one
// in front of this lens.
void check_cover(const TextFile& text,
                 const CameraFile& file,
                 const vision::CameraParameters& camera) {
  constexpr double kLeast = 0.2;  // of the image's smaller side
  constexpr double kSlack = 1.5;  // px
  const double rim = rim_px(camera);
  const double least = kLeast * std::min(camera.width_px, camera.height_px);
  if (!(rim >= least)) {
    throw text.error(file.has_profile() ? "profile.profile_csv" : "radial_table.row",
                     "a mirror whose rim is seen " + text_of(std::round(rim)) +
                         " px from the centre of the image",
                     "at least " + text_of(std::round(least)) + " px: it does not cover the image");
  }
  if (file.mask().has_outer_radius_px() && camera.mask.outer_radius_px > rim + kSlack) {
    throw text.error("mask.outer_radius_px",
                     text_of(camera.mask.outer_radius_px),
                     "at most where the mirror ends, " + text_of(std::round(rim)) + " px");
  }
}

// ---- mask --------------------------------------------------------------------------------------

vision::Mask mask_of(const TextFile& text, const CameraFile& file) {
  vision::Mask mask;
  mask.inner_radius_px = file.mask().inner_radius_px();
  if (file.mask().has_outer_radius_px()) mask.outer_radius_px = file.mask().outer_radius_px();
  if (mask.outer_radius_px <= mask.inner_radius_px) {
    throw text.error("mask.outer_radius_px",
                     text_of(mask.outer_radius_px),
                     "more than inner_radius_px, " + text_of(mask.inner_radius_px));
  }
  for (int i = 0; i < file.mask().sector_size(); ++i) {
    const auto& sector = file.mask().sector(i);
    const double extent = sector.to_deg() - sector.from_deg();
    if (extent <= 0.0 || extent >= 360.0) {
      throw text.error("mask." + key_of("sector", i) + ".to_deg",
                       text_of(sector.to_deg()),
                       "more than from_deg, by less than a full turn");
    }
    mask.sectors.push_back(
        {wrap_angle(radians(sector.from_deg())), wrap_angle(radians(sector.to_deg()))});
  }
  for (int i = 0; i < file.mask().polygon_size(); ++i) {
    mask.polygons.push_back(
        polygon_of(text, "mask." + key_of("polygon", i), file.mask().polygon(i)));
  }
  return mask;
}

}  // namespace

vision::CameraParameters load_camera(const std::filesystem::path& path) {
  CameraFile file;
  const TextFile text = TextFile::read(path, file);
  vision::CameraParameters camera;
  camera.name = file.name();
  camera.width_px = file.width_px();
  camera.height_px = file.height_px();
  camera.format = format_of(file.format());
  check_even(text, camera);
  camera.mirror = mirror_of(text, file);
  camera.forward = wrap_angle(radians(file.mounting().forward_deg()));
  camera.mirrored = file.mounting().mirrored();
  camera.colours = colours_of(text, file.colours());
  camera.mask = mask_of(text, file);
  check_cover(text, file, camera);
  if (file.has_calibration()) camera.calibration = calibration_record(text, file);
  camera.scan.rays = static_cast<std::uint16_t>(file.scan().rays());
  camera.scan.max_distance = file.scan().max_distance_m();
  camera.scan.min_contrast = file.scan().min_contrast();
  camera.scan.chroma_window = static_cast<std::uint16_t>(file.scan().chroma_window());
  camera.sensors = sensors_of(text, file);
  return camera;
}

}  // namespace teamsight::settings
