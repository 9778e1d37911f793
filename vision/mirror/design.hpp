// vision/mirror/design.hpp: from a mirror's free parameters to a checked mirror.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/result.hpp"
#include "vision/mirror/assembly.hpp"
#include "vision/mirror/checks.hpp"
#include "vision/mirror/failure.hpp"
#include "vision/mirror/multi_part.hpp"
#include "vision/mirror/shapes.hpp"

namespace teamsight::mirror {

/// A mirror known by its points, such as one that was measured or designed elsewhere.
struct GivenProfile {
  Profile profile;

  friend bool operator==(const GivenProfile&, const GivenProfile&) = default;
};

using Shape =
    std::variant<MultiPart, Cone, Sphere, Paraboloid, Hyperboloid, ConeWithApex, GivenProfile>;

/// How large the mirror is in the image: one of the two is given, the other one follows.
struct RimRadiusPx {
  double value{512.0};  ///< image radius of the rim; px

  friend bool operator==(const RimRadiusPx&, const RimRadiusPx&) = default;
};

struct FocalPx {
  double value{0.0};  ///< px

  friend bool operator==(const FocalPx&, const FocalPx&) = default;
};

/// All free parameters of a mirror and what stands below it.
struct MirrorParameters {
  std::string name;
  Rim rim;  ///< the radius is not used with a GivenProfile, which brings its own
  Shape shape;
  std::variant<RimRadiusPx, FocalPx> scale;
  std::vector<BodyCylinder> body;
  double facet_px{1.0};  ///< step of the local construction of the isometric part, px

  friend bool operator==(const MirrorParameters&, const MirrorParameters&) = default;
};

/// A mirror that closes.
struct Mirror {
  std::string name;
  Assembly assembly;
  Margins margins;
  std::optional<MultiPartSolution> multi_part;        ///< of a MultiPart only
  std::optional<IntegrationDifference> integrations;  ///< of a MultiPart only
};

/// Designs a mirror and checks it.
///
/// @return the mirror, or the first condition that fails and by how much
[[nodiscard]] Result<Mirror, Failure> design(const MirrorParameters& parameters);

}  // namespace teamsight::mirror
