// vision/light_adaptation.cpp: gains of three colours by least squares over green and white.
#include "vision/light_adaptation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

constexpr double kSaturated = 240.0;  // grey levels; a colour that has no room left tells nothing
// Grey levels that may be due to anything but light: shades of the carpet; far paint is mixed with
// carpet, and darker towards the rim.
constexpr std::array<double, 2> kSigma{5.0, 25.0};
constexpr double kUnsure = 0.3;      // of the confidence: the field has not been seen for a while
constexpr double kSameLight = 1e-3;  // of a gain

using Colours = std::array<Eigen::Vector3d, 2>;  // red, green, blue of carpet and paint

Eigen::Vector3d rgb_of(const SampledColour& colour) {
  return vision::rgb_of(colour.y, colour.u, colour.v).cwiseMax(0.0);
}

Colours colours_of(const FieldColours& field) {
  return {rgb_of(field.green), rgb_of(field.white)};
}

bool has_no_room(const Colours& colours, std::size_t which, Eigen::Index channel) {
  return which == 1 && colours[which](channel) > kSaturated;
}

Eigen::Vector3d fit_gains(const Colours& before, const Colours& now) {
  Eigen::Vector3d gains;
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    double product = 1e-6;
    double square = 1e-6;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (has_no_room(now, i, channel)) continue;
      const double info = 1.0 / (kSigma[i] * kSigma[i]);
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
      if (has_no_room(now, i, channel)) continue;
      const double off = (now[i](channel) - gains(channel) * before[i](channel)) / kSigma[i];
      sum += off * off;
      count += 1.0;
    }
  }
  return std::sqrt(sum / count);
}

// Exposure and cast within their bounds.
Eigen::Vector3d bounded(const Eigen::Vector3d& gains, const LightRules& rules) {
  const Eigen::Array3d logs = gains.array().max(1e-3).log();
  const double exposure = logs.mean();
  const double most_exposure = std::log(rules.most_exposure);
  const double most_cast = std::log(rules.most_cast);
  const Eigen::Array3d cast = (logs - exposure).max(-most_cast).min(most_cast);
  return (cast + std::clamp(exposure, -most_exposure, most_exposure)).exp().matrix();
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
  const Eigen::Vector3d wanted = bounded(gains, rules_);
  const bool is_bounded = (wanted - gains).cwiseAbs().maxCoeff() > kSameLight * gains.maxCoeff();
  follow({wanted.x(), wanted.y(), wanted.z()}, share_in(elapsed_s, rules_.settle));
  state_.confidence += share * ((is_bounded ? 0.0 : 1.0) - state_.confidence);
  state_.status = is_bounded ? LightStatus::kAtBound : LightStatus::kFollowing;
}

}  // namespace teamsight::vision
