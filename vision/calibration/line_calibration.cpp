// vision/calibration/line_calibration.cpp: starts, rounds, and whether to believe the outcome.
#include "vision/calibration/line_calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "geometry/expect.hpp"
#include "vision/calibration/view_search.hpp"

namespace teamsight::vision {

namespace {

// Sizes of the mirror's picture that are tried, as shares: a start far off leaves no posture.
constexpr std::array kSizes{0.0, -0.04, 0.04, -0.08, 0.08};
constexpr double kWellSupported = 0.6;  // votes per point that end the trying
constexpr double kUsable = 0.5;         // share of inliers of a view that is used
constexpr double kFits = 0.6;           // share of inliers over all used views
constexpr std::size_t kFewViews = 2;    // up to here every candidate is tried
constexpr int kLooks = 4;               // at the pictures again; two are the rule
constexpr double kSettled = 0.0005;     // m of floor, between two looks

/// Where the views may have been taken, for one size of the picture.
struct Start {
  Eigen::VectorXd turn;
  std::vector<std::vector<PostureFit>> candidates;  // of each view
  double support{0.0};                              // per point, on average
};

class Calibrator {
 public:
  Calibrator(const LineMap& map,
             const CameraParameters& camera,
             std::vector<std::vector<Pixel>> pixels,
             const LineCalibrationRules& rules)
      : map_(map),
        camera_(camera),
        pixels_(std::move(pixels)),
        rules_(rules),
        search_(map),
        priors_(knobs_of(camera)) {
    for (const KnobPrior& prior : priors_) knobs_.push_back(prior.knob);
  }

  /// @param lines  finds the pixels again; empty: they stay as they are
  LineCalibration run(const LineSource& lines);

 private:
  [[nodiscard]] Start start_with(double size);
  [[nodiscard]] std::vector<Start> starts();
  [[nodiscard]] std::optional<Bundle> first_round(const std::vector<Start>& starts);
  [[nodiscard]] Bundle second_round(const Bundle& first);
  [[nodiscard]] Bundle look_again(const LineSource& lines, Bundle bundle);
  void place_before(const Start& start, LineCalibration& result);
  void place_after(const Bundle& bundle, LineCalibration& result);
  void judge(const Bundle& bundle, LineCalibration& result) const;
  [[nodiscard]] BundleStart best_places(const Start& start) const;
  [[nodiscard]] std::vector<BundleStart> guesses_of(const Start& start) const;
  [[nodiscard]] double inlier_ratio(const Bundle& bundle, const CalibrationView& view) const;

  const LineMap& map_;
  const CameraParameters& camera_;
  std::vector<std::vector<Pixel>> pixels_;
  LineCalibrationRules rules_;
  ViewSearch search_;
  std::vector<KnobPrior> priors_;
  std::vector<CameraKnob> knobs_;
  std::vector<std::size_t> index_;  // of the bundle's views among the given ones
};

Start Calibrator::start_with(double size) {
  Start start;
  start.turn = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(knobs_.size()));
  for (std::size_t k = 0; k < knobs_.size(); ++k) {
    const bool is_size = knobs_[k] == CameraKnob::kFocal || knobs_[k] == CameraKnob::kRadial0;
    if (is_size) start.turn[static_cast<Eigen::Index>(k)] = size;
  }
  const auto parameters = turned(camera_, knobs_, start.turn);
  double points = 0.0;
  for (const std::vector<Pixel>& view : pixels_) {
    start.candidates.emplace_back();
    if (!parameters) continue;
    start.candidates.back() = search_.search(CameraModel(*parameters), view, rules_.bundle);
    if (start.candidates.back().empty()) continue;
    start.support += start.candidates.back().front().support;
    points += static_cast<double>(view.size());
  }
  start.support /= std::max(points, 1.0);
  return start;
}

// The picture's size as it is; others where that leaves the points unexplained. With few views,
// which a bent camera can explain at a wrong place, all of them.
std::vector<Start> Calibrator::starts() {
  std::vector<Start> starts;
  for (const double size : kSizes) {
    starts.push_back(start_with(size));
    if (pixels_.size() > kFewViews && starts.front().support > kWellSupported) break;
  }
  if (pixels_.size() > kFewViews) {
    std::ranges::stable_sort(starts, std::greater<>(), &Start::support);
    starts.resize(1);
  }
  return starts;
}

BundleStart Calibrator::best_places(const Start& start) const {
  BundleStart places;
  places.turn = start.turn;
  for (std::size_t v = 0; v < pixels_.size(); ++v) {
    if (start.candidates[v].empty()) continue;
    places.views.push_back({pixels_[v], start.candidates[v].front().X_FR});
  }
  return places;
}

// What the adjustment may begin from. A single view may be explained by the wrong place and a bent
// camera: every place is tried.
std::vector<BundleStart> Calibrator::guesses_of(const Start& start) const {
  BundleStart places = best_places(start);
  if (places.views.size() > 1) return {std::move(places)};
  std::vector<BundleStart> guesses;
  for (std::size_t v = 0; v < pixels_.size(); ++v) {
    for (const PostureFit& fit : start.candidates[v]) {
      guesses.push_back({{{pixels_[v], fit.X_FR}}, start.turn});
    }
  }
  return guesses;
}

// The best fit of all starts; nothing if no view has any posture.
std::optional<Bundle> Calibrator::first_round(const std::vector<Start>& starts) {
  std::optional<Bundle> best;
  for (const Start& start : starts) {
    for (BundleStart& guess : guesses_of(start)) {
      Bundle bundle = adjust(map_, camera_, priors_, std::move(guess), rules_.bundle);
      if (bundle.info.size() == 0) continue;
      if (!best || bundle.cost < best->cost) best = std::move(bundle);
    }
  }
  return best;
}

double Calibrator::inlier_ratio(const Bundle& bundle, const CalibrationView& view) const {
  const auto misses = misses_of(map_, CameraModel(bundle.camera), view, rules_.bundle);
  if (misses.empty()) return 0.0;
  const auto inliers = std::ranges::count_if(misses, [&](const PaintMiss& miss) {
    return std::abs(miss.distance_px) < 3.0 * rules_.bundle.sigma_px * bundle.scale ||
           std::abs(miss.distance) < 0.02;
  });
  return static_cast<double>(inliers) / static_cast<double>(misses.size());
}

// Searches all views again with the camera of the first round; drops those that fit nowhere.
Bundle Calibrator::second_round(const Bundle& first) {
  BundleStart start;
  start.turn = first.turn;
  index_.clear();
  const CameraModel model(first.camera);
  for (std::size_t v = 0; v < pixels_.size(); ++v) {
    const auto found = search_.search(model, pixels_[v], rules_.bundle);
    if (found.empty()) continue;
    CalibrationView view{pixels_[v], found.front().X_FR};
    if (inlier_ratio(first, view) < kUsable && pixels_.size() > 1) continue;
    start.views.push_back(std::move(view));
    index_.push_back(v);
  }
  if (start.views.empty()) return first;
  return adjust(map_, camera_, priors_, std::move(start), rules_.bundle);
}

// Through the wrong camera the middle of the paint is looked for at the wrong share of its width
// in the picture, by a third of a pixel far out: each look is through the camera of the last.
Bundle Calibrator::look_again(const LineSource& lines, Bundle bundle) {
  for (int look = 0; look < kLooks && !index_.empty(); ++look) {
    pixels_ = lines(bundle.camera);
    Bundle next = second_round(bundle);
    const auto moved =
        ground_difference(CameraModel(bundle.camera), CameraModel(next.camera), rules_.reach);
    bundle = std::move(next);
    if (moved && *moved < kSettled) break;
  }
  return bundle;
}

void Calibrator::place_before(const Start& start, LineCalibration& result) {
  const CameraModel model(camera_);
  for (std::size_t v = 0; v < pixels_.size(); ++v) {
    if (start.candidates[v].empty()) continue;
    const CalibrationView view{pixels_[v], start.candidates[v].front().X_FR};
    result.views[v].before = misses_of(map_, model, view, rules_.bundle);
  }
}

void Calibrator::place_after(const Bundle& bundle, LineCalibration& result) {
  const CameraModel model(bundle.camera);
  for (std::size_t i = 0; i < index_.size(); ++i) {
    ViewResult& view = result.views[index_[i]];
    view.used = true;
    view.X_FR = bundle.views[i].X_FR;
    view.inlier_ratio = inlier_ratio(bundle, bundle.views[i]);
    view.after = misses_of(map_, model, bundle.views[i], rules_.bundle);
  }
}

double median_px(const LineCalibration& result) {
  std::vector<double> sizes;
  for (const ViewResult& view : result.views) {
    for (const PaintMiss& miss : view.after) sizes.push_back(std::abs(miss.distance_px));
  }
  if (sizes.empty()) return 0.0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

// Of the knobs: from the pixels' scatter, and from what they share.
Eigen::MatrixXd covariance_of(const Bundle& bundle, std::span<const KnobPrior> priors) {
  Eigen::VectorXd prior_info(static_cast<Eigen::Index>(priors.size()));
  for (std::size_t k = 0; k < priors.size(); ++k) {
    prior_info[static_cast<Eigen::Index>(k)] = 1.0 / (priors[k].sigma * priors[k].sigma);
  }
  const auto inverse = [](const Eigen::MatrixXd& info) -> Eigen::MatrixXd {
    return info.ldlt().solve(Eigen::MatrixXd::Identity(info.rows(), info.cols()));
  };
  Eigen::MatrixXd info = bundle.info;
  info.diagonal() += prior_info;
  Eigen::MatrixXd fitted = bundle.correlation * bundle.info;  // as the fit itself weighs
  fitted.diagonal() += prior_info;
  const Eigen::MatrixXd spread = inverse(fitted);
  return inverse(info) + spread * bundle.shared * spread;
}

void Calibrator::judge(const Bundle& bundle, LineCalibration& result) const {
  const Eigen::MatrixXd cov = covariance_of(bundle, priors_);
  for (std::size_t k = 0; k < priors_.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    result.knobs.push_back({priors_[k], bundle.turn[i], std::sqrt(cov(i, i))});
  }
  CalibrationRecord record;
  record.knobs = knobs_;
  record.cov.assign(cov.data(), cov.data() + cov.size());
  record.residual_px = median_px(result);
  record.views = static_cast<std::uint32_t>(index_.size());
  result.camera = bundle.camera;
  result.camera.calibration = std::move(record);
  result.scale = bundle.scale;
  result.ground_sigma = ground_sigma_of(result.camera, rules_.reach);
  double inliers = 0.0;
  double points = 0.0;
  for (const ViewResult& view : result.views) {
    inliers += view.inlier_ratio * static_cast<double>(view.after.size());
    points += static_cast<double>(view.after.size());
  }
  if (inliers < kFits * points) {
    result.refusal = LineRefusal::kDoesNotFit;
  } else if (!(result.ground_sigma < rules_.max_ground_sigma)) {
    result.refusal = LineRefusal::kNotDetermined;
  }
}

LineCalibration Calibrator::run(const LineSource& lines) {
  LineCalibration result;
  result.camera = camera_;
  result.views.resize(pixels_.size());
  const std::vector<Start> all = starts();
  place_before(start_with(0.0), result);
  const auto first = first_round(all);
  if (!first) {
    result.refusal = LineRefusal::kNoPosture;
    return result;
  }
  Bundle bundle = second_round(*first);
  if (lines) bundle = look_again(lines, std::move(bundle));
  if (index_.empty() || bundle.info.size() == 0) {
    result.refusal = LineRefusal::kNoPosture;
    return result;
  }
  place_after(bundle, result);
  judge(bundle, result);
  return result;
}

}  // namespace

LineCalibration calibrate_lines(const LineMap& map,
                                const CameraParameters& camera,
                                std::span<const std::vector<Pixel>> pixels,
                                const LineCalibrationRules& rules) {
  TEAMSIGHT_EXPECT(!pixels.empty());
  return Calibrator(map, camera, {pixels.begin(), pixels.end()}, rules).run({});
}

LineCalibration calibrate_lines(const LineMap& map,
                                const CameraParameters& camera,
                                const LineSource& lines,
                                const LineCalibrationRules& rules) {
  auto pixels = lines(camera);
  TEAMSIGHT_EXPECT(!pixels.empty());
  return Calibrator(map, camera, std::move(pixels), rules).run(lines);
}

}  // namespace teamsight::vision
