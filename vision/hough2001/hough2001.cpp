// vision/hough2001/hough2001.cpp: transitions on circles, and the tests of a posture.
#include "vision/hough2001/hough2001.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/expect.hpp"
#include "vision/pixel_reader.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kNearest = 0.35;        // m; nearer there is the robot itself
constexpr double kStep = 0.01;           // m along a circle
constexpr double kFinestPixel = 0.005;   // m of the bird's-eye image
constexpr double kCoarsestPixel = 0.05;  // m
constexpr int kBlurred = 4;              // pixels between green and white that may be neither
constexpr double kTolerance = 0.15;      // m, outside the field that may be an error
constexpr int kGoalColumns = 5;          // points inside a goal that are asked for their colour
constexpr int kGoalRows = 3;

enum class Shade : std::uint8_t { kOther, kGreen, kWhite };

Shade shade_of(const PixelReader& pixels, const ColourClasses& colours, std::size_t pixel) {
  const ColourClass colour = colours.of(pixels.chroma(pixel));
  const bool is_bright = pixels.luminance(pixel) >= colours.white_min_y();
  if (is_bright && (colour == ColourClass::kNone || colour == ColourClass::kWhite)) {
    return Shade::kWhite;
  }
  return colour == ColourClass::kGreen && !is_bright ? Shade::kGreen : Shade::kOther;
}

double far_corner(const FieldModel& field) {
  return std::hypot(field.length, field.width);
}

}  // namespace

Hough2001::Hough2001(const CameraParameters& camera,
                     const FieldModel& field,
                     const Hough2001Parameters& parameters)
    : camera_(camera),
      model_(camera),
      field_(field),
      parameters_(parameters),
      colours_(camera.colours),
      lines_(field_lines_of(field)) {
  if (parameters_.reach <= 0.0) {
    parameters_.reach = std::min(camera.scan.max_distance, far_corner(field));
  }
  for (int circle = 1; circle <= parameters_.circles; ++circle) {
    const double radius = parameters_.reach * circle / parameters_.circles;
    if (radius >= kNearest) lay_circle(radius);
  }
  if (parameters_.pixel <= 0.0) {
    parameters_.pixel = camera_scale(RayTable(model_, camera.width_px, camera.height_px));
  }
  hough_.emplace(parameters_.pixel, parameters_.reach);
}

std::optional<std::size_t> Hough2001::pixel_at(const Point3<Robot>& p_R) const {
  const auto pixel = model_.project(p_R);
  if (!pixel) return std::nullopt;
  const auto u = std::lround(pixel->u);
  const auto v = std::lround(pixel->v);
  if (u < 0 || v < 0 || u >= static_cast<long>(camera_.width_px) ||
      v >= static_cast<long>(camera_.height_px)) {
    return std::nullopt;
  }
  const double radius = std::hypot(pixel->u - model_.centre().u, pixel->v - model_.centre().v);
  const double azimuth = std::atan2(p_R.y, p_R.x);
  const bool is_masked_out = radius < camera_.mask.inner_radius_px ||
                             radius > camera_.mask.outer_radius_px ||
                             is_masked(camera_.mask, model_.image_direction(azimuth));
  if (is_masked_out) return std::nullopt;
  return static_cast<std::size_t>(v) * camera_.width_px + static_cast<std::size_t>(u);
}

void Hough2001::lay_circle(double radius) {
  const auto steps = static_cast<int>(kTurn * radius / kStep);
  std::size_t last = 0;
  bool is_gap = true;
  for (int step = 0; step < steps; ++step) {
    const double azimuth = kTurn * step / steps;
    const Point<Robot> p_R{radius * std::cos(azimuth), radius * std::sin(azimuth)};
    const auto pixel = pixel_at({p_R.x, p_R.y, 0.0});
    if (pixel && (is_gap || *pixel != last)) {
      circle_samples_.push_back({*pixel, p_R, is_gap});
      last = *pixel;
    }
    is_gap = !pixel;
  }
}

double Hough2001::camera_scale(const RayTable& rays) const {
  double sum = 0.0;
  for (const CircleSample& sample : circle_samples_) {
    sum += static_cast<double>(rays[sample.pixel].tangential_footprint);
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, circle_samples_.size()));
  return std::clamp(sum / count, kFinestPixel, kCoarsestPixel);
}

void Hough2001::find_transitions(const ImageView& image) {
  const PixelReader pixels(image);
  transitions_.clear();
  Shade before = Shade::kOther;
  Point<Robot> edge;
  int since = 0;
  for (const CircleSample& sample : circle_samples_) {
    if (sample.is_gap) before = Shade::kOther;
    const Shade shade = shade_of(pixels, colours_, sample.pixel);
    ++since;
    if (shade == Shade::kOther) continue;
    const bool changes = before != Shade::kOther && shade != before && since <= kBlurred;
    if (changes) {
      // Between the last pixel of one colour and the first of the other.
      transitions_.push_back({0.5 * (edge.x + sample.p_R.x), 0.5 * (edge.y + sample.p_R.y)});
    }
    before = shade;
    edge = sample.p_R;
    since = 0;
  }
}

bool Hough2001::is_inside(const Pose<Field, Robot>& X_FR) const {
  return std::abs(X_FR.x() - field_.centre.x) < 0.5 * field_.length + kTolerance &&
         std::abs(X_FR.y() - field_.centre.y) < 0.5 * field_.width + kTolerance;
}

const Goal* Hough2001::nearest_goal(const Pose<Field, Robot>& X_FR) const {
  const auto distance = [&](const Goal& goal) {
    const Eigen::Vector2d middle = 0.5 * (goal.left_post.vector() + goal.right_post.vector());
    return (middle - X_FR.origin().vector()).norm();
  };
  const auto nearest = std::ranges::min_element(field_.goals, {}, distance);
  return nearest == field_.goals.end() ? nullptr : &*nearest;
}

Hough2001::GoalVote Hough2001::look_at_goal(const ImageView& image,
                                            const Pose<Field, Robot>& X_FR) const {
  const Goal* goal = nearest_goal(X_FR);
  if (goal == nullptr) return GoalVote::kUnseen;
  const bool is_blue = goal->colour == GoalColour::kBlue;
  if (!is_blue && goal->colour != GoalColour::kYellow) return GoalVote::kUnseen;
  const ColourClass own = is_blue ? ColourClass::kBlue : ColourClass::kYellow;
  const ColourClass other = is_blue ? ColourClass::kYellow : ColourClass::kBlue;
  const std::vector<ColourClass> seen = colours_in(image, *goal, X_FR);
  const auto is_most = [&](ColourClass colour) {
    return 2 * std::ranges::count(seen, colour) > std::ssize(seen);
  };
  if (is_most(own)) return GoalVote::kRight;
  if (is_most(other)) return GoalVote::kOpposite;
  if (is_most(ColourClass::kGreen)) return GoalVote::kGreen;
  return GoalVote::kUnseen;
}

std::vector<ColourClass> Hough2001::colours_in(const ImageView& image,
                                               const Goal& goal,
                                               const Pose<Field, Robot>& X_FR) const {
  const PixelReader pixels(image);
  const Eigen::Vector2d left = goal.left_post.vector();
  const Eigen::Vector2d across = goal.right_post.vector() - left;
  std::vector<ColourClass> seen;
  for (int column = 1; column <= kGoalColumns; ++column) {
    const Eigen::Vector2d foot = left + column / (kGoalColumns + 1.0) * across;
    const Point<Robot> p_R = X_FR.inverse() * Point<Field>::from(foot);
    for (int row = 1; row <= kGoalRows; ++row) {
      const auto pixel = pixel_at({p_R.x, p_R.y, goal.height * row / (kGoalRows + 1.0)});
      if (pixel) seen.push_back(colours_.of(pixels.chroma(*pixel)));
    }
  }
  return seen;
}

std::optional<Hough2001Result> Hough2001::tested(const ImageView& image,
                                                 Hough2001Result found) const {
  // The field's lines are counted from its centre.
  found.X_FR = {
      found.X_FR.x() + field_.centre.x, found.X_FR.y() + field_.centre.y, found.X_FR.theta()};
  if (!is_inside(found.X_FR)) return std::nullopt;
  const GoalVote vote = look_at_goal(image, found.X_FR);
  if (vote == GoalVote::kGreen) return std::nullopt;
  found.status = vote == GoalVote::kUnseen ? PostureStatus::kAmbiguous : PostureStatus::kOk;
  if (vote == GoalVote::kOpposite) found.X_FR = mirrored(found.X_FR, field_.centre);
  return found;
}

Hough2001Result Hough2001::locate(const ImageView& image) {
  TEAMSIGHT_EXPECT(is_whole(image));
  find_transitions(image);
  Hough2001Result best;
  best.transitions = transitions_.size();
  for (const auto& maximum : hough2001_candidates(*hough_, lines_, transitions_, parameters_)) {
    // Of equal maxima the first that the goals confirm; of maxima that no goal speaks of, the
    // first.
    const bool is_found = best.status != PostureStatus::kLost;
    if (is_found && maximum.matches < best.matches) break;
    const auto found = tested(image, maximum);
    if (!found || (is_found && found->status != PostureStatus::kOk)) continue;
    best = *found;
    best.transitions = transitions_.size();
    if (best.status == PostureStatus::kOk) break;
  }
  return best;
}

}  // namespace teamsight::vision
