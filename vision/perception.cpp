// vision/perception.cpp: the steps of one frame, in order.
#include "vision/perception.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/expect.hpp"
#include "vision/carpet_hull.hpp"
#include "vision/colour_classes.hpp"
#include "vision/field_colours.hpp"
#include "vision/light.hpp"
#include "vision/line_finder.hpp"
#include "vision/pixel_reader.hpp"
#include "vision/radial_scan.hpp"
#include "vision/ray_table.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

namespace {

constexpr float kLeastCarpet = 0.03F;     // of the samples
constexpr double kOffCarpetMargin = 0.3;  // m; nearer to the carpet's edge things are walls
constexpr double kSigmaTilt = 0.0052;     // rad; 0.3 degrees
constexpr std::size_t kFloorStride = 3;   // samples; thousands are left

std::optional<FrameReject> reject_of(const ImageView& image, const CameraParameters& camera) {
  if (image.format != camera.format) return FrameReject::kWrongFormat;
  if (image.width_px != camera.width_px || image.height_px != camera.height_px) {
    return FrameReject::kWrongSize;
  }
  return is_whole(image) ? std::nullopt : std::optional(FrameReject::kTruncated);
}

// Whether an obstacle of this frame stands well inside the carpet; unknown counts as yes.
bool is_on_field(const ObstacleCandidate& obstacle,
                 const PostureEstimate& posture,
                 const FieldModel& field) {
  if (posture.status == PostureStatus::kLost) return true;
  const Point<Field> p_FO = posture.X_FR * obstacle.sighting.p_RO;
  const Eigen::Vector2d offset = (p_FO.vector() - field.centre.vector()).cwiseAbs();
  const double beyond = field.surround - kOffCarpetMargin;
  return offset.x() < 0.5 * field.length + beyond && offset.y() < 0.5 * field.width + beyond;
}

// Where the camera looks from, and how far a robot that stands or drives gently leans.
HeadTilt head_of(const RayTable& rays) {
  HeadTilt head;
  head.eye_height = eye_height(rays).value_or(head.eye_height);
  head.sigma = Eigen::Vector2d::Constant(kSigmaTilt);
  return head;
}

}  // namespace

struct Perception::Tables {
  Tables(const CameraParameters& parameters,
         const FieldModel& field,
         const PerceptionParameters& perception)
      : camera(parameters),
        model(parameters),
        rays(model, parameters.width_px, parameters.height_px),
        colours(parameters.colours),
        lines(parameters, model, rays),
        scan(lines, parameters.scan.chroma_window),
        hull(lines),
        finder(lines.longest_px(), {field.line_width, parameters.scan.min_contrast}),
        balls(rays,
              parameters.mask,
              model.centre(),
              {perception.ball_radius,
               perception.balls,
               perception.most_balls,
               parameters.colours.pattern,
               perception.patterned}),
        obstacles({perception.robot_radius, perception.obstacles, perception.shirts}, lines, model),
        ball_rules{perception.ball_radius, kSigmaTilt},
        head(head_of(rays)),
        goals(lines, model),
        sensors(parameters.sensors, parameters.width_px, parameters.height_px),
        posture(field, head) {
    profile.reserve(lines.longest());
    observation.line_points.reserve(kMaxLinePoints);
    observation.line_residuals.reserve(kMaxLinePoints);
    observation.line_fits.reserve(kMaxLinePoints);
  }

  void find_lines(const PixelReader& pixels);
  void find_goals();
  void locate(const PostureSource& posture_of);
  void find_balls(const PixelReader& pixels);
  void find_obstacles();

  CameraParameters camera;
  CameraModel model;
  RayTable rays;
  ColourClasses colours;
  ScanLines lines;
  RadialScan scan;
  CarpetHull hull;
  LineFinder finder;
  BallDetector balls;
  ObstacleDetector obstacles;
  BallRangeRules ball_rules;
  HeadTilt head;
  GoalDetector goals;
  VirtualSensors sensors;
  PostureEstimator posture;
  std::vector<std::uint8_t> profile;
  FieldColourMeter field_meter;
  std::vector<SampledColour> floor;
  FrameObservation observation;
};

void Perception::Tables::find_lines(const PixelReader& pixels) {
  auto& points = observation.line_points;
  points.clear();
  LightMeter meter;
  scan.read(pixels, colours, lines);
  hull.measure(scan, lines);
  for (const ScanRange& range : lines.radial()) {
    const auto luminance = scan.luminance(range);
    meter.add(luminance);
    finder.find({pixels, colours},
                {lines.samples(range), lines.close_taps(range), luminance, range.pitch},
                points);
  }
  for (const ScanRange& range : lines.circular()) {
    const auto taps = lines.taps(range);
    profile.resize(taps.size());
    read_luminance(pixels, taps, profile);
    finder.find({pixels, colours},
                {lines.samples(range), lines.close_taps(range), profile, range.pitch},
                points);
  }
  observation.light = meter.light();
  // Well lit, but not a field.
  if (observation.light == Light::kGood && scan.carpet().share < kLeastCarpet) {
    observation.light = Light::kUnknown;
  }
  observation.carpet = scan.carpet();
}

void Perception::Tables::find_goals() {
  const auto found = goals.find(scan, lines);
  observation.goals.assign(found.begin(), found.end());
}

void Perception::Tables::locate(const PostureSource& posture_of) {
  const PostureResult result = posture_of({observation.line_points, observation.goals});
  observation.posture = result.estimate;
  observation.searched_globally = result.searched_globally;
  observation.line_residuals.clear();
  observation.line_fits.clear();
  observation.drift = {};
  if (result.estimate.status == PostureStatus::kLost) return;
  const PostureResiduals residuals(
      posture.map(), result.estimate.X_FR, result.tilt, head.eye_height);
  for (const LinePoint& point : observation.line_points) {
    const LineResidual residual = residuals.of(point);
    observation.line_residuals.push_back(residual.distance);
    observation.line_fits.push_back(is_inlier(residual, result.scale));
  }
  observation.drift = drift_evidence(observation.line_points,
                                     observation.line_fits,
                                     posture.map(),
                                     result.estimate.X_FR,
                                     {&rays, model.centre(), camera.mirrored});
}

void Perception::Tables::find_balls(const PixelReader& pixels) {
  observation.balls.clear();
  observation.ball_pixels.clear();
  observation.ball_ranges.clear();
  const auto found = balls.find({pixels, colours, lines, rays, scan, hull});
  for (const BallCandidate& ball : found) {
    observation.balls.push_back(ball.ray);
    observation.ball_pixels.push_back(ball.pixels);
    observation.ball_ranges.push_back(range_of(ball.ray, ball_rules));
    // Black panels would be somebody's legs.
    if (ball.ray.colour != BallColour::kPatterned) continue;
    scan.take_for_ball(lines, {ball.pixels.u_px, ball.pixels.v_px}, ball.pixels.r_px);
  }
  const auto values = sensors.read(pixels, colours, found);
  observation.sensors.assign(values.begin(), values.end());
}

void Perception::Tables::find_obstacles() {
  observation.obstacles.clear();
  observation.obstacle_pixels.clear();
  observation.obstacles_left_out = 0;
  for (const ObstacleCandidate& obstacle : obstacles.find(scan, lines, hull)) {
    if (!is_on_field(obstacle, observation.posture, posture.map().field())) continue;
    if (observation.obstacles.size() == kMaxObstacleSightings) {
      ++observation.obstacles_left_out;
      continue;
    }
    observation.obstacles.push_back(obstacle.sighting);
    observation.obstacle_pixels.push_back(obstacle.pixels);
  }
  const auto free = obstacles.free_space();
  observation.free_space.assign(free.begin(), free.end());
}

Perception::Perception(const CameraParameters& camera,
                       const FieldModel& field,
                       const PerceptionParameters& parameters)
    : tables_(std::make_unique<Tables>(camera, field, parameters)) {}

Perception::~Perception() = default;
Perception::Perception(Perception&&) noexcept = default;
Perception& Perception::operator=(Perception&&) noexcept = default;

Result<const FrameObservation*, FrameReject> Perception::see(const ImageView& image,
                                                             const MotionPrior& prior) {
  return see_with(
      image, [&](const Cues& cues) { return tables_->posture.estimate(cues.line_points, prior); });
}

std::optional<FieldColours> Perception::field_colours(const ImageView& image) {
  if (reject_of(image, tables_->camera)) return std::nullopt;
  const PixelReader pixels(image);
  std::vector<SampledColour>& floor = tables_->floor;
  floor.clear();
  for (const ScanRange& range : tables_->lines.radial()) {
    const auto places = tables_->lines.pixels(range);
    for (std::size_t i = 0; i < places.size(); i += kFloorStride) {
      const std::size_t pixel = places[i];
      const Chroma chroma = pixels.chroma(pixel);
      floor.push_back({pixels.luminance(pixel), chroma.u, chroma.v});
    }
  }
  return tables_->field_meter.measure(floor);
}

void Perception::adapt(const LightGains& gains) {
  tables_->colours.adapt(gains);
}

const std::optional<FieldColours>& Perception::light() const {
  return tables_->camera.colours.light;
}

const HeadTilt& Perception::head() const {
  return tables_->head;
}

Result<const FrameObservation*, FrameReject> Perception::see_with(const ImageView& image,
                                                                  const PostureSource& posture_of) {
  if (const auto reject = reject_of(image, tables_->camera)) return failure(*reject);
  const PixelReader pixels(image);
  tables_->find_lines(pixels);
  tables_->find_goals();
  tables_->locate(posture_of);
  tables_->find_balls(pixels);
  tables_->find_obstacles();
  return &tables_->observation;
}

MotionPrior prior_after(const PostureEstimate& posture, double elapsed_s, StartSide start_side) {
  TEAMSIGHT_EXPECT(elapsed_s >= 0.0);
  MotionPrior prior;
  prior.start_side = start_side;
  if (posture.status == PostureStatus::kLost) return prior;
  prior.X_FR = posture.X_FR;
  prior.half_log_odds = posture.half_log_odds;
  // 3 m/s and 3 rad/s at two sigma, and a little for a robot that only just moved off.
  const double sigma = 0.05 + 1.5 * elapsed_s;
  prior.cov = posture.cov + sigma * sigma * Eigen::Matrix3d::Identity();
  return prior;
}

}  // namespace teamsight::vision
