// settings/camera_writer.cpp: CameraParameters become a camera file.
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <google/protobuf/text_format.h>
#include <unistd.h>

#include "config.pb.h"
#include "settings/calibration_record.hpp"
#include "settings/camera_names.hpp"
#include "settings/camera_parts.hpp"
#include "settings/class_table_file.hpp"
#include "settings/load.hpp"
#include "settings/profile_csv.hpp"

namespace teamsight::settings {

namespace {

using config::CameraFile;

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

std::filesystem::path profile_beside(const std::filesystem::path& path) {
  return path.parent_path() / (path.stem().string() + "-profile.csv");
}

std::filesystem::path classes_beside(const std::filesystem::path& path) {
  return path.parent_path() / (path.stem().string() + "-classes.bin");
}

void write(const vision::RadialTable& table, CameraFile& file) {
  auto& out = *file.mutable_radial_table();
  out.set_centre_u_px(table.centre_u_px);
  out.set_centre_v_px(table.centre_v_px);
  out.set_mirror_height_m(table.mirror_height);
  out.set_head_roll_deg(degrees(table.head_roll));
  out.set_head_pitch_deg(degrees(table.head_pitch));
  for (const vision::RingMark& mark : table.rows) {
    auto& row = *out.add_row();
    row.set_radius_px(mark.radius_px);
    row.set_distance_m(mark.distance);
    row.set_sigma_px(mark.sigma_px);
  }
}

void write(const vision::ProfileMirror& mirror, CameraFile& file) {
  auto& out = *file.mutable_profile();
  out.set_focal_x_px(mirror.focal_x_px);
  out.set_focal_y_px(mirror.focal_y_px);
  out.set_centre_u_px(mirror.centre_u_px);
  out.set_centre_v_px(mirror.centre_v_px);
  out.set_pinhole_height_m(mirror.pinhole_height);
  out.set_offset_x_m(mirror.offset_C[0]);
  out.set_offset_y_m(mirror.offset_C[1]);
  out.set_offset_z_m(mirror.offset_C[2]);
  out.set_tilt_x_deg(degrees(mirror.tilt_C[0]));
  out.set_tilt_y_deg(degrees(mirror.tilt_C[1]));
  out.set_head_roll_deg(degrees(mirror.head_roll));
  out.set_head_pitch_deg(degrees(mirror.head_pitch));
}

void write(const vision::Mask& mask, CameraFile::Mask& out) {
  constexpr double kNoRim = 8192.0;  // the largest image: a mask that hides nothing
  out.set_inner_radius_px(mask.inner_radius_px);
  if (mask.outer_radius_px <= kNoRim) out.set_outer_radius_px(mask.outer_radius_px);
  for (const vision::MaskedSector& sector : mask.sectors) {
    auto& line = *out.add_sector();
    line.set_from_deg(degrees(sector.from));
    line.set_to_deg(degrees(sector.to) + (sector.to < sector.from ? 360.0 : 0.0));
  }
  for (const vision::Polygon& polygon : mask.polygons) write_polygon(polygon, *out.add_polygon());
}

CameraFile file_of(const vision::CameraParameters& camera, const std::filesystem::path& path) {
  CameraFile file;
  file.set_name(camera.name);
  file.set_width_px(camera.width_px);
  file.set_height_px(camera.height_px);
  file.set_format(file_format_of(camera.format));
  std::visit([&](const auto& mirror) { write(mirror, file); }, camera.mirror);
  if (file.has_profile()) {
    file.mutable_profile()->set_profile_csv(profile_beside(path).filename().string());
  }
  file.mutable_mounting()->set_forward_deg(degrees(camera.forward));
  file.mutable_mounting()->set_mirrored(camera.mirrored);
  write_colours(camera.colours, *file.mutable_colours());
  if (!camera.colours.table.empty()) {
    file.mutable_colours()->set_table(classes_beside(path).filename().string());
  }
  write(camera.mask, *file.mutable_mask());
  if (camera.calibration) write_record(*camera.calibration, *file.mutable_calibration());
  file.mutable_scan()->set_rays(camera.scan.rays);
  file.mutable_scan()->set_max_distance_m(camera.scan.max_distance);
  file.mutable_scan()->set_min_contrast(camera.scan.min_contrast);
  file.mutable_scan()->set_chroma_window(camera.scan.chroma_window);
  for (const auto& sensor : camera.sensors) write_sensor(sensor, *file.add_sensor());
  return file;
}

// A crash or a second writer leaves the old file or a new one, never a part.
void replace_file(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path draft = path.string() + "." + std::to_string(getpid()) + ".draft";
  std::ofstream file(draft, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(draft, path, error);
  if (file && !error) return;
  std::error_code ignored;
  std::filesystem::remove(draft, ignored);
  throw SettingsError(path.string() + ":1:1: found a place that cannot be written, expected a " +
                      "path in a writable folder");
}

std::string as_comment(const std::string& text) {
  std::string lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines += "# " + line + "\n";
  return lines;
}

}  // namespace

void save_camera(const std::filesystem::path& path,
                 const vision::CameraParameters& camera,
                 const std::string& comment) {
  const CameraFile file = file_of(camera, path);
  std::string text;
  google::protobuf::TextFormat::PrintToString(file, &text);
  if (const auto* mirror = std::get_if<vision::ProfileMirror>(&camera.mirror)) {
    replace_file(profile_beside(path), profile_csv(mirror->profile));
  }
  if (!camera.colours.table.empty()) {
    replace_file(classes_beside(path), class_table_bytes(camera.colours.table));
  }
  replace_file(path,
               "# " + path.filename().string() + ": one robot's eye; see CameraFile in " +
                   "idl/config.proto.\n" + as_comment(comment) + text);
}

}  // namespace teamsight::settings
