// vision/camera_knobs.cpp: priors, names, and how each knob acts.
#include "vision/camera_knobs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <variant>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

struct KnobFacts {
  double nudge;
  double sigma;  // of the prior
};

constexpr double kDegree = 0.017453292519943295;

// By CameraKnob. The priors are what people building robots by hand achieve, generously: some
// pixels, one or two per cent of the lens, a millimetre, half a degree. Those of a radial table
// must also take up a mirror that is not quite the one it was measured with.
constexpr std::array<KnobFacts, 16> kFacts{{
    {0.05, 4.0},
    {0.05, 4.0},
    {1e-4, 0.015},
    {1e-5, 0.001},
    {1e-5, 0.001},
    {1e-5, 0.001},
    {1e-4, 0.5 * kDegree},
    {1e-4, 0.5 * kDegree},
    {1e-4, 0.5 * kDegree},
    {1e-4, 0.5 * kDegree},
    {1e-4, 0.005},
    {1e-4, 0.05},
    {1e-4, 0.03},
    {1e-4, 0.02},
    {1e-4, 0.01},
    {1e-4, 0.005},
}};

const KnobFacts& facts_of(CameraKnob knob) {
  return kFacts.at(static_cast<std::size_t>(knob));
}

void turn_one(ProfileMirror& mirror, CameraKnob knob, double by) {
  switch (knob) {
    case CameraKnob::kCentreU:
      mirror.centre_u_px += by;
      return;
    case CameraKnob::kCentreV:
      mirror.centre_v_px += by;
      return;
    case CameraKnob::kFocal:
      mirror.focal_x_px *= 1.0 + by;
      mirror.focal_y_px *= 1.0 + by;
      return;
    case CameraKnob::kOffsetX:
      mirror.offset_C[0] += by;
      return;
    case CameraKnob::kOffsetY:
      mirror.offset_C[1] += by;
      return;
    case CameraKnob::kOffsetZ:
      mirror.offset_C[2] += by;
      return;
    case CameraKnob::kTiltX:
      mirror.tilt_C[0] += by;
      return;
    case CameraKnob::kTiltY:
      mirror.tilt_C[1] += by;
      return;
    case CameraKnob::kHeadRoll:
      mirror.head_roll += by;
      return;
    case CameraKnob::kHeadPitch:
      mirror.head_pitch += by;
      return;
    case CameraKnob::kHeight:
      mirror.pinhole_height += by;
      return;
    default:
      TEAMSIGHT_EXPECT(false && "a profile has no radial knobs");
  }
}

// T_order over the radius, from -1 on the axis to 1 at the rim: even and smooth in between.
double chebyshev(int order, double share) {
  return std::cos(order * std::acos(std::clamp(2.0 * share - 1.0, -1.0, 1.0)));
}

void turn_one(RadialTable& table, CameraKnob knob, double by, const RadialTable& before) {
  switch (knob) {
    case CameraKnob::kCentreU:
      table.centre_u_px += by;
      return;
    case CameraKnob::kCentreV:
      table.centre_v_px += by;
      return;
    case CameraKnob::kHeadRoll:
      table.head_roll += by;
      return;
    case CameraKnob::kHeadPitch:
      table.head_pitch += by;
      return;
    default:
      break;
  }
  const int order = static_cast<int>(knob) - static_cast<int>(CameraKnob::kRadial0);
  TEAMSIGHT_EXPECT(order >= 0);
  const double rim = before.rows.back().radius_px;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const double radius = before.rows[i].radius_px;
    table.rows[i].radius_px += by * radius * chebyshev(order, radius / rim);
  }
}

bool is_possible(const ProfileMirror& mirror) {
  return mirror.focal_x_px > 0.0 && mirror.pinhole_height > 0.0;
}

bool is_possible(const RadialTable& table) {
  return std::ranges::adjacent_find(table.rows, [](const RingMark& a, const RingMark& b) {
           return b.radius_px <= a.radius_px;
         }) == table.rows.end();
}

}  // namespace

std::vector<KnobPrior> knobs_of(const CameraParameters& camera) {
  std::vector<KnobPrior> knobs;
  const bool is_profile = std::holds_alternative<ProfileMirror>(camera.mirror);
  for (const CameraKnob knob : knobs_of_mirror(is_profile)) {
    knobs.push_back({knob, facts_of(knob).sigma});
  }
  return knobs;
}

double nudge_of(CameraKnob knob) {
  return facts_of(knob).nudge;
}

std::optional<CameraParameters> turned(const CameraParameters& camera,
                                       std::span<const CameraKnob> knobs,
                                       const Eigen::VectorXd& turn) {
  TEAMSIGHT_EXPECT(static_cast<std::size_t>(turn.size()) == knobs.size());
  CameraParameters result = camera;
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    const double by = turn[static_cast<Eigen::Index>(k)];
    if (auto* profile = std::get_if<ProfileMirror>(&result.mirror)) {
      turn_one(*profile, knobs[k], by);
    } else {
      turn_one(
          std::get<RadialTable>(result.mirror), knobs[k], by, std::get<RadialTable>(camera.mirror));
    }
  }
  const bool possible =
      std::visit([](const auto& mirror) { return is_possible(mirror); }, result.mirror);
  return possible ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace teamsight::vision
