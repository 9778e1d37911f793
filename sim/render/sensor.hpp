// sim/render/sensor.hpp: from light to bytes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/match/random.hpp"
#include "sim/render/optics.hpp"
#include "sim/render/shapes.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::sim {

/// What lens and sensor do to the light.
struct SensorParameters {
  double exposure{1.0};  ///< gain; 1: paints look as they are named
  double red_gain{1.0};  ///< colour cast
  double green_gain{1.0};
  double blue_gain{1.0};
  double vignetting{0.3};        ///< share of the light that is lost at the picture's corners
  double defocus_px{0.5};        ///< sigma of the blur in the picture's centre
  double rim_defocus_px{0.75};   ///< and at its corners
  double noise_sigma{3.0};       ///< of each colour, from photons; grey levels
  double dark_noise_sigma{1.5};  ///< more of it in the dark; grey levels at black
};

/// A sensor whose curve is a square root: the noise of photons is then equal everywhere.
class Sensor {
 public:
  /// @param centre  where the picture is brightest and sharpest
  Sensor(const SensorParameters& parameters,
         const vision::CameraParameters& camera,
         const ImagePlace& centre);

  /// Makes a frame in the camera's format.
  ///
  /// @param light  one entry per pixel
  /// @param out    resized to the frame; its memory is used again
  void develop(const Canvas& light, Random& random, std::vector<std::uint8_t>& out);

 private:
  void blur_once(Canvas& light);
  void blur_along(const Light* from, std::size_t row, Light* to) const;
  void expose_row(std::size_t row, Random& random);
  void write_row(std::size_t row, std::vector<std::uint8_t>& out);
  void write_bgr(std::uint8_t* out) const;
  void write_shared_chroma(std::size_t row, std::uint8_t* out);
  void write_pairs(std::uint8_t* out) const;

  SensorParameters parameters_;
  std::size_t width_;
  std::size_t height_;
  vision::PixelFormat format_;
  Light gain_;
  int blur_passes_{0};
  std::vector<float> blur_weight_;  // of each neighbour, per pixel and pass
  std::vector<float> vignette_;     // per pixel
  const Light* noise_;              // normal, sigma 1; of all sensors
  Canvas row_;                      // what the sensor shows, 0 to 255
  Canvas above_;                    // the row before, where two share their colour
  std::array<Canvas, 3> ring_;      // three rows, blurred along
  Canvas copy_;                     // of the light, where one pass of blur is not enough
};

}  // namespace teamsight::sim
