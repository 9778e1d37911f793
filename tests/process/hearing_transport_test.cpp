// tests/process/hearing_transport_test.cpp: a quiet topic's writer that a forged packet shut out is
// let in again.
#include <csignal>

#include <gtest/gtest.h>

#include "bus/clock.hpp"
#include "process/hearing.hpp"
#include "tests/bus/forger.hpp"
#include "tests/bus/transport.hpp"

namespace teamsight::process {
namespace {

using bus::testing::announced_writer;
using bus::testing::forge_number;
using bus::testing::kPatience;
using bus::testing::own_domain;
using bus::testing::start_child;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr char kDiagnostics[] = "teamsight/v1/Diagnostics";

RejoinParameters hasty() {
  RejoinParameters parameters;
  parameters.quiet_patience = milliseconds(1500);
  parameters.pause = milliseconds(500);
  parameters.memory = seconds(2);
  return parameters;
}

/// A process that hears another one's reports, and its states if there are any.
class QuietTopic : public ::testing::Test {
 protected:
  /// Listens, as a process does, until the claim holds or the bound.
  template <class Claim>
  bool listen_until(const Claim& claim, milliseconds bound) {
    return test::wait_until(
        [&] {
          const HostTime now = bus::host_now();
          states_.take(now, [](const auto&) {});
          reports_.take(now, [](const auto&) {});
          hearing_.look(now);
          return claim();
        },
        bound);
  }

  [[nodiscard]] std::uint64_t heard() const { return reports_.counters().accepted; }

  /// @return whether nothing more is heard of the reports
  bool silence_reports() {
    const auto name = announced_writer(team_, kDiagnostics);
    if (!name) return false;
    forge_number(*name, domain_.domain_id);
    listen_until([] { return false; }, milliseconds(300));
    const std::uint64_t before = heard();
    return !listen_until([&] { return heard() > before; }, milliseconds(300));
  }

  bus::DomainSettings domain_ = own_domain();
  bus::Participant team_ = bus::Participant::join(domain_);
  bus::Reader<bus::RobotState> states_{team_};
  bus::Reader<bus::Diagnostics> reports_{team_};
  Hearing hearing_{team_, hasty()};
};

class TopicBeside : public QuietTopic {
 protected:
  TopicBeside() { hearing_.watch_beside(reports_, states_); }
};

class TopicOfEverybody : public QuietTopic {
 protected:
  TopicOfEverybody() { hearing_.watch_always(reports_, states_); }
};

TEST_F(TopicBeside, IsHeardAgainWhereItsProcessIsHeardElsewhere) {
  const test::ChildProcess child = start_child("reports", domain_, 3, 1);
  ASSERT_TRUE(listen_until([this] { return heard() > 5; }, kPatience));
  ASSERT_TRUE(silence_reports());
  const std::uint64_t before = heard();

  EXPECT_TRUE(listen_until([&] { return heard() > before + 5; }, kPatience));
  EXPECT_EQ(hearing_.times(), 1U);
}

TEST_F(TopicBeside, IsLeftAloneWhereNothingElseSaysThatItsProcessLives) {
  const test::ChildProcess child = start_child("reports", domain_, 3);
  ASSERT_TRUE(listen_until([this] { return heard() > 5; }, kPatience));
  ASSERT_TRUE(silence_reports());
  const std::uint64_t before = heard();

  EXPECT_FALSE(listen_until([&] { return heard() > before; }, seconds(3)));
  EXPECT_EQ(hearing_.times(), 0U);
}

TEST_F(TopicOfEverybody, IsHeardAgainThoughNothingElseSaysThatItsProcessLives) {
  const test::ChildProcess child = start_child("reports", domain_, 3);
  ASSERT_TRUE(listen_until([this] { return heard() > 5; }, kPatience));
  ASSERT_TRUE(silence_reports());
  const std::uint64_t before = heard();

  EXPECT_TRUE(listen_until([&] { return heard() > before + 5; }, kPatience));
  EXPECT_EQ(hearing_.times(), 1U);
}

TEST_F(TopicOfEverybody, MakesOneJoinAnewOnceForAProcessThatHangs) {
  test::ChildProcess child = start_child("reports", domain_, 3);
  ASSERT_TRUE(listen_until([this] { return heard() > 5; }, kPatience));
  child.kill(SIGUSR1);

  EXPECT_TRUE(listen_until([&] { return hearing_.times() == 1; }, kPatience));
  EXPECT_FALSE(listen_until([&] { return hearing_.times() > 1; }, seconds(4)));
}

TEST_F(TopicOfEverybody, IsNotNeededToSeeThatARobotDoesNotHear) {
  hearing_.look(bus::host_now());
  EXPECT_EQ(hearing_.times(), 0U);

  for (int i = 0; i < 3; ++i) {
    hearing_.note_unanswered(3);
    hearing_.look(bus::host_now());
  }

  EXPECT_EQ(hearing_.times(), 1U) << "once a minute";
}

}  // namespace
}  // namespace teamsight::process
