// vision/virtual_sensors.hpp: the founding paper's virtual sensors, and any further ones.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "vision/camera_parameters.hpp"
#include "vision/colour_classes.hpp"
#include "vision/pixel_reader.hpp"

namespace teamsight::vision {

struct BallCandidate;

/// What one virtual sensor says of one frame.
struct SensorValue {
  std::string name;
  double value{0.0};  ///< see SensorKind in idl/config.proto; in [0, 1]
  bool triggered{false};

  friend bool operator==(const SensorValue&, const SensorValue&) = default;
};

/// Windows of the image in which certain things are expected [Lima01, section 3.3]. The windows
/// come from the camera file, because they follow from mirror and mounting. Its buffers are its
/// only state.
class VirtualSensors {
 public:
  /// Works out which pixels each window has: a grid of at most some thousand.
  VirtualSensors(const std::vector<SensorWindows>& sensors,
                 std::uint32_t width_px,
                 std::uint32_t height_px);

  /// @param balls of the same frame, for the sensors that ask where a ball is
  /// @return one value per sensor, in the order of the camera file; valid until the next call
  [[nodiscard]] std::span<const SensorValue> read(const PixelReader& pixels,
                                                  const ColourClasses& colours,
                                                  std::span<const BallCandidate> balls);

 private:
  /// A sensor's places, as indices of pixels.
  struct Places {
    std::vector<std::uint32_t> inside;
    std::vector<std::uint32_t> around;  // of kCalibration: as much again outside
    std::uint32_t wanted{0};            // bit per ColourClass
  };

  [[nodiscard]] static Places places_of(const SensorWindows& sensor,
                                        std::uint32_t width_px,
                                        std::uint32_t height_px);
  [[nodiscard]] double value_of(std::size_t sensor,
                                const PixelReader& pixels,
                                const ColourClasses& colours,
                                std::span<const BallCandidate> balls) const;

  std::vector<SensorWindows> sensors_;
  std::vector<Places> places_;
  std::vector<SensorValue> values_;
};

}  // namespace teamsight::vision
