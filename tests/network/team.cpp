// tests/network/team.cpp: see team.hpp.
#include "tests/network/team.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "bus/clock.hpp"
#include "tests/network/writer_list.hpp"

namespace teamsight::network {
namespace {

namespace fs = std::filesystem;

void write_file(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

ProcessSize size_of(pid_t pid) {
  const fs::path directory = "/proc/" + std::to_string(pid);
  ProcessSize size;
  std::ifstream status(directory / "status");
  for (std::string line; std::getline(status, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "VmRSS:") words >> size.resident_kb;
    if (key == "Threads:") words >> size.threads;
  }
  std::error_code ignored;
  for (auto i = fs::directory_iterator(directory / "fd", ignored); i != fs::directory_iterator();
       i.increment(ignored)) {
    ++size.handles;
  }
  return size;
}

}  // namespace

std::int64_t now_ns() {
  return bus::host_now().time_since_epoch().count();
}

void pause(std::chrono::milliseconds duration) {
  std::this_thread::sleep_for(duration);  // a fault lasts as long as it lasts
}

Team::Team(Hosts& hosts, const TeamOptions& options)
    : hosts_(&hosts),
      options_(options),
      members_(options.robots) {
  write_configuration();
}

fs::path Team::file(const std::string& relative) const {
  return directory_.path() / relative;
}

void Team::write_configuration() const {
  fs::copy(test::source_path("config"), directory_.path(), fs::copy_options::recursive);
  write_file(file("teams/bench.textproto"),
             "name: \"" + options_.name + "\"\nfield: \"../fields/msl-2024.textproto\"\n" +
                 "domain_id: 40\ndds_profile: \"../dds/" + options_.profile +
                 ".xml\"\nhost_profile: \"../dds/host.xml\"\n" + options_.more_team_lines);
  for (RobotId robot = 1; robot <= options_.robots; ++robot) {
    const std::string id = std::to_string(robot);
    write_file(robot_file(robot),
               "id: " + id + "\nteam: \"../teams/bench.textproto\"\n" +
                   "camera: \"../cameras/sim-640.textproto\"\nstrength: " + id + "0\n");
  }
  write_peers();
  if (options_.secured) make_keys();
  write_file(file("index.html"), "<!doctype html><title>bench</title>");
  write_file(file("clock"), std::string(sizeof(std::int64_t), '\0'));
}

void Team::make_keys() const {
  std::string ids;
  for (int robot = 1; robot <= options_.robots; ++robot) {
    ids += (ids.empty() ? "" : ",") + std::to_string(robot);
  }
  const std::string team = file("teams/bench.textproto").string();
  test::ChildProcess keys({test::program("teamsight").string(),
                           "keys",
                           "--out",
                           file("keys").string(),
                           "--team",
                           team,
                           "--robots",
                           ids});
  if (keys.wait_exit(std::chrono::seconds(30)) != 0) {
    throw std::runtime_error("teamsight keys: " + keys.err());
  }
  std::ofstream(team, std::ios::app) << "security: \"../keys\"\n";
}

// The unicast profile names the team's computers; here they have other addresses.
void Team::write_peers() const {
  const fs::path path = file("dds/unicast.xml");
  std::ifstream in(path);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const std::size_t begin = text.find("<Peers>");
  const std::size_t end = text.find("</Peers>");
  if (begin == std::string::npos || end == std::string::npos)
    throw std::runtime_error("no <Peers>");
  std::string peers = "<Peers>";
  for (std::size_t host = 0; host < hosts_->count(); ++host) {
    peers += "<Peer Address=\"" + Hosts::address(host) + "\"/>";
  }
  write_file(path, text.replace(begin, end - begin, peers));
}

std::string Team::robot_file(RobotId robot) const {
  return file("robots/bench" + std::to_string(robot) + ".textproto").string();
}

fs::path Team::log_of(RobotId robot) const {
  return file("sights" + std::to_string(robot));
}

std::unique_ptr<test::ChildProcess> Team::spawn(std::size_t host,
                                                const std::vector<std::string>& argv,
                                                bool has_loose_clock) const {
  test::ChildProcess::Environment environment;
  if (has_loose_clock) {
    environment = {{"LD_PRELOAD", LOOSE_CLOCK}, {"TEAMSIGHT_LOOSE_CLOCK", file("clock").string()}};
  }
  return std::make_unique<test::ChildProcess>(hosts_->on_host(host, argv), environment);
}

void Team::start(RobotId robot) {
  start_as(robot, robot);
}

void Team::start_as(RobotId robot, RobotId said) {
  const auto ahead =
      std::chrono::duration_cast<std::chrono::seconds>(Hosts::clock_ahead(host(robot)));
  of(robot).agent = spawn(host(robot),
                          {BENCH_ROBOT,
                           "--robot",
                           robot_file(robot),
                           "--log",
                           log_of(robot).string(),
                           "--rate-hz",
                           std::to_string(options_.rate_hz),
                           "--clock-ahead-s",
                           std::to_string(ahead.count()),
                           "--speak-as",
                           std::to_string(said),
                           "--writers",
                           file("writers" + std::to_string(robot)).string()},
                          robot == options_.with_loose_clock);
  start_fusion(robot);
}

void Team::start_fusion(RobotId robot) {
  of(robot).fusion =
      spawn(host(robot),
            {test::program("teamsight-fusion").string(), "--robot", robot_file(robot)},
            robot == options_.with_loose_clock);
}

void Team::start_coach() {
  coach_ = spawn(options_.first_host + options_.robots,
                 {test::program("teamsight-monitor").string(),
                  "--team",
                  file("teams/bench.textproto").string(),
                  "--web",
                  directory_.path().string()});
}

void Team::start_all() {
  for (RobotId robot = 1; robot <= options_.robots; ++robot) start(robot);
  if (options_.has_coach) start_coach();
}

const std::vector<Sight>& Team::sights(RobotId robot) {
  Member& member = of(robot);
  std::ifstream log(log_of(robot), std::ios::binary);
  log.seekg(static_cast<std::streamoff>(member.read));
  Sight sight;
  while (log.read(reinterpret_cast<char*>(&sight), sizeof sight)) {
    member.read += sizeof sight;
    member.sights.push_back(sight);
  }
  return member.sights;
}

void Team::jump_wall_clock(std::chrono::seconds ahead) const {
  std::fstream clock(file("clock"), std::ios::binary | std::ios::in | std::ios::out);
  const std::int64_t seconds = ahead.count();
  clock.write(reinterpret_cast<const char*>(&seconds), sizeof seconds);
}

std::vector<std::pair<std::string, ProcessSize>> Team::sizes() {
  std::vector<std::pair<std::string, ProcessSize>> all;
  for (RobotId robot = 1; robot <= options_.robots; ++robot) {
    const Member& member = of(robot);
    const std::string id = std::to_string(robot);
    if (member.agent) all.emplace_back("agent/" + id, size_of(member.agent->pid()));
    if (member.fusion) all.emplace_back("fusion/" + id, size_of(member.fusion->pid()));
  }
  if (coach_) all.emplace_back("monitor", size_of(coach_->pid()));
  return all;
}

std::string Team::complaints() {
  std::string all;
  for (const Member& member : members_) {
    if (member.agent) all += member.agent->err();
    if (member.fusion) all += member.fusion->err();
  }
  if (coach_) all += coach_->err();
  return all.substr(0, 1000);
}

std::map<WriterGuid, std::string> Team::writers(RobotId robot) {
  of(robot).agent->end();
  return read_writers(file("writers" + std::to_string(robot)).string());
}

}  // namespace teamsight::network
