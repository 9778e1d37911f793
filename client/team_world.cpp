// client/team_world.cpp: see client/team_world.hpp.
#include "client/team_world.hpp"

#include "bus/clock.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "client/world_choice.hpp"
#include "process/domains.hpp"
#include "process/hearing.hpp"
#include "settings/load.hpp"

namespace teamsight {
namespace {

constexpr Duration kHearingPeriod = std::chrono::milliseconds(500);
constexpr Duration kGameKept = std::chrono::seconds(3);  // told once a second

process::DomainOptions domain_options(const TeamWorldOptions& options) {
  return {options.team_domain, options.host_tag};
}

std::string host_tag(const settings::RobotSettings& robot, const TeamWorldOptions& options) {
  return options.host_tag.empty() ? process::default_host_tag(robot.team, robot.id)
                                  : options.host_tag;
}

}  // namespace

struct TeamWorld::Impl {
  Impl(const settings::RobotSettings& settings, const TeamWorldOptions& options)
      : robot(settings.id),
        team(bus::Participant::join(
            process::team_domain(settings.team, domain_options(options), settings.id))),
        host(bus::Participant::join(process::host_domain(
            settings.team, domain_options(options), host_tag(settings, options)))),
        leader_worlds(team),
        own_worlds(host),
        games(team),
        choice({}),
        hearing(team) {
    hearing.watch(leader_worlds);
  }

  RobotId robot;
  bus::Participant team;
  bus::Participant host;
  bus::Reader<WorldModel> leader_worlds;
  bus::Reader<WorldModel> own_worlds;
  bus::Reader<bus::GameState> games;
  std::optional<bus::GameState> game;
  HostTime game_heard;
  WorldChoice choice;
  process::Hearing hearing;
  HostTime listened;  // when `hearing` last looked
};

TeamWorld::TeamWorld(const std::filesystem::path& robot_file, const TeamWorldOptions& options)
    : impl_(std::make_unique<Impl>(settings::load_robot(robot_file), options)) {}

TeamWorld::TeamWorld(TeamWorld&&) noexcept = default;
TeamWorld& TeamWorld::operator=(TeamWorld&&) noexcept = default;
TeamWorld::~TeamWorld() = default;

World TeamWorld::freshest() {
  const HostTime now = bus::host_now();
  impl_->leader_worlds.take(now, [&](const bus::Sample<WorldModel>& sample) {
    if (sample.message) impl_->choice.heard_leader(*sample.message, now);
  });
  impl_->own_worlds.take(now, [&](const bus::Sample<WorldModel>& sample) {
    if (sample.message) impl_->choice.heard_own_host(*sample.message);
  });
  if (now - impl_->listened >= kHearingPeriod) {
    impl_->listened = now;
    impl_->hearing.look(now);
  }
  return impl_->choice.freshest(now);
}

std::optional<bus::GameState> TeamWorld::game() {
  const HostTime now = bus::host_now();
  impl_->games.take(now, [&](const bus::Sample<bus::GameState>& sample) {
    if (!sample.message) return;
    impl_->game = *sample.message;
    impl_->game_heard = now;
  });
  if (now - impl_->game_heard > kGameKept) impl_->game.reset();
  return impl_->game;
}

RobotId TeamWorld::robot() const noexcept {
  return impl_->robot;
}

}  // namespace teamsight
