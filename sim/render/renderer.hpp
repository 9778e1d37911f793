// sim/render/renderer.hpp: what a robot's omni camera shows of a match, ray traced.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/field_model.hpp"
#include "sim/match/random.hpp"
#include "sim/render/floor_texture.hpp"
#include "sim/render/hall.hpp"
#include "sim/render/optics.hpp"
#include "sim/render/scene.hpp"
#include "sim/render/sensor.hpp"
#include "sim/render/shapes.hpp"
#include "sim/render/sights.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::sim {

/// A part of the looking robot's own body: an upright cylinder on the robot's axis.
struct BodyPart {
  double radius{0.0};  ///< m
  double height{0.0};  ///< m over the floor
  Paint side;
  Paint lid;
};

/// A rod that holds the mirror, seen directly by the camera: a dark wedge from the centre outwards.
struct Strut {
  double direction{0.0};   ///< in the picture, counter-clockwise from image right; rad
  double half_width{0.0};  ///< rad
};

/// How things look, and how carefully they are drawn.
struct PictureParameters {
  int fineness{1};         ///< samples per pixel and axis, 1 to 8: 1 lives on smooth edges alone
  int moments{1};          ///< of the exposure that are drawn and averaged: motion blur
  double exposure{0.005};  ///< s
  SensorParameters sensor;
  Paint carpet{40, 120, 40};
  Paint line{230, 230, 230};
  double unevenness{0.1};  ///< of the carpet's brightness, a share
  std::uint32_t hall_seed{1};
  std::vector<BodyPart> body;  ///< from the widest, lowest to the narrowest, highest
  std::vector<Strut> struts;
};

/// Draws frames of one camera. All tables are made by the constructor (some 0.5 us per sample); a
/// frame allocates nothing. It shares no geometry with vision's camera model.
class Renderer {
 public:
  /// @param camera  the eye as it really is: see with_defects
  /// @param floor   of another renderer with the same field and parameters, which is the same for
  ///                all eyes; nothing: it makes its own
  /// @pre the size is one that the camera's format can have
  Renderer(const vision::CameraParameters& camera,
           const FieldModel& field,
           const PictureParameters& parameters,
           std::shared_ptr<const FloorTexture> floor = nullptr);

  /// Draws one frame in the camera's format.
  ///
  /// @param random  of the noise
  /// @param out     resized to the frame; its memory is used again
  void draw(const Scene& scene, Random& random, std::vector<std::uint8_t>& out);

  /// Where a point appears if nothing hides it.
  [[nodiscard]] std::optional<ImagePlace> find(const Point3<Robot>& p_R) const {
    return optics_.find(p_R);
  }

  [[nodiscard]] const vision::CameraParameters& camera() const { return camera_; }

  /// The painted floor, for other renderers of the same hall.
  [[nodiscard]] const std::shared_ptr<const FloorTexture>& floor() const { return floor_; }

 private:
  /// How a sight's patch of floor is looked up.
  struct FloorView {
    float x{0.0F};  // of the first sample in R; m
    float y{0.0F};
    float step_x{0.0F};  // from sample to sample, away from the robot; m
    float step_y{0.0F};
    std::uint32_t pixel{0};
    std::uint8_t level{0};
    std::uint8_t samples{0};  // 0: it sees no floor
  };

  /// A pose, ready for use on many points.
  struct Turn {
    float c{1.0F};
    float s{0.0F};
    float x{0.0F};
    float y{0.0F};
  };

  /// A pixel that own body or struts fill in part; those that they fill wholly are painted once.
  struct Covered {
    std::uint32_t pixel{0};
    Light light;
  };

  /// A panel of a goal or a wall, at its place in F.
  struct FieldPanel {
    Point<Field> from;
    Point<Field> to;
    Panel shape;
  };

  struct FieldPost {
    Point<Field> p_F;
    double height{0.0};  ///< m
    Paint paint;
  };

  void make_overlay();
  void add_struts(Canvas& overlay) const;
  void make_floor_views();
  void add_goal(const Goal& goal, const Point<Field>& centre);
  void paint_moment(const Scene& scene, double seconds);
  void paint_ground(const Pose<Field, Robot>& X_FR);
  [[nodiscard]] Light beyond_carpet(const Sight& sight, const Turn& turn) const;
  void paint_standing(const Scene& scene, const Pose<Field, Robot>& X_FR, double seconds);
  void paint_fixed(const Pose<Robot, Field>& X_RF);
  void paint_robot(const SceneRobot& robot, const Point<Robot>& p_R);
  void paint_markers(const Paint& paint, double radius, const Point<Robot>& p_R);
  void paint_person(const ScenePerson& person, const Point<Robot>& p_R);
  void add_moment();

  vision::CameraParameters camera_;
  PictureParameters parameters_;
  Optics optics_;
  Sights sights_;
  std::shared_ptr<const FloorTexture> floor_;  // never nothing
  Hall hall_;
  Sensor sensor_;
  std::vector<FloorView> floor_views_;  // by sight
  std::vector<FieldPanel> panels_;
  std::vector<FieldPost> posts_;
  std::vector<Covered> overlay_;
  Canvas fine_;                                        // fineness times finer than the picture
  Canvas light_;                                       // of the picture
  std::vector<std::pair<double, std::size_t>> order_;  // of what moves: distance and index
};

}  // namespace teamsight::sim
