// vision/hough2001/hough2001.hpp: the founding paper's self-localisation [Lima01], section 4.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/field_model.hpp"
#include "geometry/pose.hpp"
#include "geometry/sighting.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/colour_classes.hpp"
#include "vision/hough2001/field_lines.hpp"
#include "vision/hough2001/line_hough.hpp"
#include "vision/image.hpp"
#include "vision/ray_table.hpp"

namespace teamsight::vision {

/// The paper's numbers; its bird's-eye scale of 6.95 mm per pixel belongs to a mirror it does not
/// describe, so the scale comes from the camera.
struct Hough2001Parameters {
  int circles{36};             ///< on which transitions are looked for
  std::size_t lines{6};        ///< q, and n
  int columns{3};              ///< half degrees to each side in steps 7 and 8
  double reach{0.0};           ///< m; 0: as far as the camera's scan pattern looks
  double pixel{0.0};           ///< m per pixel of the bird's-eye image; 0: from the camera
  double same_distance{0.12};  ///< m between an image line and the field line that it matches
  int maxima{12};              ///< of the correlation that are tried, the best first
};

/// What the method says of one image.
struct Hough2001Result {
  /// kOk: the goals' colours agree; kAmbiguous: they are not seen, or not coloured, so the mirror
  /// image is as good; kLost: no maximum of the correlation stands the tests.
  PostureStatus status{PostureStatus::kLost};
  Pose<Field, Robot> X_FR;
  std::size_t transitions{0};  ///< pixels of step 1
  int matches{0};              ///< image lines that met field lines, both directions together
  int maximum{0};              ///< which maximum it was; 0 the first
};

/// Steps 7 and 8 on transition points alone, without an image to ask for colours.
///
/// @return the candidates, by matches and votes, best first; each up to half a turn
[[nodiscard]] std::vector<Hough2001Result> hough2001_candidates(
    LineHough& hough,
    const FieldLines& lines,
    std::span<const Point<Robot>> transitions,
    const Hough2001Parameters& parameters);

/// Finds the robot in single images. Tables and buffers are the only state.
class Hough2001 {
 public:
  /// @pre the parameters were checked by settings/
  Hough2001(const CameraParameters& camera,
            const FieldModel& field,
            const Hough2001Parameters& parameters = {});

  /// @pre the image has the camera's size and format, and is whole
  [[nodiscard]] Hough2001Result locate(const ImageView& image);

  /// Step 1, for drawings and tests; valid until the next call of `locate`.
  [[nodiscard]] std::span<const Point<Robot>> transitions() const { return transitions_; }

 private:
  struct CircleSample {
    std::size_t pixel{0};
    Point<Robot> p_R;
    bool is_gap{false};  ///< the pixels before this one are masked
  };

  enum class GoalVote : std::uint8_t { kUnseen, kRight, kOpposite, kGreen };

  /// The pixel that shows a point, if the picture and the mask have it.
  [[nodiscard]] std::optional<std::size_t> pixel_at(const Point3<Robot>& p_R) const;
  void lay_circle(double radius);
  /// m of floor per pixel, in the mean over the circles.
  [[nodiscard]] double camera_scale(const RayTable& rays) const;
  [[nodiscard]] const Goal* nearest_goal(const Pose<Field, Robot>& X_FR) const;
  void find_transitions(const ImageView& image);
  /// What the goal that is nearest under this posture says of it.
  [[nodiscard]] GoalVote look_at_goal(const ImageView& image, const Pose<Field, Robot>& X_FR) const;
  [[nodiscard]] std::vector<ColourClass> colours_in(const ImageView& image,
                                                    const Goal& goal,
                                                    const Pose<Field, Robot>& X_FR) const;
  [[nodiscard]] bool is_inside(const Pose<Field, Robot>& X_FR) const;
  /// A maximum after the paper's two tests, in the field's frame; nothing if it fails one.
  [[nodiscard]] std::optional<Hough2001Result> tested(const ImageView& image,
                                                      Hough2001Result found) const;

  CameraParameters camera_;
  CameraModel model_;
  FieldModel field_;
  Hough2001Parameters parameters_;
  ColourClasses colours_;
  FieldLines lines_;
  std::vector<CircleSample> circle_samples_;
  std::vector<Point<Robot>> transitions_;
  std::optional<LineHough> hough_;
};

}  // namespace teamsight::vision
