// vision/calibration/body_mask.hpp: what always looks the same while the robot drives is the robot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/result.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/colour_classes.hpp"
#include "vision/image.hpp"

namespace teamsight::vision {

/// A piece of own body, bounded by two circles about the image centre and two directions.
struct BodyPatch {
  double from{0.0};  ///< counter-clockwise from image right; rad
  double to{0.0};    ///< more than `from`, by less than half a turn
  double inner_px{0.0};
  double outer_px{0.0};
  bool is_strut{false};  ///< reaches from the disc to the rim: nothing is seen in its directions
};

/// The robot as its camera sees it.
struct Body {
  double inner_radius_px{0.0};     ///< all of it inside is own body
  std::vector<BodyPatch> patches;  ///< struts, and what else stands out of the disc or hangs in it
  double hidden_share{0.0};        ///< of the mirror's picture, altogether
};

enum class BodyFailure : std::uint8_t {
  kTooFew,     ///< fewer than ten frames
  kNotMoving,  ///< most of the picture never changed: the robot stood still
};

/// Collects a driving sequence. Frames must be of one camera.
class BodyWatch {
 public:
  /// @param rim_px  pixels farther from the centre show no mirror
  BodyWatch(const Pixel& centre, double rim_px, std::uint32_t width_px, std::uint32_t height_px);

  /// @pre the image is whole and of the size given
  void add(const ImageView& image);

  /// Own body: pixels that hardly vary against the camera's noise, and are not carpet, whose mean
  /// may stay the same as well.
  [[nodiscard]] Result<Body, BodyFailure> body(const ColourClasses& colours) const;

 private:
  struct Cell {
    float mean{0.0F};
    float square{0.0F};  // sum of squared differences from the mean
    float u{0.0F};       // sums of chroma
    float v{0.0F};
  };

  [[nodiscard]] double sigma(const Cell& cell) const;
  [[nodiscard]] double noise() const;
  [[nodiscard]] std::vector<std::uint8_t> still_pixels(const ColourClasses& colours) const;

  Pixel centre_;
  double rim_;
  std::uint32_t width_;
  std::uint32_t height_;
  std::size_t frames_{0};
  std::vector<Cell> cells_;
};

}  // namespace teamsight::vision
