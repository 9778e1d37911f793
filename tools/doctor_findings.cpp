// tools/doctor_findings.cpp: see doctor_findings.hpp.
#include "tools/doctor_findings.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace teamsight::tools {
namespace {

constexpr double kSlowCamera = 20.0;      // Hz
constexpr double kOldCalibration = 14.0;  // days
constexpr double kDrift = 1.5;            // px; a line is about three pixels wide at 4 m
constexpr double kSoon = 7.0;             // days
constexpr double kLeastDisk = 2.0;        // GB; a recorded match takes about one
constexpr Duration kLooseClock = std::chrono::milliseconds(5);
constexpr double kAirGoal = 2.0e6;  // bit/s

Finding fine(std::string check, std::string found) {
  return {std::move(check), true, std::move(found), {}};
}

Finding wrong(std::string check, std::string found, std::string what_to_do) {
  return {std::move(check), false, std::move(found), std::move(what_to_do)};
}

std::string list(const std::set<RobotId>& robots) {
  std::string text;
  for (const RobotId robot : robots) text += (text.empty() ? "" : ", ") + std::to_string(robot);
  return text.empty() ? "none" : text;
}

Finding identity(const Observed& seen) {
  const std::string own = fmt::format("robot id {}", seen.robot);
  if (seen.rival.empty()) return fine("id", own + ", used on no other computer");
  return wrong("id",
               own + " is used on " + seen.rival + " too",
               "give one of the two robots another id, in its robot file");
}

Finding camera(const Observed& seen) {
  const auto own = seen.heard.find(seen.robot);
  if (own == seen.heard.end()) {
    if (seen.camera_exists) {
      return wrong("camera",
                   seen.camera_device + " is there, the agent is not running",
                   fmt::format("systemctl start teamsight-agent@robot{}", seen.robot));
    }
    return wrong("camera",
                 "no " + seen.camera_device,
                 "plug the camera in, or name its device: --device /dev/video1");
  }
  if (own->second.camera_lost) {
    return wrong("camera", "the agent gets no frames", "check cable and power; see its journal");
  }
  const std::string rate = fmt::format("{:.1f} frames/s", own->second.frame_rate_hz);
  if (own->second.frame_rate_hz < kSlowCamera) {
    return wrong(
        "camera", rate, "set a shorter exposure or a smaller picture; 20 or more are wanted");
  }
  return fine("camera", rate);
}

Finding calibration(const Observed& seen) {
  const auto own = seen.heard.find(seen.robot);
  const double drift = own == seen.heard.end() ? 0.0 : own->second.calibration_drift_px;
  const std::string found =
      fmt::format("{:.0f} days old, drift {:.1f} px", seen.calibration_days, drift);
  if (drift > kDrift) {
    return wrong("calibration", found, "mirror or camera has moved: teamsight calibrate lines");
  }
  if (seen.calibration_days > kOldCalibration) {
    return wrong("calibration", found, "calibrate on this field: teamsight calibrate");
  }
  return fine("calibration", found);
}

Finding clocks(const Observed& seen) {
  if (!seen.leader) return fine("clocks", "nobody leads, so nobody has compared them");
  std::set<RobotId> loose;
  for (const auto& [robot, sigma] : seen.clock_sigmas) {
    if (robot != *seen.leader && (sigma == Duration{0} || sigma > kLooseClock)) loose.insert(robot);
  }
  if (loose.empty()) return fine("clocks", "all within 5 ms, as the leader measures them");
  return wrong(
      "clocks",
      "not known to 5 ms: robots " + list(loose),
      "wait ten seconds; if it stays, the network delays them: look at load and reception");
}

Finding peers(const Observed& seen) {
  std::set<RobotId> heard;
  for (const auto& [robot, state] : seen.heard) heard.insert(robot);
  std::set<RobotId> missing;
  std::ranges::set_difference(seen.expected, heard, std::inserter(missing, missing.end()));
  const std::string found = "heard: " + list(heard);
  if (missing.empty()) return fine("peers", found);
  return wrong("peers",
               found + "; not heard: " + list(missing),
               "are they on, with the same team file, domain, profile and security?");
}

Finding card(const Observed& seen) {
  const std::string begin = seen.profile + " on ";
  if (!seen.card.empty()) return fine("card", begin + seen.card);
  std::string all;
  for (const std::string& one : seen.cards_up) all += (all.empty() ? "" : ", ") + one;
  if (seen.cards_up.size() <= 1) return fine("card", begin + (all.empty() ? "loopback" : all));
  return wrong("card",
               begin + "whichever the library takes of " + all,
               "name the team's card in the profile: <NetworkInterface name=\"...\"/>");
}

Finding multicast(const Observed& seen) {
  const auto others = std::ranges::count_if(
      seen.heard, [&](const auto& entry) { return entry.first != seen.robot; });
  const bool is_known = seen.state_writers > (seen.heard.contains(seen.robot) ? 1U : 0U);
  if (others > 0) return fine("network", fmt::format("samples of {} others arrive", others));
  if (is_known) {
    return wrong(
        "network",
        "others are discovered, their samples do not arrive",
        "the network drops multicast: allow IGMP on the switch, or config/dds/unicast.xml");
  }
  const std::string elsewhere =
      seen.other_domains.empty() ? "" : "; this network carries " + seen.other_domains;
  return wrong(
      "network",
      fmt::format("nobody else on domain {} with {}{}", seen.domain_id, seen.profile, elsewhere),
      "if others are on: right interface in the profile? multicast allowed? same team name?");
}

Finding security(const Observed& seen) {
  if (!seen.secured) {
    return fine("security", "off: anybody on this network can speak for a robot");
  }
  if (!seen.certificate_days) return fine("security", "on; openssl is not here to read the date");
  const std::string found = fmt::format("on, good for {:.0f} days", *seen.certificate_days);
  if (*seen.certificate_days < kSoon) {
    return wrong("security", found, "teamsight keys --renew, and copy the new folders");
  }
  return fine("security", found);
}

Finding fusion(const Observed& seen) {
  if (!seen.own_fusion) {
    return wrong("fusion",
                 "this robot's fusion is not heard",
                 fmt::format("systemctl start teamsight-fusion@robot{}", seen.robot));
  }
  return fine(
      "fusion",
      seen.leader ? fmt::format("runs; robot {} leads", *seen.leader) : "runs; nobody leads");
}

Finding versions(const Observed& seen) {
  std::set<std::string> all{seen.software_version};
  for (const auto& [robot, state] : seen.heard) all.insert(state.version);
  std::string text;
  for (const std::string& version : all) text += (text.empty() ? "" : ", ") + version;
  if (all.size() == 1) return fine("versions", text);
  return wrong("versions", text, "install the same packages on every robot");
}

Finding air(const Observed& seen) {
  const std::string found = fmt::format("{:.2f} Mbit/s", 1e-6 * seen.team_bps);
  if (seen.team_bps <= kAirGoal) return fine("air", found);
  return wrong("air", found, "lower the frame rate; the league's alarm is at 2.2 Mbit/s");
}

Finding disk(const Observed& seen) {
  const std::string found = fmt::format("{:.1f} GB free", seen.disk_free_gb);
  if (seen.disk_free_gb >= kLeastDisk) return fine("disk", found);
  return wrong("disk", found, "delete old recordings");
}

}  // namespace

std::vector<Finding> findings(const Observed& seen) {
  return {identity(seen),
          camera(seen),
          calibration(seen),
          fusion(seen),
          card(seen),
          multicast(seen),
          peers(seen),
          clocks(seen),
          security(seen),
          versions(seen),
          air(seen),
          disk(seen)};
}

}  // namespace teamsight::tools
