// agent/light_follower.cpp: see agent/light_follower.hpp.
#include "agent/light_follower.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace teamsight::agent {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod = 200ms;
constexpr Duration kLongest = 2s;  // that one look speaks for
constexpr double kUnsure = 0.3;    // a single bad look is no reason to complain

const char* name_of(vision::Light light) {
  switch (light) {
    case vision::Light::kGood:
      return "good";
    case vision::Light::kDark:
      return "too dark";
    case vision::Light::kGlare:
      return "glare";
    case vision::Light::kCovered:
      return "the lens is covered";
    case vision::Light::kUnknown:
      break;
  }
  return "no carpet in sight";
}

std::uint64_t percent(double share) {
  return static_cast<std::uint64_t>(std::llround(100.0 * std::max(0.0, share)));
}

}  // namespace

void LightFollower::follow(vision::Perception& perception,
                           const vision::ImageView& frame,
                           vision::Light light,
                           HostTime exposure) {
  light_ = light;
  const bool is_first = looked_ == HostTime{};
  if (!is_first && exposure - looked_ < kPeriod) return;
  const Duration elapsed = is_first ? kLongest : std::min(kLongest, exposure - looked_);
  looked_ = exposure;
  if (adaptation_.state().status == vision::LightStatus::kNoReference) return;
  // Classes of another light see no carpet where there is some: that look is needed most.
  const bool may_be_field = light == vision::Light::kGood || light == vision::Light::kUnknown;
  adaptation_.take(may_be_field ? perception.field_colours(frame) : std::nullopt,
                   to_seconds(elapsed));
  perception.adapt(adaptation_.state().gains);
}

void LightFollower::tell(process::ProcessMeter& meter) const {
  const vision::LightState& state = adaptation_.state();
  if (state.status == vision::LightStatus::kNoReference) return;
  meter.show("light.exposure_percent", percent(vision::exposure_of(state.gains)));
  meter.show("light.red_percent", percent(state.gains.red / state.gains.green));
  meter.show("light.blue_percent", percent(state.gains.blue / state.gains.green));
  meter.show("light.confidence_percent", percent(state.confidence));
}

std::string LightFollower::complaint() const {
  return light_complaint(light_, adaptation_.state());
}

std::string light_complaint(vision::Light light, const vision::LightState& state) {
  const std::string advice = ": teamsight calibrate colours --balance";
  if (state.status == vision::LightStatus::kAtBound) {
    return "light: too far from the camera file's to be followed" + advice;
  }
  if (state.status == vision::LightStatus::kDisputed && state.confidence < kUnsure) {
    return "light: green and white are not the camera file's" + advice;
  }
  if (light == vision::Light::kGood) return {};
  return std::string("light: ") + name_of(light) + ", what is seen may be wrong";
}

}  // namespace teamsight::agent
