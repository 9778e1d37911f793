// tests/bus/rejoin_transport_test.cpp: a forged sequence number shuts a live writer out; joining
// anew lets it in again.
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/writer.hpp"
#include "tests/bus/forger.hpp"
#include "tests/bus/samples.hpp"
#include "tests/bus/transport.hpp"

namespace teamsight::bus {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::kPatience;
using testing::own_domain;
using testing::start_child;
using testing::take_until;
using testing::wait_until;

constexpr Duration kQuiet = milliseconds(300);

class ForgedNumber : public ::testing::Test {
 protected:
  ForgedNumber()
      : domain_(own_domain()),
        participant_(Participant::join(domain_)),
        reader_(participant_),
        child_(start_child("states", domain_, 3)) {}

  bool hears(std::size_t more) {
    const std::uint64_t before = reader_.counters().accepted;
    return take_until(
        reader_,
        [](const auto&) {},
        [&] { return reader_.counters().accepted >= before + more; },
        seconds(5));
  }

  void take_for(Duration time) {
    take_until(
        reader_, [](const auto&) {}, [] { return false; }, time);
  }

  DomainSettings domain_;
  Participant participant_;
  Reader<RobotState> reader_;
  test::ChildProcess child_;
};

TEST_F(ForgedNumber, LeavesALiveWriterUnheardUntilOneJoinsAnew) {
  ASSERT_TRUE(hears(20));
  const auto name = testing::announced_writer(participant_, "teamsight/v1/RobotState");
  ASSERT_TRUE(name);
  EXPECT_THAT(reader_.unheard_writers(host_now(), kQuiet), ::testing::IsEmpty());

  testing::forge_number(*name, domain_.domain_id);
  take_for(kQuiet);
  const std::uint64_t before = reader_.counters().accepted;
  take_for(2 * kQuiet);

  ASSERT_EQ(reader_.counters().accepted, before);
  EXPECT_EQ(reader_.live_writers(), 1U);
  EXPECT_THAT(reader_.unheard_writers(host_now(), kQuiet), ::testing::ElementsAre(*name));

  ASSERT_TRUE(participant_.rejoin());

  EXPECT_TRUE(hears(20));
  EXPECT_THAT(reader_.unheard_writers(host_now(), kQuiet), ::testing::IsEmpty());
}

class Unheard : public ForgedNumber, public ::testing::WithParamInterface<int> {};

TEST_P(Unheard, IsNobodyThatHangsOrHasDied) {
  ASSERT_TRUE(hears(20));

  child_.kill(GetParam());
  take_for(seconds(1));

  EXPECT_THAT(reader_.unheard_writers(host_now(), kQuiet), ::testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(HungKilled, Unheard, ::testing::Values(SIGUSR1, SIGKILL));

TEST(Rejoin, ReadersAndWritersGoOn) {
  const DomainSettings domain = own_domain();
  Participant participant = Participant::join(domain);
  Writer<RobotState> writer(participant);
  Reader<RobotState> reader(participant);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(participant.rejoin());

  test::ChildProcess child = start_child("meet", domain, 2, 2);
  auto state = testing::full<RobotState>();
  state.id = {1, 7, 0};
  const auto have_met = [&] {
    ++state.id.sequence;
    state.exposure = state.published = stamp_of(host_now());
    writer.write(state);
    return child.out() == "heard all\n" && reader.counters().accepted > 0;
  };
  EXPECT_TRUE(take_until(
      reader, [](const auto&) {}, have_met));
  EXPECT_EQ(writer.counters().failed, 0U);
}

}  // namespace
}  // namespace teamsight::bus
