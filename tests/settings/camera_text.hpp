// tests/settings/camera_text.hpp: camera files that load, to be spoilt by tests.
#pragma once

namespace teamsight::settings {

inline constexpr const char* kRadialCamera = R"(name: "eye"
width_px: 640
height_px: 480
format: UYVY
radial_table {
  centre_u_px: 320
  centre_v_px: 240
  mirror_height_m: 0.67
  row { radius_px: 100 distance_m: 1 }
  row { radius_px: 150 distance_m: 2 sigma_px: 1.5 }
  row { radius_px: 180 distance_m: 4 }
}
mounting { forward_deg: 90 mirrored: false }
colours {
  white_min_y: 150
  black_max_y: 50
  sample { class: GREEN u: 110 v: 100 }
  sample { class: BALL u: 90 v: 190 radius: 30 }
}
mask {
  inner_radius_px: 40
  outer_radius_px: 175
  sector { from_deg: 350 to_deg: 370 }
}
)";

inline constexpr const char* kProfileCamera = R"(name: "eye"
width_px: 640
height_px: 480
format: BGR
profile {
  focal_x_px: 600
  focal_y_px: 610
  centre_u_px: 320
  centre_v_px: 240
  profile_csv: "eye.csv"
  pinhole_height_m: 0.6
  tilt_x_deg: 2
}
mounting { forward_deg: -90 mirrored: true }
colours { white_min_y: 150 black_max_y: 50 }
)";

inline constexpr const char* kProfileCsv = "x_m,y_m,slope\n0,0.2,0\n0.02,0.21,0.5\n0.04,0.23,1\n";

}  // namespace teamsight::settings
