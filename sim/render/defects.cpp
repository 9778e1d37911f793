// sim/render/defects.cpp: see defects.hpp.
#include "sim/render/defects.hpp"

#include "geometry/expect.hpp"
#include "sim/match/random.hpp"

namespace teamsight::sim {

CameraDefects draw_defects(std::uint32_t seed, const DefectSizes& sizes) {
  Random random(seed);
  CameraDefects defects;
  defects.mirror_offset = {random.normal(sizes.sigma_lateral),
                           random.normal(sizes.sigma_lateral),
                           random.normal(sizes.sigma_axial)};
  defects.mirror_tilt = {random.normal(sizes.sigma_mirror_tilt),
                         random.normal(sizes.sigma_mirror_tilt)};
  defects.head_roll = random.normal(sizes.sigma_head_tilt);
  defects.head_pitch = random.normal(sizes.sigma_head_tilt);
  defects.focal_scale = 1.0 + random.normal(sizes.sigma_focal);
  defects.centre_u_px = random.normal(sizes.sigma_centre_px);
  defects.centre_v_px = random.normal(sizes.sigma_centre_px);
  return defects;
}

vision::CameraParameters with_defects(vision::CameraParameters camera,
                                      const CameraDefects& defects) {
  if (auto* mirror = std::get_if<vision::ProfileMirror>(&camera.mirror)) {
    for (std::size_t i = 0; i < 3; ++i) {
      mirror->offset_C[i] += defects.mirror_offset[i];
    }
    mirror->tilt_C[0] += defects.mirror_tilt[0];
    mirror->tilt_C[1] += defects.mirror_tilt[1];
    mirror->head_roll += defects.head_roll;
    mirror->head_pitch += defects.head_pitch;
    mirror->focal_x_px *= defects.focal_scale;
    mirror->focal_y_px *= defects.focal_scale;
    mirror->centre_u_px += defects.centre_u_px;
    mirror->centre_v_px += defects.centre_v_px;
    return camera;
  }
  TEAMSIGHT_EXPECT(defects.head_roll == 0.0 && defects.head_pitch == 0.0);
  auto& table = std::get<vision::RadialTable>(camera.mirror);
  table.centre_u_px += defects.centre_u_px;
  table.centre_v_px += defects.centre_v_px;
  for (vision::RingMark& row : table.rows) {
    row.radius_px *= defects.focal_scale;
  }
  return camera;
}

}  // namespace teamsight::sim
