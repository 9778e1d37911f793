// tools/doctor_findings.hpp: what the doctor says of what it has seen. Values in, values out.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/identity.hpp"
#include "geometry/time.hpp"

namespace teamsight::tools {

/// Of one robot, as it was heard.
struct HeardRobot {
  double frame_rate_hz{0.0};
  bool camera_lost{false};
  double calibration_drift_px{0.0};
  std::string version;
};

/// Everything that was looked at.
struct Observed {
  RobotId robot{kNobody};
  std::string software_version;       ///< of this command
  std::string profile;                ///< path of the DDS profile
  std::string card;                   ///< that it names; empty: the library chooses
  std::vector<std::string> cards_up;  ///< this computer's
  std::uint32_t domain_id{0};
  bool secured{false};
  std::optional<double> certificate_days;  ///< left; nothing: security is off or openssl is missing
  bool camera_exists{false};               ///< the device file
  std::string camera_device;
  double calibration_days{0.0};  ///< age of the camera file
  std::map<RobotId, HeardRobot> heard;
  std::string rival;                         ///< the other computer that speaks under its id
  std::set<RobotId> expected;                ///< whom the operator expects; empty: whoever is there
  std::uint32_t state_writers{0};            ///< of RobotState that discovery found
  std::string other_domains;                 ///< announced on this network; empty: none
  std::optional<RobotId> leader;             ///< whose world model came over the air
  bool own_fusion{false};                    ///< the own host's world model was heard
  std::map<RobotId, Duration> clock_sigmas;  ///< by the leader; 0 = it has not measured that one
  double team_bps{0.0};
  double disk_free_gb{0.0};
};

/// One line for the operator.
struct Finding {
  std::string check;
  bool ok{true};
  std::string found;
  std::string what_to_do;  ///< empty if ok
};

/// In the order in which one would look.
[[nodiscard]] std::vector<Finding> findings(const Observed& seen);

}  // namespace teamsight::tools
