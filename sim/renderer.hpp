// sim/renderer.hpp: what a robot's omni camera shows of a match, pixel by pixel.
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "geometry/field_model.hpp"
#include "geometry/frames.hpp"
#include "geometry/pose.hpp"
#include "sim/floor_texture.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/ray_table.hpp"

namespace teamsight::sim {

/// What stands on the floor around one robot.
struct Scene {
  Pose<Field, Robot> X_FR;           ///< of the robot that looks
  std::vector<Point<Field>> others;  ///< the axes of the other robots
  Point3<Field> p_FB;                ///< ball centre
};

struct RenderParameters {
  double ball_radius{0.11};       ///< m
  double robot_radius{0.25};      ///< m
  double robot_height{0.8};       ///< m
  double pixel_noise_sigma{3.0};  ///< of luminance; grey levels
};

/// Draws YUYV or UYVY frames. All tables are made by the constructor; nothing is allocated per
/// frame. Carpet, paint and everything else have the colours that config/cameras/sim-640 names.
class Renderer {
 public:
  /// @pre the camera's format is kYuyv or kUyvy and its width even
  Renderer(const vision::CameraParameters& camera,
           const FieldModel& field,
           const RenderParameters& parameters);

  /// Draws one frame.
  ///
  /// @param random  of the pixel noise
  /// @param out     resized to the frame; its memory is used again
  void draw(const Scene& scene, std::mt19937& random, std::vector<std::uint8_t>& out);

  [[nodiscard]] std::uint32_t width_px() const { return width_px_; }

  [[nodiscard]] std::uint32_t height_px() const { return height_px_; }

  [[nodiscard]] vision::PixelFormat format() const { return format_; }

 private:
  /// One floor sample of a pixel; pixels that see far have several along their line of sight.
  struct FloorSample {
    float x{0.0F};  // in R
    float y{0.0F};
  };

  struct FloorPixel {
    std::uint32_t pixel{0};
    std::uint32_t first_sample{0};
    std::uint16_t samples{0};
    std::uint8_t level{0};
  };

  /// A pixel as a line of sight, for what stands on the floor; in bins by azimuth.
  struct Sight {
    std::uint32_t pixel{0};
    float origin_x{0.0F};
    float origin_y{0.0F};
    float origin_z{0.0F};
    float direction_x{0.0F};
    float direction_y{0.0F};
    float direction_z{0.0F};
    float reach{0.0F};  // m on the floor; infinite where it does not meet it
  };

  void add_floor_pixel(std::uint32_t pixel, const vision::PixelRay& ray);
  void add_sights(const vision::RayTable& rays);
  void draw_floor(const Pose<Field, Robot>& X_FR);
  void draw_standing(const Scene& scene);
  void draw_robot(const Point<Robot>& p_R);
  void draw_ball(const Point3<Robot>& p_R);
  [[nodiscard]] std::span<const Sight> sights_beyond(std::size_t bin, float distance) const;
  template <class Hits>
  void paint_sector(const Point<Robot>& p_R, double radius, std::uint8_t material, Hits hits);
  void develop(std::mt19937& random, std::vector<std::uint8_t>& out) const;

  RenderParameters parameters_;
  std::uint32_t width_px_;
  std::uint32_t height_px_;
  vision::PixelFormat format_;
  FloorTexture texture_;
  std::vector<FloorPixel> floor_;
  std::vector<FloorSample> samples_;
  std::vector<Sight> sights_;              // ordered by bin, then by reach
  std::vector<std::uint32_t> bin_starts_;  // of each bin in sights_, and the end
  std::vector<std::uint8_t> blank_;        // materials of a picture without a floor
  std::vector<std::uint8_t> materials_;    // of the frame being drawn
  std::vector<std::int8_t> noise_;
};

}  // namespace teamsight::sim
