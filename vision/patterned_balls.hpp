// vision/patterned_balls.hpp: balls of several colours on the carpet.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "vision/ball_pattern.hpp"
#include "vision/frame_tables.hpp"
#include "vision/patterned_disc.hpp"

namespace teamsight::vision {

/// What a patterned ball may look like.
struct PatternRules {
  double ball_radius{0.11};  ///< m
  std::vector<ColourClass> classes;
  PatternModel model{trained_pattern_model()};
};

/// Looks for patterned balls: where a radial line shows two of the ball's colours within a ball's
/// size and without carpet between them, or is without carpet for a ball's height, there may be
/// one, if a disc of about its size and of at least two of its colours is there. A crossing of
/// lines, a robot or a wall leaves none. In the further parts of a mirror of several nothing is
/// looked for. Its buffers are its only state.
class PatternedBalls {
 public:
  /// @param centre  of the mirror in the image
  PatternedBalls(const PatternRules& rules, const Pixel& centre);

  /// Whether there is a pattern to look for.
  [[nodiscard]] bool is_any() const { return pattern_.is_any(); }

  /// @param solid_angle  of each pixel; 0 where own body and mirror hide the world
  /// @pre lines and rays are those of the first call
  /// @return none within another; as probable as the model asks for; valid until the next call
  [[nodiscard]] std::span<const PatternedDisc> find(const FrameTables& frame,
                                                    std::span<const float> solid_angle);

 private:
  /// A part of a radial line.
  struct Stretch {
    std::size_t line{0};
    std::size_t from{0};  // samples
    std::size_t to{0};
  };

  void look_along(const FrameTables& frame,
                  std::span<const float> solid_angle,
                  std::size_t radial_line);
  /// Which of the ball's a sample shows; kNone: none of them.
  [[nodiscard]] ColourClass own_class(ColourClass chromatic, Surface surface) const;
  /// Of all samples, once.
  void measure_radii(const FrameTables& frame, std::span<const float> solid_angle);
  /// Between two samples of a radial line, in radii of a ball on the floor there.
  [[nodiscard]] float apart(const ScanRange& range, std::size_t from, std::size_t to) const;
  /// Looks at a stretch between carpet and carpet in which one of the ball's colours is, if it is
  /// as high as a ball.
  void look_at_whole(const FrameTables& frame,
                     std::span<const float> solid_angle,
                     const Stretch& stretch);
  /// Whether two samples of its colours may be one ball's that stands on the carpet.
  [[nodiscard]] bool is_near(const ScanRange& range,
                             std::size_t first,
                             std::size_t bare_from,
                             std::size_t second) const;
  /// Whether there is a ball around the middle.
  /// @pre a ball on the floor can be seen there
  void look_at(const FrameTables& frame,
               std::span<const float> solid_angle,
               const Stretch& stretch);
  void keep(const PatternedDisc& disc);

  PatternRules rules_;
  BallPattern pattern_;
  /// own_class, by colour class and surface.
  std::array<std::array<ColourClass, kSurfaces>, kColourClasses> own_{};
  Pixel centre_;
  /// Of a ball on the floor that is seen at a sample, by its place in the list; 0: none can be.
  std::vector<float> radius_px_;
  std::vector<Pixel> tried_;
  std::vector<PatternedDisc> found_;
};

}  // namespace teamsight::vision
