// tests/bus/bus_test_child.cpp: the other process of the transport tests. First argument: what to
// do.
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <tuple>

#include <dds/dds.h>
#include <teamsight.h>
#include <unistd.h>

#include "bus/clock.hpp"
#include "bus/entity.hpp"
#include "bus/loop.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "tests/bus/samples.hpp"

namespace {

using namespace teamsight;
using namespace teamsight::bus;
using std::chrono::milliseconds;

// SIGUSR1: the process hangs as a program does whose main thread is stuck; the library's go on.
std::atomic<bool> hanging{false};

struct Job {
  std::string what;
  DomainSettings domain;
  int number{0};
  int second_number{0};
};

// As every start of a program has: two processes under one robot id differ in it.
std::uint32_t own_boot() {
  return static_cast<std::uint32_t>(::getpid());
}

RobotState state_now(RobotId robot, std::uint32_t sequence) {
  auto message = bus::testing::full<RobotState>();
  message.id = {robot, own_boot(), sequence};
  message.exposure = message.published = stamp_of(host_now());
  return message;
}

WorldModel world_now(RobotId robot, std::uint32_t sequence, int strength) {
  auto message = bus::testing::full<WorldModel>();
  message.id = {robot, own_boot(), sequence};
  message.strength = static_cast<std::uint16_t>(strength);
  message.stamp = stamp_of(host_now());
  return message;
}

// Writes RobotState as robot `number` at 50 Hz, for ever.
void write_states(const Job& job) {
  Loop loop;
  const Participant participant = Participant::join(job.domain);
  Writer<RobotState> writer(participant);
  std::uint32_t sequence = 0;
  loop.every(milliseconds(20), [&] {
    if (!hanging) writer.write(state_now(static_cast<RobotId>(job.number), ++sequence));
  });
  loop.run();
}

// Writes Diagnostics as robot `number` at 20 Hz, for ever, and RobotState too if `second_number` is
// not 0.
void write_reports(const Job& job) {
  Loop loop;
  const Participant participant = Participant::join(job.domain);
  Writer<Diagnostics> reports(participant);
  Writer<RobotState> states(participant);
  const auto robot = static_cast<RobotId>(job.number);
  std::uint32_t sequence = 0;
  loop.every(milliseconds(50), [&] {
    if (hanging) return;
    auto report = bus::testing::full<Diagnostics>();
    report.id = {robot, own_boot(), ++sequence};
    report.stamp = stamp_of(host_now());
    reports.write(report);
    if (job.second_number != 0) states.write(state_now(robot, sequence));
  });
  loop.run();
}

// Writes WorldModel as robot `number` with strength `second_number` at 50 Hz, for ever.
void write_worlds(const Job& job) {
  Loop loop;
  const Participant participant = Participant::join(job.domain);
  Writer<WorldModel> writer(participant, job.second_number);
  std::uint32_t sequence = 0;
  loop.every(milliseconds(20), [&] {
    if (hanging) return;
    writer.write(world_now(static_cast<RobotId>(job.number), ++sequence, job.second_number));
  });
  loop.run();
}

// Writes `number` commands and one game state at once, then stays.
void write_events(const Job& job) {
  Loop loop;
  const Participant participant = Participant::join(job.domain);
  Writer<GameState> games(participant);
  Writer<Command> commands(participant);
  for (int i = 1; i <= job.number; ++i) {
    auto game = bus::testing::full<GameState>();
    game.id.sequence = static_cast<std::uint32_t>(i);
    games.write(game);
    auto command = bus::testing::full<Command>();
    command.id.sequence = command.command = static_cast<std::uint32_t>(i);
    commands.write(command);
  }
  std::puts("written");
  std::fflush(stdout);
  loop.run();
}

// As robot `number` of `second_number`, writes and reads until it has heard all others; then goes
// on writing for those that are not as far.
void meet(const Job& job) {
  Loop loop;
  const Participant participant = Participant::join(job.domain);
  Writer<RobotState> writer(participant);
  Reader<RobotState> reader(participant);
  std::set<RobotId> heard;
  std::uint32_t sequence = 0;
  loop.on_readable(reader.event_fd(), [&] {
    reader.take(host_now(), [&](const Sample<RobotState>& sample) {
      if (!sample.message) return;
      const bool is_new = heard.insert(sample.message->id.robot).second;
      if (is_new && heard.size() + 1 == static_cast<std::size_t>(job.second_number)) {
        std::puts("heard all");
        std::fflush(stdout);
      }
    });
  });
  loop.every(milliseconds(20),
             [&] { writer.write(state_now(static_cast<RobotId>(job.number), ++sequence)); });
  loop.run();
}

// Writes the full message of every topic every 20 ms, for ever.
template <class... Messages>
void write_every_topic(const Job& job) {
  Loop loop;
  const Participant participant = Participant::join(job.domain);
  std::tuple<Writer<Messages>...> writers{Writer<Messages>(participant)...};
  std::uint32_t sequence = 0;
  loop.every(milliseconds(20), [&] {
    ++sequence;
    const auto write = [&](auto message, auto& writer) {
      message.id.sequence = sequence;
      writer.write(message);
    };
    (write(bus::testing::full<Messages>(), std::get<Writer<Messages>>(writers)), ...);
  });
  loop.run();
}

// Reads commands, for ever.
void read_commands(const Job& job) {
  Loop loop;
  const Participant participant = Participant::join(job.domain);
  Reader<Command> reader(participant);
  loop.on_readable(reader.event_fd(), [&] { reader.take(host_now(), [](const auto&) {}); });
  loop.run();
}

// Joins as a process of the team does: for as long as it takes.
void join_patiently(const Job& job) {
  Loop loop;
  bool tried = false;
  const Participant participant = Participant::join(job.domain, [&] {
    if (!tried) std::puts("trying");
    std::fflush(stdout);
    tried = true;
    return loop.keeps_running();
  });
  std::puts("joined");
}

// Waits `number` ms inside the library and prints how long it took, in ms.
void wait_in_library(const Job& job) {
  const Participant participant = Participant::join(job.domain);
  const dds_entity_t waitset = dds_create_waitset(participant.handle());
  const dds_entity_t never = dds_create_guardcondition(participant.handle());
  dds_waitset_attach(waitset, never, 0);
  const HostTime start = host_now();
  dds_waitset_wait(waitset, nullptr, 0, DDS_MSECS(job.number));
  std::printf(
      "%lld\n",
      static_cast<long long>(std::chrono::duration_cast<milliseconds>(host_now() - start).count()));
  dds_delete(waitset);
}

// A process of a later version, as far as DDS tells others of it: its topics have other names.
void speak_other_version(const Job& job) {
  const Participant participant = Participant::join(job.domain);
  const Entity topic(dds_create_topic(participant.handle(),
                                      &teamsight_v1_RobotState_desc,
                                      "teamsight/v9/RobotState",
                                      nullptr,
                                      nullptr));
  const Entity writer(dds_create_writer(participant.handle(), topic.handle(), nullptr, nullptr));
  if (writer.handle() < 0) throw BusError("no writer");
  Loop().run();
}

void run(const Job& job) {
  if (job.what == "states") return write_states(job);
  if (job.what == "reports") return write_reports(job);
  if (job.what == "worlds") return write_worlds(job);
  if (job.what == "events") return write_events(job);
  if (job.what == "meet") return meet(job);
  if (job.what == "every topic") {
    return write_every_topic<RobotState,
                             Sightings,
                             VirtualSensors,
                             Odometry,
                             WorldModel,
                             Explanation,
                             ClockProbe,
                             ClockEcho,
                             GameState,
                             Command,
                             Diagnostics,
                             LinePoints,
                             Thumbnail,
                             Truth>(job);
  }
  if (job.what == "commands") return read_commands(job);
  if (job.what == "patient") return join_patiently(job);
  if (job.what == "other version") return speak_other_version(job);
  if (job.what == "wait") return wait_in_library(job);
  std::fprintf(stderr, "unknown job %s\n", job.what.c_str());
  std::exit(2);
}

}  // namespace

// bus_test_child WHAT PROFILE DOMAIN TAG [NUMBER [NUMBER]]
int main(int count, char** arguments) {
  if (count < 5) return 2;
  std::signal(SIGUSR1, [](int) { hanging = true; });
  const auto number = [&](int i) {
    return i < count ? std::atoi(arguments[i]) : 0;
  };
  const Job job{arguments[1],
                {static_cast<std::uint32_t>(number(3)), arguments[2], arguments[4]},
                number(5),
                number(6)};
  try {
    run(job);
  } catch (const BusError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
