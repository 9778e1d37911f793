// vision/mirror/design.cpp: puts profile, camera and body together and checks them.
#include "vision/mirror/design.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace teamsight::mirror {
namespace {

constexpr std::size_t kIntervals = 800;

/// The profile, and for a multi-part mirror its solution.
struct Draft {
  Profile profile;
  std::optional<MultiPartSolution> multi_part;
};

Result<Draft, Failure> make_draft(const GivenProfile& shape, const Rim& /*its own*/) {
  return Draft{shape.profile, std::nullopt};
}

Result<Draft, Failure> make_draft(const MultiPart& shape, const Rim& rim) {
  return solve(shape, rim).map([](const MultiPartSolution& solution) {
    return Draft{solution.profile(), solution};
  });
}

template <class Classical>
Result<Draft, Failure> make_draft(const Classical& shape, const Rim& rim) {
  return make_profile(shape, rim, kIntervals).map([](const Profile& profile) {
    return Draft{profile, std::nullopt};
  });
}

double focal_of(const std::variant<RimRadiusPx, FocalPx>& scale, const Node& rim) {
  if (const auto* focal = std::get_if<FocalPx>(&scale)) {
    return focal->value;
  }
  return std::get<RimRadiusPx>(scale).value * rim.y / rim.x;
}

std::optional<IntegrationDifference> compare(const MultiPartSolution& solution,
                                             double focal_px,
                                             double facet_px) {
  const double facets = std::ceil(focal_px * solution.isometric.tan_end / facet_px);
  return compare_integrations(solution.isometric, static_cast<std::size_t>(std::max(facets, 1.0)));
}

}  // namespace

Result<Mirror, Failure> design(const MirrorParameters& parameters) {
  auto draft = std::visit([&](const auto& shape) { return make_draft(shape, parameters.rim); },
                          parameters.shape);
  if (!draft) {
    return failure(draft.error());
  }
  if (auto failed = check_function(draft->profile)) {
    return failure(*failed);
  }
  const Node edge = rim(draft->profile);
  const double pinhole_height = parameters.rim.height - edge.y;
  if (!(pinhole_height > 0.0)) {
    return failure(Failure{Condition::kSolution,
                           -pinhole_height,
                           fmt::format("no solution: the pinhole would be {:.4f} m below the floor",
                                       -pinhole_height)});
  }
  Mirror mirror{.name = parameters.name,
                .assembly = {std::move(draft->profile),
                             pinhole_height,
                             focal_of(parameters.scale, edge),
                             parameters.body},
                .margins = {},
                .multi_part = draft->multi_part,
                .integrations = std::nullopt};
  const std::optional<std::size_t> ring =
      mirror.multi_part ? std::optional(mirror.assembly.profile.parts.size() - 1) : std::nullopt;
  const auto margins = check(mirror.assembly, ring);
  if (!margins) {
    return failure(margins.error());
  }
  mirror.margins = *margins;
  if (mirror.multi_part) {
    mirror.integrations =
        compare(*mirror.multi_part, mirror.assembly.focal_px, parameters.facet_px);
  }
  return mirror;
}

}  // namespace teamsight::mirror
