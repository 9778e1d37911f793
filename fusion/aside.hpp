// fusion/aside.hpp: whose posture is biased: as the others see it, and as it sees the others.
#pragma once

#include <array>

#include <Eigen/Core>

#include "fusion/parameters.hpp"
#include "fusion/track_book.hpp"
#include "geometry/identity.hpp"

namespace teamsight::fusion {

/// That one robot saw another, and how far from where that one says it stands.
struct MateSighting {
  RobotId observer{kNobody};
  RobotId watched{kNobody};
  HostTime exposure{kNever};
  Eigen::Vector2d gap{Eigen::Vector2d::Zero()};      ///< place seen minus place said, in F; m
  Eigen::Matrix2d cov{Eigen::Matrix2d::Identity()};  ///< of it, as both robots say; m^2
};

/// Weighs, for each robot, that its posture stands aside by one and the same way in all that it
/// sees of the others and that they see of it, against that it does not. A plain value.
///
/// However many others see one body in one place, it is one thing that they see, and may be another
/// body that hides it: they alone do not decide it. What it sees of several others does.
class AsideBook {
 public:
  void take(const MateSighting& sighting, const Parameters& parameters);

  /// Its posture jumped, or another process speaks: what was known of it is void.
  void forget(RobotId robot);

  /// Finds who stands aside: who explains most, by a margin.
  void judge(HostTime exposure, const TrustParameters& parameters);

  [[nodiscard]] bool is_aside(RobotId robot) const;

 private:
  /// Of one robot: by how much, if at all, its posture stands aside.
  struct Page {
    HostTime time{kNever};
    Eigen::Vector2d mean{Eigen::Vector2d::Zero()};     ///< posture minus truth; m
    Eigen::Matrix2d cov{Eigen::Matrix2d::Identity()};  ///< m^2
    double watched{0.0};                               ///< log-odds by what the others see of it
    std::array<double, kMaxRobotId> own{};             ///< ... by what it sees of each of them
    bool is_aside{false};
  };

  static void turn_page(Page& page, HostTime exposure, const TrustParameters& parameters);
  [[nodiscard]] static bool is_far(const Page& page, const TrustParameters& parameters);
  void weigh(Page& page,
             double& evidence,
             const MateSighting& sighting,
             double share,
             const Parameters& parameters) const;
  [[nodiscard]] double log_odds(const Page& page, const TrustParameters& parameters) const;

  std::array<Page, kMaxRobotId> pages_{};
  std::array<RobotTimes, kMaxRobotId> looked_{make_looked()};  ///< by observer and watched

  static constexpr std::array<RobotTimes, kMaxRobotId> make_looked() {
    std::array<RobotTimes, kMaxRobotId> looked{};
    looked.fill(no_robot_times());
    return looked;
  }
};

}  // namespace teamsight::fusion
