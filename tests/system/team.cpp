// tests/system/team.cpp: see team.hpp.
#include "tests/system/team.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "bus/clock.hpp"
#include "process/domains.hpp"
#include "settings/load.hpp"

namespace teamsight::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kListenerBoot = 4242;

void write(const fs::path& path, const std::string& text, std::ios::openmode mode) {
  std::ofstream file(path, mode);
  file << text;
  if (!file.flush()) {
    throw std::runtime_error("cannot write " + path.string());
  }
}

std::vector<std::string> on_own_domain(std::vector<std::string> argv) {
  argv.insert(argv.end(), {"--team-domain", std::to_string(unique_domain())});
  return argv;
}

}  // namespace

ConfigCopy::ConfigCopy() {
  fs::copy(source_path("config"), directory_.path() / "config", fs::copy_options::recursive);
}

std::string ConfigCopy::file(const std::string& relative) const {
  return (directory_.path() / "config" / relative).string();
}

void ConfigCopy::append(const std::string& relative, const std::string& lines) const {
  write(file(relative), lines, std::ios::app);
}

void ConfigCopy::replace(const std::string& relative, const std::string& text) const {
  write(file(relative), text, std::ios::trunc);
}

std::unique_ptr<ChildProcess> Team::agent(int id,
                                          const std::string& source,
                                          std::vector<std::string> more) const {
  std::vector<std::string> argv{
      program("teamsight-agent").string(),
      "--robot",
      config_.file("robots/" + robots_ + std::to_string(id) + ".textproto"),
      "--source",
      source};
  argv.insert(argv.end(), more.begin(), more.end());
  return std::make_unique<ChildProcess>(on_own_domain(argv));
}

std::unique_ptr<ChildProcess> Team::fusion(int id) const {
  return std::make_unique<ChildProcess>(
      on_own_domain({program("teamsight-fusion").string(),
                     "--robot",
                     config_.file("robots/" + robots_ + std::to_string(id) + ".textproto")}));
}

std::unique_ptr<ChildProcess> Team::monitor(const std::string& team_file,
                                            const std::filesystem::path& web) const {
  return std::make_unique<ChildProcess>(on_own_domain({program("teamsight-monitor").string(),
                                                       "--team",
                                                       config_.file(team_file),
                                                       "--port",
                                                       "0",
                                                       "--web",
                                                       web.string()}));
}

std::unique_ptr<ChildProcess> Team::simulator() const {
  return std::make_unique<ChildProcess>(on_own_domain({program("teamsight-sim").string(),
                                                       "--match",
                                                       config_.file("matches/demo.textproto"),
                                                       "--frames",
                                                       frames().string()}));
}

std::string Team::stream(int id) const {
  return "stream:" + (frames() / ("robot" + std::to_string(id) + ".stream")).string();
}

bus::Participant Team::join(const std::string& team_file) const {
  return bus::Participant::join(
      process::team_domain(settings::load_team(config_.file(team_file)), {unique_domain(), {}}));
}

Listener::Listener(const bus::Participant& team)
    : worlds_(team),
      state_reader_(team),
      diagnostics_reader_(team),
      commands_(team) {}

void Listener::listen() {
  const HostTime now = bus::host_now();
  worlds_.take(now, [this](const bus::Sample<WorldModel>& sample) {
    if (sample.message.has_value()) {
      world = sample.message;
    }
  });
  state_reader_.take(now, [this](const bus::Sample<bus::RobotState>& sample) {
    if (sample.message.has_value()) {
      states[sample.message->id.robot] = *sample.message;
    }
  });
  diagnostics_reader_.take(now, [this](const bus::Sample<bus::Diagnostics>& sample) {
    if (sample.message.has_value()) {
      diagnostics[sample.message->process] = *sample.message;
    }
  });
}

std::optional<WorldTeammate> Listener::teammate(RobotId robot) const {
  if (!world.has_value()) {
    return std::nullopt;
  }
  const auto& all = world->teammates;
  const auto mate = std::find_if(
      all.begin(), all.end(), [robot](const WorldTeammate& one) { return one.robot == robot; });
  return mate == all.end() ? std::nullopt : std::optional(*mate);
}

std::uint32_t Listener::relocate(RobotId robot, const Pose<Field, Robot>& X_FR) {
  bus::Command command;
  command.id = {kNobody, kListenerBoot, ++command_};
  command.target = robot;
  command.command = command_;
  command.kind = bus::CommandKind::kRelocate;
  command.X_FR = X_FR;
  command.cov = Eigen::Vector3d(0.25, 0.25, 0.1).asDiagonal();
  if (commands_.write(command) != bus::WriteStatus::kWritten) {
    throw std::runtime_error("the command was not written");
  }
  return command_;
}

}  // namespace teamsight::test
