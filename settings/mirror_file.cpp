// settings/mirror_file.cpp: translates mirror files into parameters of the core.
#include "settings/mirror_file.hpp"

#include <numbers>

#include "mirror.pb.h"
#include "settings/text_format.hpp"

namespace teamsight::settings {

namespace {

using config::MirrorFile;

constexpr double kDegree = std::numbers::pi / 180.0;

mirror::MultiPart to_multi_part(const MirrorFile::MultiPart& file) {
  return {.isometric_range = file.isometric_range_m(),
          .isometric_share = file.isometric_share(),
          .max_distance = file.max_distance_m(),
          .max_height = file.max_height_m(),
          .ring_near = file.ring_near_m(),
          .ring_far = file.ring_far_m()};
}

mirror::Shape to_shape(const MirrorFile& file, const TextFile& text) {
  switch (file.shape_case()) {
    case MirrorFile::kMultiPart:
      return to_multi_part(file.multi_part());
    case MirrorFile::kCone:
      return mirror::Cone{file.cone().apex_m(), file.cone().slope_deg() * kDegree};
    case MirrorFile::kSphere:
      return mirror::Sphere{file.sphere().apex_m(), file.sphere().radius_m()};
    case MirrorFile::kParaboloid:
      return mirror::Paraboloid{file.paraboloid().apex_m(), file.paraboloid().apex_radius_m()};
    case MirrorFile::kHyperboloid:
      return mirror::Hyperboloid{file.hyperboloid().a_m(), file.hyperboloid().b_m()};
    case MirrorFile::kConeWithApex:
      return mirror::ConeWithApex{file.cone_with_apex().near_m(),
                                  file.cone_with_apex().far_m(),
                                  file.cone_with_apex().rim_y_m()};
    case MirrorFile::kProfileCsv:
      return mirror::GivenProfile{
          read_mirror_profile(text.resolve("profile_csv", file.profile_csv()))};
    case MirrorFile::SHAPE_NOT_SET:
      break;
  }
  throw text.error("shape",
                   "no shape",
                   "one of multi_part, cone, sphere, paraboloid, hyperboloid, cone_with_apex, "
                   "profile_csv");
}

void check_together(const MirrorFile& file, const TextFile& text) {
  if (file.has_multi_part()) {
    const auto& p = file.multi_part();
    if (p.ring_near_m() >= p.ring_far_m()) {
      throw text.error("multi_part.ring_near_m",
                       text_of(p.ring_near_m()),
                       "less than ring_far_m, " + text_of(p.ring_far_m()));
    }
    if (p.max_distance_m() <= p.isometric_range_m()) {
      throw text.error("multi_part.max_distance_m",
                       text_of(p.max_distance_m()),
                       "more than isometric_range_m, " + text_of(p.isometric_range_m()));
    }
  }
  if (file.has_cone_with_apex() &&
      file.cone_with_apex().near_m() >= file.cone_with_apex().far_m()) {
    throw text.error("cone_with_apex.near_m",
                     text_of(file.cone_with_apex().near_m()),
                     "less than far_m, " + text_of(file.cone_with_apex().far_m()));
  }
}

}  // namespace

MirrorSettings load_mirror(const std::filesystem::path& path) {
  MirrorFile file;
  const TextFile text = TextFile::read(path, file);
  check_together(file, text);
  MirrorSettings settings;
  settings.parameters.name = file.name();
  settings.parameters.rim = {file.rim_radius_m(), file.rim_height_m()};
  settings.parameters.shape = to_shape(file, text);
  settings.parameters.facet_px = file.facet_px();
  if (file.has_focal_px()) {
    settings.parameters.scale = mirror::FocalPx{file.focal_px()};
  } else if (file.has_rim_radius_px()) {
    settings.parameters.scale = mirror::RimRadiusPx{file.rim_radius_px()};
  }
  for (const auto& cylinder : file.body()) {
    settings.parameters.body.push_back({cylinder.height_m(), cylinder.radius_m()});
  }
  if (file.has_pixel_pitch_um()) {
    settings.pixel_pitch = file.pixel_pitch_um() * 1e-6;
  }
  return settings;
}

}  // namespace teamsight::settings
