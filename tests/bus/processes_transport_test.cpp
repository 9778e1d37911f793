// tests/bus/processes_transport_test.cpp: what holds between processes that die, hang and join
// late.
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/topics.hpp"
#include "bus/writer.hpp"
#include "tests/bus/samples.hpp"
#include "tests/bus/transport.hpp"

namespace teamsight::bus {
namespace {

using std::chrono::milliseconds;
using testing::kPatience;
using testing::own_domain;
using testing::start_child;
using testing::take_until;
using testing::wait_until;

// What the design promises after a writer has fallen silent.
constexpr Duration kNoticed = milliseconds(300);

/// Follows one instance: its presence, when it was last heard, and by whom.
template <class Message>
struct Follower {
  void operator()(const Sample<Message>& sample) {
    presence = sample.presence;
    changed = sample.received;
    if (!sample.message) return;
    ++samples;
    robot = sample.message->id.robot;
  }

  Presence presence{Presence::kAlive};
  HostTime changed;
  RobotId robot{kNobody};
  std::size_t samples{0};
};

/// Hears robot 3's states until `end_it` ends the child; how long after that it was found silent.
std::optional<Duration> time_to_silence(int signal) {
  const DomainSettings domain = own_domain();
  const Participant participant = Participant::join(domain);
  Reader<RobotState> reader(participant);
  test::ChildProcess child = start_child("states", domain, 3);
  Follower<RobotState> follower;
  const auto follow = [&](const auto& sample) {
    follower(sample);
  };
  if (!take_until(reader, follow, [&] { return follower.samples >= 20; })) return std::nullopt;
  const HostTime end = host_now();
  child.kill(signal);
  const auto silent = [&] {
    return follower.presence == Presence::kSilent;
  };
  if (!take_until(reader, follow, silent)) return std::nullopt;
  EXPECT_TRUE(wait_until([&] { return reader.live_writers() == 0; }, kPatience));
  return follower.changed - end;
}

class Silence : public ::testing::TestWithParam<int> {};

// Killed; stopped with all its threads; hung with the library's threads alive.
TEST_P(Silence, IsNoticedWithinTheLeaseAndAHundredMilliseconds) {
  const auto silent_after = time_to_silence(GetParam());

  ASSERT_TRUE(silent_after);
  EXPECT_LE(*silent_after, kNoticed);
}

INSTANTIATE_TEST_SUITE_P(KilledStoppedHung, Silence, ::testing::Values(SIGKILL, SIGSTOP, SIGUSR1));

TEST(Presence, ComesBackWithTheWriter) {
  const DomainSettings domain = own_domain();
  const Participant participant = Participant::join(domain);
  Reader<RobotState> reader(participant);
  test::ChildProcess child = start_child("states", domain, 3);
  Follower<RobotState> follower;
  const auto follow = [&](const auto& sample) {
    follower(sample);
  };
  ASSERT_TRUE(take_until(reader, follow, [&] { return follower.samples >= 5; }));
  child.kill(SIGSTOP);
  ASSERT_TRUE(take_until(reader, follow, [&] { return follower.presence == Presence::kSilent; }));

  child.kill(SIGCONT);

  EXPECT_TRUE(take_until(reader, follow, [&] { return follower.presence == Presence::kAlive; }));
  EXPECT_EQ(reader.counters().total_rejected(), 0U);
}

class Ownership : public ::testing::TestWithParam<int> {};

TEST_P(Ownership, PassesToTheNextStrongest) {
  const DomainSettings domain = own_domain();
  const Participant participant = Participant::join(domain);
  Reader<WorldModel> reader(participant);
  test::ChildProcess strong = start_child("worlds", domain, 1, 100);
  test::ChildProcess weak = start_child("worlds", domain, 2, 50);
  Follower<WorldModel> follower;
  const auto follow = [&](const auto& sample) {
    follower(sample);
  };
  ASSERT_TRUE(take_until(reader, follow, [&] { return reader.live_writers() == 2; }));
  ASSERT_TRUE(take_until(reader, follow, [&] { return follower.robot == 1; }));
  follower.samples = 0;
  std::set<RobotId> heard;
  const auto note = [&](const auto& sample) {
    follower(sample);
    if (sample.message) heard.insert(sample.message->id.robot);
  };
  ASSERT_TRUE(take_until(reader, note, [&] { return follower.samples >= 25; }));
  ASSERT_EQ(heard, std::set<RobotId>{1});  // half a second with both alive

  const HostTime end = host_now();
  strong.kill(GetParam());
  const auto changed = [&] {
    return follower.robot == 2;
  };

  ASSERT_TRUE(take_until(reader, follow, changed));
  EXPECT_LE(follower.changed - end, kNoticed);
}

INSTANTIATE_TEST_SUITE_P(KilledStoppedHung,
                         Ownership,
                         ::testing::Values(SIGKILL, SIGSTOP, SIGUSR1));

TEST(Events, ReachWhoJoinsLate) {
  const DomainSettings domain = own_domain();
  test::ChildProcess child = start_child("events", domain, 20);
  ASSERT_TRUE(wait_until([&] { return child.out() == "written\n"; }, kPatience));
  const Participant participant = Participant::join(domain);
  Reader<Command> commands(participant);
  Reader<GameState> games(participant);
  std::vector<std::uint32_t> got;
  std::vector<std::uint32_t> game;

  take_until(
      commands,
      [&](const auto& sample) { got.push_back(sample.message->command); },
      [&] { return got.size() >= 16; });
  take_until(
      games,
      [&](const auto& sample) { game.push_back(sample.message->id.sequence); },
      [&] { return !game.empty(); });

  EXPECT_THAT(got,
              ::testing::ElementsAre(5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20));
  EXPECT_THAT(game, ::testing::ElementsAre(20));
}

TEST(Events, ThatAreCommandsAreNotCarriedOutMuchLater) {
  const DomainSettings domain = own_domain();
  test::ChildProcess child = start_child("events", domain, 1);
  ASSERT_TRUE(wait_until([&] { return child.out() == "written\n"; }, kPatience));
  const Participant participant = Participant::join(domain);
  const HostTime much_later = host_now() + topic_profile<Command>().lifespan;
  ASSERT_TRUE(wait_until([&] { return host_now() >= much_later; }, kPatience));
  Reader<Command> commands(participant);
  Reader<GameState> games(participant);
  std::size_t commands_heard = 0;
  std::size_t games_heard = 0;

  take_until(
      games, [&](const auto&) { ++games_heard; }, [&] { return games_heard > 0; });
  commands.take(host_now(), [&](const auto&) { ++commands_heard; });

  EXPECT_EQ(games_heard, 1U);
  EXPECT_EQ(commands_heard, 0U);
}

TEST(Processes, TwelveMeetOnOneComputer) {
  constexpr int kProcesses = 12;
  const DomainSettings domain = own_domain();
  std::vector<test::ChildProcess> children;
  for (int i = 1; i <= kProcesses; ++i) {
    children.push_back(start_child("meet", domain, i, kProcesses));
  }

  for (test::ChildProcess& child : children) {
    EXPECT_TRUE(wait_until([&] { return child.out() == "heard all\n"; }, kPatience)) << child.err();
  }
}

TEST(Tags, KeepTeamsOfOneDomainApart) {
  const DomainSettings ours = own_domain("ours");
  DomainSettings theirs = ours;
  theirs.tag = "theirs";
  test::ChildProcess stranger = start_child("states", theirs, 5);
  test::ChildProcess mate = start_child("states", ours, 6);
  const Participant participant = Participant::join(ours);
  Reader<RobotState> reader(participant);
  std::set<RobotId> heard;
  std::size_t samples = 0;

  take_until(
      reader,
      [&](const auto& sample) {
        ++samples;
        if (sample.message) heard.insert(sample.message->id.robot);
      },
      [&] { return samples >= 100; });

  EXPECT_EQ(heard, std::set<RobotId>{6});
  EXPECT_EQ(reader.live_writers(), 1U);
}

// A second process under the same robot id: its boot tells it apart, both are heard.
TEST(Processes, UnderOneRobotIdAreToldApartByTheirWriter) {
  const DomainSettings domain = own_domain();
  test::ChildProcess first = start_child("states", domain, 5);
  test::ChildProcess second = start_child("states", domain, 5);
  const Participant participant = Participant::join(domain);
  Reader<RobotState> reader(participant);
  std::set<std::uint64_t> writers;
  std::set<std::uint64_t> instances;
  std::set<std::uint32_t> boots;

  take_until(
      reader,
      [&](const auto& sample) {
        writers.insert(sample.writer);
        instances.insert(sample.instance);
        if (sample.message) boots.insert(sample.message->id.boot);
      },
      [&] { return writers.size() >= 2; });

  EXPECT_EQ(writers.size(), 2U);
  EXPECT_EQ(instances.size(), 1U);
  EXPECT_EQ(boots.size(), 2U);
}

TEST(Reader, GivesTheLoanBackWhenTheHandlerThrows) {
  const DomainSettings domain = own_domain();
  const Participant participant = Participant::join(domain);
  Reader<RobotState> reader(participant);
  test::ChildProcess child = start_child("states", domain, 3);
  int thrown = 0;
  const auto refuse = [&](const Sample<RobotState>&) {
    ++thrown;
    throw std::runtime_error("handler");
  };

  const HostTime end = host_now() + kPatience;
  while (thrown < 50 && host_now() < end) {
    pollfd event{reader.event_fd(), POLLIN, 0};
    ::poll(&event, 1, 50);
    try {
      reader.take(host_now(), refuse);
    } catch (const std::runtime_error&) {
    }
  }

  Follower<RobotState> follower;
  EXPECT_EQ(thrown, 50);
  EXPECT_TRUE(take_until(
      reader, [&](const auto& s) { follower(s); }, [&] { return follower.samples >= 5; }));
}

}  // namespace
}  // namespace teamsight::bus
