// sim/render/optics.hpp: where the simulated camera looks; shares nothing with vision's model.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "sim/render/meridian.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::sim {

/// A place in the image; whole numbers are the middles of pixels.
struct ImagePlace {
  double u{0.0};
  double v{0.0};
};

/// Lines of sight of the camera that a camera file describes.
///
/// It reads the file's numbers as vision does and works with them on its own: pictures that are
/// drawn with the code that is under test would confirm its errors.
class Optics {
 public:
  explicit Optics(const vision::CameraParameters& camera);

  /// What is seen at a place, in R; nothing beside the mirror.
  [[nodiscard]] std::optional<Ray<Robot>> look(const ImagePlace& place) const;

  /// Where a point in space appears, if nothing hides it; nothing if the mirror does not show it.
  [[nodiscard]] std::optional<ImagePlace> find(const Point3<Robot>& p_R) const;

  /// The pixel on the camera's axis.
  [[nodiscard]] ImagePlace centre() const { return centre_; }

 private:
  /// A radial table: angle from straight down over the radius, from one viewpoint.
  struct Table {
    std::vector<double> radius_px;
    std::vector<double> angle;
    std::vector<double> steepness;  // of the angle, per px, at each row
    double height{0.0};
  };

  /// A surface of revolution over a pinhole. M: the mirror's frame, its axis is z.
  struct Mirror {
    Meridian meridian;
    double focal_x_px{0.0};
    double focal_y_px{0.0};
    bool turned_over{false};
    Eigen::Vector3d pinhole_M;
    Eigen::Matrix3d R_CM;
    Eigen::Matrix3d R_RC;
    double pinhole_height{0.0};
  };

  [[nodiscard]] static std::variant<Table, Mirror> make_eye(const vision::CameraParameters& camera);
  [[nodiscard]] static Table make_table(const vision::RadialTable& table);
  [[nodiscard]] static Mirror make_mirror(const vision::ProfileMirror& mirror,
                                          double forward,
                                          bool mirrored);
  [[nodiscard]] std::optional<Ray<Robot>> look(const Table& table, double du, double dv) const;
  [[nodiscard]] static std::optional<Ray<Robot>> look(const Mirror& mirror, double du, double dv);
  [[nodiscard]] static std::optional<Eigen::Vector3d> first_hit(const Mirror& mirror,
                                                                const Eigen::Vector3d& sight_M);
  [[nodiscard]] std::optional<ImagePlace> nearest_look(const Point3<Robot>& p_R) const;

  std::uint32_t width_px_;
  std::uint32_t height_px_;
  ImagePlace centre_;
  double forward_;
  bool mirrored_;
  std::variant<Table, Mirror> eye_;
};

}  // namespace teamsight::sim
