// process/identity_guard.cpp: see identity_guard.hpp.
#include "process/identity_guard.hpp"

#include "process/meter.hpp"
#include "process/program.hpp"

namespace teamsight::process {
namespace {

constexpr std::size_t kMostWords = 95;  // of a report's message

}  // namespace

Rivalry judge_rival(const ObservationId& own, const ObservationId& heard) {
  if (heard.robot != own.robot || heard.boot == own.boot) {
    return Rivalry::kNone;
  }
  if (own.sequence / 2 > heard.sequence) {
    return Rivalry::kStay;
  }
  if (heard.sequence / 2 > own.sequence) {
    return Rivalry::kYield;
  }
  return own.boot > heard.boot ? Rivalry::kYield : Rivalry::kStay;
}

std::string words_on_rival(RobotId robot, const bus::Computer& of_the_other) {
  const std::string id = "robot id " + std::to_string(robot);
  if (of_the_other.is_this) return id + " is used twice on this computer: end one of the two";
  std::string words =
      id + " is used on " + bus::to_text(of_the_other) + " too: give one robot another id";
  if (words.size() > kMostWords) words.resize(kMostWords);
  return words;
}

bus::Diagnostics last_report(const std::string& process,
                             RobotId robot,
                             const std::string& words,
                             HostTime now) {
  ProcessMeter meter("second " + process, robot, draw_boot_id());
  bus::Diagnostics report = meter.report(now);
  report.healthy = false;
  report.message = words;
  return report;
}

}  // namespace teamsight::process
