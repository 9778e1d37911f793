// vision/light_adaptation.cpp: gains of three colours by least squares over green and white.
#include "vision/light_adaptation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

constexpr double kSaturated = 250.0;  // grey levels; a colour that has no room left tells nothing
// That may be due to anything but light. Carpet has shades, and stray light makes it paler; far
// paint is mixed with carpet, and darker towards the rim.
constexpr std::array<double, 2> kSigma{5.0, 20.0};          // grey levels
constexpr std::array<double, 2> kRelativeSigma{0.08, 0.0};  // of the colour itself
// Logarithms by which pictures in one light differ: shade, and how much of what is in view.
constexpr double kCastScatter = 0.12;
constexpr double kExposureScatter = 0.25;
constexpr double kUnsure = 0.3;      // of the confidence: the field has not been seen for a while
constexpr double kSameLight = 1e-3;  // of a gain

using Colours = std::array<Eigen::Vector3d, 2>;  // red, green, blue of carpet and paint

Eigen::Vector3d rgb_of(const SampledColour& colour) {
  return vision::rgb_of(colour.y, colour.u, colour.v).cwiseMax(0.0);
}

Colours colours_of(const FieldColours& field) {
  return {rgb_of(field.green), rgb_of(field.white)};
}

// Of paint, then or now.
bool has_no_room(const Colours& before,
                 const Colours& now,
                 std::size_t which,
                 Eigen::Index channel) {
  return which == 1 && std::max(before[which](channel), now[which](channel)) > kSaturated;
}

double variance_of(const Colours& colours, std::size_t which, Eigen::Index channel) {
  const double relative = kRelativeSigma[which] * colours[which](channel);
  return kSigma[which] * kSigma[which] + relative * relative;
}

// How much of its information is used, in [0, 1]: what is taken for paint may be a ball or a wall,
// and then the carpet's gains do not explain it.
double trust_in_paint(const Colours& before, const Colours& now) {
  double sum = 0.0;
  double count = 1e-6;
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    if (has_no_room(before, now, 1, channel)) continue;
    const double ratio = before[1](channel) / std::max(1.0, before[0](channel));
    const double off = now[1](channel) - ratio * now[0](channel);
    sum +=
        off * off / (variance_of(now, 1, channel) + ratio * ratio * variance_of(now, 0, channel));
    count += 1.0;
  }
  return 1.0 / (1.0 + sum / count);
}

Eigen::Vector3d fit_gains(const Colours& before, const Colours& now) {
  const std::array<double, 2> trust{1.0, trust_in_paint(before, now)};
  Eigen::Vector3d gains;
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    double product = 1e-6;
    double square = 1e-6;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (has_no_room(before, now, i, channel)) continue;
      const double info = trust[i] / variance_of(before, i, channel);
      product += info * before[i](channel) * now[i](channel);
      square += info * before[i](channel) * before[i](channel);
    }
    gains(channel) = product / square;
  }
  return gains;
}

// What the gains leave unexplained, in sigmas.
double mismatch_of(const Colours& before, const Colours& now, const Eigen::Vector3d& gains) {
  double sum = 0.0;
  double count = 0.0;  // the carpet's three at least
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (Eigen::Index channel = 0; channel < 3; ++channel) {
      if (has_no_room(before, now, i, channel)) continue;
      const double off = now[i](channel) - gains(channel) * before[i](channel);
      sum += off * off / variance_of(now, i, channel);
      count += 1.0;
    }
  }
  return std::sqrt(sum / count);
}

/// Logarithms of gains: of all together, and of each against that.
struct LightChange {
  double exposure{0.0};
  Eigen::Array3d cast;
};

LightChange change_of(const Eigen::Vector3d& gains) {
  const Eigen::Array3d logs = gains.array().max(1e-3).log();
  const double exposure = logs.mean();
  return {exposure, logs - exposure};
}

LightChange bounded(const LightChange& change, const LightRules& rules) {
  const double most_exposure = std::log(rules.most_exposure);
  const double most_cast = std::log(rules.most_cast);
  return {std::clamp(change.exposure, -most_exposure, most_exposure),
          change.cast.max(-most_cast).min(most_cast)};
}

// Hardly anything of a change within the scatter, nearly all from one and a half of it on.
LightGains believed(const LightChange& change) {
  const double size =
      std::hypot(change.exposure / kExposureScatter, change.cast.matrix().norm() / kCastScatter);
  const double power = std::pow(size, 8.0);
  const Eigen::Array3d gains = (power / (1.0 + power) * (change.cast + change.exposure)).exp();
  return {gains(0), gains(1), gains(2)};
}

double share_in(double elapsed_s, double time_constant) {
  return 1.0 - std::exp(-elapsed_s / time_constant);
}

}  // namespace

LightAdaptation::LightAdaptation(const std::optional<FieldColours>& reference,
                                 const LightRules& rules)
    : reference_(reference),
      rules_(rules) {
  if (reference_) state_.status = LightStatus::kWaiting;
}

void LightAdaptation::follow(const LightGains& measured, double share) {
  const auto towards = [&](double& gain, double wanted) {
    gain *= std::pow(wanted / gain, share);
  };
  towards(state_.gains.red, measured.red);
  towards(state_.gains.green, measured.green);
  towards(state_.gains.blue, measured.blue);
}

void LightAdaptation::take(const std::optional<FieldColours>& now, double elapsed_s) {
  TEAMSIGHT_EXPECT(elapsed_s >= 0.0);
  if (!reference_) return;
  const double share = share_in(elapsed_s, rules_.trust);
  if (!now) {
    state_.confidence -= share * state_.confidence;
    if (state_.confidence < kUnsure) state_.status = LightStatus::kWaiting;
    return;
  }
  const Colours before = colours_of(*reference_);
  const Colours seen = colours_of(*now);
  const Eigen::Vector3d gains = fit_gains(before, seen);
  if (mismatch_of(before, seen, gains) > rules_.most_mismatch) {
    state_.confidence -= share * state_.confidence;
    state_.status = LightStatus::kDisputed;
    return;
  }
  const LightChange change = change_of(gains);
  const LightChange wanted = bounded(change, rules_);
  const bool is_bounded = std::abs(wanted.exposure - change.exposure) > kSameLight ||
                          (wanted.cast - change.cast).abs().maxCoeff() > kSameLight;
  follow(believed(wanted), share_in(elapsed_s, rules_.settle));
  state_.confidence += share * ((is_bounded ? 0.0 : 1.0) - state_.confidence);
  state_.status = is_bounded ? LightStatus::kAtBound : LightStatus::kFollowing;
}

}  // namespace teamsight::vision
