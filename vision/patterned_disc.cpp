// vision/patterned_disc.cpp: the star from a place, its disc, and what the disc shows.
#include "vision/patterned_disc.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "vision/carpet_star.hpp"

namespace teamsight::vision {

namespace {

constexpr double kReach = 2.2;            // expected radii, within which the carpet must begin
constexpr int kMostSteps = 160;           // px; more than the largest ball
constexpr std::size_t kFirstStride = 3;   // directions, of those that are looked out in first
constexpr std::size_t kMostOpen = 4;      // of those: half
constexpr double kAtEdge = 0.3;           // of the radius; farther off is no edge of the disc
constexpr double kFront = 0.7;            // cosine of the angle to the way to the robot
constexpr std::size_t kFewestBehind = 8;  // open directions of the far half
constexpr double kSure = 0.9;   // where half an edge must do: robots with white markers look alike
constexpr double kInner = 0.7;  // of the radius: within, colours are the disc's own
constexpr int kGrid = 6;        // points from the middle to there
constexpr std::size_t kMostPoints = (2 * kGrid + 1) * (2 * kGrid + 1);
constexpr int kShadeRounds = 3;         // the first looks at all points
constexpr double kShaded = 0.85;        // of the white's shade; darker is not of the white
constexpr double kBlurred = 0.75;       // of the white's shade; darker is black, blurred
constexpr double kSmallest = 0.5;       // of the expected radius
constexpr double kLargest = 2.0;        // of the expected radius
constexpr double kLeastMixture = 0.06;  // of the second colour: most of one panel of a football
constexpr double kMostScatter = 0.3;    // of the radius
constexpr double kSharp = 8.0;      // px of radius; in smaller balls panels blur into each other
constexpr int kLookGrid = 3;        // points from the place to where the first look ends
constexpr double kLookReach = 0.8;  // of the expected radius: there

using Shares = std::array<double, kColourClasses>;

// Nothing where own body and mirror hide the world, and outside the image.
std::optional<std::size_t> index_of(const PatternPlace& place, const Pixel& at) {
  const double u = at.u + 0.5;  // so that what is cut off is the nearest pixel
  const double v = at.v + 0.5;
  const RayTable& rays = place.frame.rays;
  if (u < 0.0 || v < 0.0 || u >= rays.width() || v >= rays.height()) return std::nullopt;
  const auto i = static_cast<std::size_t>(v) * rays.width() + static_cast<std::size_t>(u);
  return place.solid_angle[i] > 0.0F ? std::optional(i) : std::nullopt;
}

ColourClass look_at(const PatternPlace& place, std::size_t pixel) {
  const PixelReader& pixels = place.frame.pixels;
  const std::uint8_t y = pixels.luminance(pixel);
  return place.pattern.look(
      y, place.frame.colours.chromatic(y, pixels.chroma(pixel)), place.carpet);
}

// Of the ball's colours the one that a place shows; kNone: none of them.
ColourClass own_colour_at(const PatternPlace& place, const Pixel& at) {
  const auto pixel = index_of(place, at);
  const ColourClass colour = pixel ? look_at(place, *pixel) : ColourClass::kNone;
  return place.pattern.has(colour) ? colour : ColourClass::kNone;
}

// Whether a coarse grid about the place shows a second of the ball's colours. A line, which leaves
// as high a gap in the carpet where it runs towards the robot, shows one.
bool may_be_of_two(const PatternPlace& place, double radius_px) {
  if (radius_px < kSharp) return true;
  const double step = radius_px * kLookReach / kLookGrid;
  ColourClass first = ColourClass::kNone;
  for (int row = -kLookGrid; row <= kLookGrid; ++row) {
    for (int column = -kLookGrid; column <= kLookGrid; ++column) {
      if (row * row + column * column > kLookGrid * kLookGrid) continue;
      const ColourClass colour =
          own_colour_at(place, {place.pixel.u + step * column, place.pixel.v + step * row});
      if (colour == ColourClass::kNone || colour == first) continue;
      if (first != ColourClass::kNone) return true;
      first = colour;
    }
  }
  return false;
}

/// One direction's end, and how far it is.
struct End {
  StarEnd kind{StarEnd::kOpen};
  double steps{0.0};  // px
};

// How many steps stay within the image.
int steps_inside(const RayTable& rays, const Pixel& from, const Eigen::Vector2d& step, int most) {
  const auto along = [](double at, double way, double size) {
    if (way > 0.0) return (size - 1.0 - at) / way;
    return way < 0.0 ? -at / way : std::numeric_limits<double>::infinity();
  };
  const double inside =
      std::min(along(from.u, step.x(), rays.width()), along(from.v, step.y(), rays.height()));
  return static_cast<int>(std::clamp(inside, 0.0, static_cast<double>(most)));
}

// Two pixels of carpet in a row: a single one is noise.
End walk(const PatternPlace& place, const Pixel& from, const Eigen::Vector2d& step, int most) {
  const int inside = steps_inside(place.frame.rays, from, step, most);
  const std::size_t width = place.frame.rays.width();
  bool was_carpet = false;
  double u = from.u + 0.5;  // so that what is cut off is the nearest pixel
  double v = from.v + 0.5;
  for (int i = 1; i <= inside; ++i) {
    u += step.x();
    v += step.y();
    const std::size_t pixel = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
    if (place.solid_angle[pixel] <= 0.0F) return {StarEnd::kHidden, 0.0};
    const bool is_carpet = look_at(place, pixel) == ColourClass::kGreen;
    // The edge lies between the first of the two and the pixel before it.
    if (is_carpet && was_carpet) return {StarEnd::kCarpet, i - 1.5};
    was_carpet = is_carpet;
  }
  return {inside < most ? StarEnd::kHidden : StarEnd::kOpen, 0.0};
}

// The i-th direction of a star.
void look_out(const PatternPlace& place,
              const LocalView& view,
              double expected,
              std::size_t i,
              CarpetStar& star) {
  const Eigen::Vector2d& direction = star_direction(i);
  const Eigen::Vector2d way = view.to_pixels * direction;  // of a radian
  const double pixels = way.norm();
  const int most = std::min(kMostSteps, static_cast<int>(std::ceil(kReach * expected * pixels)));
  const End end = walk(place, view.middle, way / pixels, most + 1);
  star.ends[i] = end.kind;
  star.places[i] = direction * (end.steps / pixels);
}

// Towards the robot, in angles; unit length.
Eigen::Vector2d way_to_robot(const PatternPlace& place, const LocalView& view) {
  const Eigen::Vector2d way(place.centre.u - view.middle.u, place.centre.v - view.middle.v);
  return (view.to_angles * way).normalized();
}

bool is_behind(std::size_t direction, const Eigen::Vector2d& towards_robot) {
  return star_direction(direction).dot(towards_robot) < 0.0;
}

// Where something stands right behind it, what the far side shows is not the ball's edge.
//
// @return whether that is so
bool hide_behind(const Eigen::Vector2d& towards_robot, CarpetStar& star) {
  std::size_t open = 0;
  for (std::size_t i = 0; i < kStarDirections; ++i) {
    if (star.ends[i] == StarEnd::kOpen && is_behind(i, towards_robot)) ++open;
  }
  if (open < kFewestBehind) return false;
  for (std::size_t i = 0; i < kStarDirections; ++i) {
    if (is_behind(i, towards_robot)) star.ends[i] = StarEnd::kHidden;
  }
  return true;
}

/// What surrounds a place.
struct Surroundings {
  CarpetStar star;
  bool is_backed{false};  // something stands right behind it; the far side is left out
};

// Nothing where most directions lead into a robot, a wall, along a line: some of them tell that.
std::optional<Surroundings> surroundings_of(const PatternPlace& place,
                                            const LocalView& view,
                                            double expected) {
  CarpetStar star;
  std::size_t open = 0;
  for (std::size_t i = 0; i < kStarDirections; i += kFirstStride) {
    look_out(place, view, expected, i, star);
    if (star.ends[i] == StarEnd::kOpen) ++open;
  }
  if (open > kMostOpen) return std::nullopt;
  for (std::size_t i = 0; i < kStarDirections; ++i) {
    if (i % kFirstStride != 0) look_out(place, view, expected, i, star);
  }
  // Small ones are told by their whole edge or not at all.
  const bool is_sharp = expected * std::sqrt(view.to_pixels.determinant()) >= kSharp;
  const bool is_backed = is_sharp && hide_behind(way_to_robot(place, view), star);
  return Surroundings{star, is_backed};
}

bool may_be_ball(const StarDisc& disc, double expected) {
  return disc.scatter <= kMostScatter && disc.radius >= kSmallest * expected &&
         disc.radius <= kLargest * expected;
}

double share(double count, double of) {
  return of > 0.0 ? count / of : 0.0;
}

// How much of the disc's edge is carpet, and of that towards the robot.
void measure_edge(const CarpetStar& star,
                  const StarDisc& disc,
                  const Eigen::Vector2d& towards_robot,
                  PatternTraits& traits) {
  double seen = 0.0;
  double carpet = 0.0;
  double front = 0.0;
  double front_carpet = 0.0;
  for (std::size_t i = 0; i < kStarDirections; ++i) {
    if (star.ends[i] == StarEnd::kHidden) continue;
    const double off = (star.places[i] - disc.middle).norm() - disc.radius;
    const bool is_edge = star.ends[i] == StarEnd::kCarpet && std::abs(off) <= kAtEdge * disc.radius;
    const bool is_front = star_direction(i).dot(towards_robot) > kFront;
    seen += 1.0;
    carpet += is_edge ? 1.0 : 0.0;
    front += is_front ? 1.0 : 0.0;
    front_carpet += is_front && is_edge ? 1.0 : 0.0;
  }
  traits[3] = share(carpet, seen);
  // The own body may hide it: then that says nothing.
  traits[4] = front > 0.0 ? front_carpet / front : 0.5;
}

/// One point of a disc.
struct Point {
  Eigen::Vector3d place;  // in the disc, in its radius, and 1
  double luminance{0.0};
  ColourClass colour{ColourClass::kNone};
};

/// What a grid of points shows.
struct Sampled {
  std::array<Point, kMostPoints> points;
  std::size_t count{0};
};

Sampled sampled_in(const PatternPlace& place, const LocalView& view, double radius) {
  Sampled all;
  for (int row = -kGrid; row <= kGrid; ++row) {
    for (int column = -kGrid; column <= kGrid; ++column) {
      if (row * row + column * column > kGrid * kGrid) continue;
      const Eigen::Vector2d at = Eigen::Vector2d(column, row) * (kInner / kGrid);
      const auto pixel = index_of(place, view.pixel(radius * at));
      if (!pixel) continue;
      all.points[all.count++] = {{at.x(), at.y(), 1.0},
                                 static_cast<double>(place.frame.pixels.luminance(*pixel)),
                                 look_at(place, *pixel)};
    }
  }
  return all;
}

// Far away the black of a ball is blurred into its white: it is what is darker than the shade of
// the white, which goes evenly over the ball.
void darken(Sampled& all) {
  const auto is_grey = [](const Point& point) {
    return point.colour == ColourClass::kWhite || point.colour == ColourClass::kBlack ||
           point.colour == ColourClass::kNone;
  };
  Eigen::Vector3d shade = Eigen::Vector3d::Zero();
  for (int round = 0; round < kShadeRounds; ++round) {
    Eigen::Matrix3d normal = 1e-6 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < all.count; ++i) {
      const Point& point = all.points[i];
      if (!is_grey(point) || point.luminance < kShaded * shade.dot(point.place)) continue;
      normal += point.place * point.place.transpose();
      sum += point.luminance * point.place;
    }
    shade = normal.ldlt().solve(sum);
  }
  for (std::size_t i = 0; i < all.count; ++i) {
    Point& point = all.points[i];
    if (is_grey(point) && point.luminance < kBlurred * shade.dot(point.place)) {
      point.colour = ColourClass::kBlack;
    }
  }
}

Shares shares_in(const PatternPlace& place, const LocalView& view, double radius) {
  Sampled all = sampled_in(place, view, radius);
  if (place.pattern.has(ColourClass::kWhite) && place.pattern.has(ColourClass::kBlack)) {
    darken(all);
  }
  Shares shares{};
  for (std::size_t i = 0; i < all.count; ++i) {
    shares[static_cast<std::size_t>(all.points[i].colour)] += 1.0 / static_cast<double>(all.count);
  }
  return shares;
}

void measure_colours(const Shares& shares, const BallPattern& pattern, PatternTraits& traits) {
  double first = 0.0;
  double second = 0.0;
  double own = 0.0;
  for (std::size_t i = 0; i < kColourClasses; ++i) {
    const auto colour = static_cast<ColourClass>(i);
    if (colour == ColourClass::kNone || !pattern.has(colour)) continue;
    own += shares[i];
    second = std::max(second, std::min(first, shares[i]));
    first = std::max(first, shares[i]);
  }
  const double between = shares[static_cast<std::size_t>(ColourClass::kNone)];
  traits[5] = std::max(0.0, 1.0 - own - between);
  traits[6] = std::min(second, kMostMixture);
  traits[7] = between;
}

}  // namespace

double angular_radius_at(const PixelRay& ray, double ball_radius) {
  const double down = -static_cast<double>(ray.direction_z);
  const double height = static_cast<double>(ray.origin_z) - ball_radius;
  return down > 0.0 && height > 0.0 ? ball_radius * down / height : 0.0;
}

namespace {

/// What is seen around a pixel that may lie on a ball.
struct Look {
  LocalView view;
  double expected{0.0};  // angular radius of a ball there, rad
  Surroundings around;
  StarDisc disc;
};

/// @param span  pixels to either side by which the view's scale is told
std::optional<Look> look_from(const PatternPlace& place, const Pixel& pixel, double span) {
  const auto index = index_of(place, pixel);
  if (!index) return std::nullopt;
  const double expected = angular_radius_at(place.frame.rays[*index], place.ball_radius);
  const auto view = view_around(place.frame.rays, pixel, span);
  if (expected <= 0.0 || !view) return std::nullopt;
  const auto around = surroundings_of(place, *view, expected);
  const auto disc = around ? disc_in(around->star, expected) : std::nullopt;
  if (!disc) return std::nullopt;
  return Look{*view, expected, *around, *disc};
}

/// What the disc is taken for; nothing: hardly a ball.
std::optional<PatternedDisc> judged(const PatternPlace& place, const Look& look) {
  PatternedDisc found;
  measure_edge(look.around.star, look.disc, way_to_robot(place, look.view), found.traits);
  const double size = std::log(look.disc.radius / look.expected);
  found.traits[0] = std::pow(std::min(0.0, size), 2);
  found.traits[1] = std::pow(std::max(0.0, size), 2);
  found.traits[2] = look.disc.scatter;
  const double least =
      look.around.is_backed ? std::max(kSure, place.model.least) : place.model.least;
  if (most_probable(place.model, found.traits) < least) return std::nullopt;
  found.view = look.view;
  found.view.middle = look.view.pixel(look.disc.middle);
  found.radius = look.disc.radius;
  measure_colours(shares_in(place, found.view, found.radius), place.pattern, found.traits);
  found.probability = probability(place.model, found.traits);
  if (found.traits[6] < kLeastMixture || found.probability < least) return std::nullopt;
  return found;
}

}  // namespace

std::optional<PatternedDisc> disc_around(const PatternPlace& place) {
  const auto start = index_of(place, place.pixel);
  if (!start) return std::nullopt;
  const double expected = angular_radius_at(place.frame.rays[*start], place.ball_radius);
  const double radius_px = expected / std::sqrt(static_cast<double>(place.solid_angle[*start]));
  if (!may_be_of_two(place, radius_px)) return std::nullopt;
  // From somewhere within to about the middle.
  const auto first = look_from(place, place.pixel, 0.5 * radius_px);
  if (!first) return std::nullopt;
  const auto look = look_from(place, first->view.pixel(first->disc.middle), 0.5 * radius_px);
  if (!look || !may_be_ball(look->disc, look->expected)) return std::nullopt;
  return judged(place, *look);
}

}  // namespace teamsight::vision
