// vision/colour_classes.hpp: the class of a colour, by one look-up in a table or by three planes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "vision/camera_parameters.hpp"
#include "vision/colour_cube.hpp"
#include "vision/light_gains.hpp"
#include "vision/pixel_reader.hpp"

namespace teamsight::vision {

/// Colours cut into classes, by the camera's method: a trained table over luminance and chroma; the
/// nearest vertex of the RGB cube; or the chroma plane is cut, each place belonging to the nearest
/// sample whose disc holds it, else to the first hue sector that does.
///
/// In another light colours are first taken back to the one that the classes were made for.
class ColourClasses {
 public:
  explicit ColourClasses(const ColourParameters& parameters);

  /// From now on the light is this one.
  ///
  /// @pre all gains are positive
  void adapt(const LightGains& gains);

  /// Whether colours must be restored: the light is not the camera file's.
  [[nodiscard]] bool is_adapted() const { return is_adapted_; }

  /// What the camera file's light would have made of a colour; itself unless adapted.
  [[nodiscard]] SampledColour restored(std::uint8_t y, Chroma chroma) const {
    if (!is_adapted_) return {y, chroma.u, chroma.v};
    const int du = chroma.u - 128;
    const int dv = chroma.v - 128;
    if (has_no_room(y, du, dv)) return restored_glare(y, du, dv);
    const auto row = [&](const std::array<int, 3>& weights, int offset) {
      const int value = (weights[0] * y + weights[1] * du + weights[2] * dv + kHalf) >> kShift;
      return static_cast<std::uint8_t>(std::clamp(value + offset, 0, 255));
    };
    return {row(back_[0], 0), row(back_[1], 128), row(back_[2], 128)};
  }

  /// The class of a restored colour; kNone where it has none, as black, grey and white.
  [[nodiscard]] ColourClass of(const SampledColour& colour) const {
    if (has_table_) return trained_[class_cell(colour)];
    return cube_ ? vertex_colours_[cube_->vertex(colour)] : of(Chroma{colour.u, colour.v});
  }

  /// The same of many colours, one class for each.
  void classify(std::span<const std::uint8_t> luminance,
                std::span<const Chroma> chroma,
                std::span<ColourClass> classes) const;

  /// The same of a colour as the camera shows it.
  [[nodiscard]] ColourClass chromatic(std::uint8_t y, Chroma chroma) const {
    return of(restored(y, chroma));
  }

  /// By samples and sectors alone, in the camera file's light.
  [[nodiscard]] ColourClass of(Chroma chroma) const { return table_[cell_of(chroma)]; }

  /// As `chromatic`, and where that is no colour: kBlack, kWhite or kNone, by luminance, or by the
  /// cube's own black and white vertex.
  [[nodiscard]] ColourClass of(std::uint8_t y, Chroma chroma) const {
    const SampledColour colour = restored(y, chroma);
    if (cube_) return vertex_classes_[cube_->vertex(colour)];
    const ColourClass known = of(colour);
    if (known != ColourClass::kNone) return known;
    if (colour.y <= black_max_y_) return ColourClass::kBlack;
    return colour.y >= white_min_y_ ? ColourClass::kWhite : ColourClass::kNone;
  }

  [[nodiscard]] std::uint8_t white_min_y() const { return white_min_y_; }

  [[nodiscard]] std::uint8_t black_max_y() const { return black_max_y_; }

  /// How much brighter the light is than the camera file's.
  [[nodiscard]] float exposure() const { return exposure_; }

 private:
  // Whether red, green or blue is as bright as can be shown; the factors are those of `rgb_of`.
  [[nodiscard]] static bool has_no_room(int y, int du, int dv) {
    constexpr int kMost = kBrightest * 256;
    const int grey = 256 * y;
    return grey + 359 * dv > kMost || grey + 454 * du > kMost || grey - 88 * du - 183 * dv > kMost;
  }

  // What is as bright as can be shown may be brighter: as little colour as that leaves open.
  [[nodiscard]] SampledColour restored_glare(int y, int du, int dv) const;

  // As the two bytes lie in memory: one load.
  [[nodiscard]] static std::size_t cell_of(Chroma chroma) {
    return std::size_t{chroma.v} << 8U | chroma.u;
  }

  static constexpr int kBrightest = 250;  // grey levels; as good as the brightest that is shown
  static constexpr int kShift = 14;
  static constexpr int kHalf = 1 << (kShift - 1);

  std::array<ColourClass, std::size_t{256} * 256> table_{};
  ClassTable trained_;
  bool has_table_;
  std::optional<ColourCube> cube_;  // nothing: another method
  std::array<ColourClass, 8> vertex_classes_{};
  std::array<ColourClass, 8> vertex_colours_{};  // kNone where that is black or white
  bool is_adapted_{false};
  float exposure_{1.0F};
  LightGains gains_;
  std::array<std::array<int, 3>, 3> back_{};  // fixed point: (y, u, v) to the file's light
  std::uint8_t white_min_y_;
  std::uint8_t black_max_y_;
};

}  // namespace teamsight::vision
