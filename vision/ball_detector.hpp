// vision/ball_detector.hpp: blobs of the ball's colour, and patterned discs, as rays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/sighting.hpp"
#include "vision/ball_blob.hpp"
#include "vision/ball_model.hpp"
#include "vision/ball_traits.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/frame_tables.hpp"
#include "vision/mirror_parts.hpp"
#include "vision/patterned_balls.hpp"

namespace teamsight::vision {

/// Where a frame's image shows a ball candidate; the pixel side of a BallRay.
struct BallPixels {
  double u_px{0.0};
  double v_px{0.0};
  double r_px{0.0};  ///< radius of the disc of the same area
  BallTraits traits{};
  PatternTraits pattern{};  ///< of a patterned one; else all 0
  /// Its middle lies within the convex hull of the carpet that is seen.
  bool on_carpet{true};
  /// Which part of a mirror of several shows it; 0: the inner one.
  std::uint8_t mirror_part{0};

  friend bool operator==(const BallPixels&, const BallPixels&) = default;
};

/// A ball candidate on both sides of the lens.
struct BallCandidate {
  BallRay ray;
  BallPixels pixels;
};

/// What a ball may look like.
struct BallRules {
  double ball_radius{0.11};  ///< m
  BallModel model{trained_ball_model()};
  std::size_t most{kMaxBallRays};      ///< reported, of one frame
  std::vector<ColourClass> pattern{};  ///< of a ball of several colours; empty: there is none
  PatternModel pattern_model{trained_pattern_model()};
};

/// Grows blobs of ball-coloured pixels from seeds on the radial scan lines, joins the parts of one
/// ball, and keeps what is a ball by its traits. In the further parts of a mirror of several, where
/// no radial lines run, it looks for seeds itself; one ball's images in two parts become one. Where
/// the rules name a pattern, balls of that are found as well (`PatternedBalls`), and what has the
/// ball's colour within one of them is a part of it. Its buffers are its only state.
class BallDetector {
 public:
  BallDetector(const RayTable& rays, const Mask& mask, const Pixel& centre, const BallRules& rules);

  /// @return best first, at most as many as the rules say; valid until the next call
  [[nodiscard]] std::span<const BallCandidate> find(const FrameTables& frame);

 private:
  void find_seeds(const RayTable& rays);
  void seed_from(const FrameTables& frame, std::size_t radial_line);
  void seed_from_further_parts(const FrameTables& frame);
  void start_from(const FrameTables& frame, std::size_t pixel);
  /// All that hangs together with the seed; `belongs` is asked once or more of each pixel, and
  /// marks those that it takes.
  template <class Belongs>
  [[nodiscard]] BallBlob grow(const FrameTables& frame, std::size_t seed, Belongs belongs);
  void add(const FrameTables& frame, std::size_t pixel, BallBlob& blob) const;
  /// Of the blob that was grown last.
  [[nodiscard]] BallOutline outline_of(const RayTable& rays) const;
  /// The same of those of its pixels beyond that angle from an axis.
  [[nodiscard]] BallOutline outline_beyond(const RayTable& rays,
                                           const Eigen::Vector3d& axis,
                                           double angle) const;
  [[nodiscard]] BallBlob grow_of_class(const FrameTables& frame, std::size_t seed);
  /// Of a blob that is larger than a ball can be there, what has at least half of the colour that
  /// its part nearest to the seed, and so to the robot, has: what is behind a ball is paler.
  [[nodiscard]] BallBlob grow_ball(const FrameTables& frame, std::size_t seed);

  [[nodiscard]] bool is_taken(std::size_t pixel) const {
    return visited_[pixel] == frame_ || visited_[pixel] == frame_ + 1;
  }

  /// Of one ball, on both sides of a strut, a hand or the mirror's seam.
  [[nodiscard]] bool are_parts(const RayTable& rays, const BallBlob& a, const BallBlob& b) const;
  void join_parts(const RayTable& rays);
  [[nodiscard]] BallTraits traits_in(const FrameTables& frame, const BallBlob& blob) const;
  /// @pre the blob has pixels that see something
  [[nodiscard]] BallCandidate candidate_of(const FrameTables& frame, const BallBlob& blob) const;
  void judge(const FrameTables& frame, const BallBlob& blob);
  [[nodiscard]] BallBlob blob_of(const FrameTables& frame, const PatternedDisc& disc) const;
  void find_patterned(const FrameTables& frame);

  Pixel centre_;
  BallRules rules_;
  MirrorParts parts_;
  double near_px_{0.0};  // from the image centre, to where a ball may touch the own body
  std::uint32_t frame_{0};
  std::vector<float> solid_angle_;  // of each pixel; 0 where the mask or the mirror ends
  /// The frame in which a pixel was last taken for a blob; one more: for what was left of it.
  std::vector<std::uint32_t> visited_;
  std::vector<std::size_t> seeds_;  // in the mirror's further parts: where a blob may be met
  std::vector<std::size_t> open_;
  std::vector<BallBlob> blobs_;
  PatternedBalls patterned_;
  std::vector<BallCandidate> found_;
};

}  // namespace teamsight::vision
