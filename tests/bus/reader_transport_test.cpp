// tests/bus/reader_transport_test.cpp: what a reader does with samples that no honest writer sends.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <dds/dds.h>
#include <gtest/gtest.h>

#include "bus/qos.hpp"
#include "bus/reader.hpp"
#include "bus/topics.hpp"
#include "bus/wire.hpp"
#include "bus/writer.hpp"
#include "tests/bus/samples.hpp"
#include "tests/bus/transport.hpp"

namespace teamsight::bus {
namespace {

using testing::full;
using testing::kPatience;
using testing::own_domain;
using testing::take_until;
using testing::wait_until;

/// Writes RobotState past every check of ours, and reads it with a Reader.
class Intruder : public ::testing::Test {
 protected:
  void SetUp() override {
    EXPECT_FALSE(to_wire(full<RobotState>(), wire_));
    ASSERT_TRUE(wait_until([&] { return reader_.live_writers() == 1; }, kPatience));
    send();  // one good sample first
    ASSERT_EQ(reader_.counters().accepted, 1U);
    good_ = wire_.sample;
  }

  /// Writes the sample and waits until the reader has judged it.
  void send() {
    const std::uint64_t before = judged();
    ASSERT_EQ(dds_write(writer_.handle(), &wire_.sample), DDS_RETCODE_OK);
    ASSERT_TRUE(take_until(
        reader_,
        [&](const auto& sample) { handed_over_ += sample.message ? 1U : 0U; },
        [&] { return judged() > before; }));
  }

  /// How often the reader has refused for this reason.
  [[nodiscard]] std::uint64_t refused(Reject reason) const {
    return reader_.counters().rejected[static_cast<std::size_t>(reason)];
  }

  [[nodiscard]] std::uint64_t judged() const {
    return reader_.counters().accepted + reader_.counters().total_rejected();
  }

  void next() {
    wire_.sample = good_;
    wire_.sample.sample.sequence_number += 1;
  }

  DomainSettings domain_ = own_domain();
  Participant here_ = Participant::join(domain_);
  Participant there_ = Participant::join(domain_);
  Reader<RobotState> reader_{there_};
  Entity topic_{dds_create_topic(here_.handle(),
                                 &topic_descriptor<RobotState>(),
                                 std::string(topic_profile<RobotState>().topic).c_str(),
                                 nullptr,
                                 nullptr)};
  QosPointer qos_ = writer_qos(topic_profile<RobotState>(), 0);
  Entity writer_{dds_create_writer(here_.handle(), topic_.handle(), qos_.get(), nullptr)};
  WireSample<RobotState> wire_;
  teamsight_v1_RobotState good_{};
  std::size_t handed_over_{0};
};

TEST_F(Intruder, IsRefusedWithTheReasonCounted) {
  next();
  wire_.sample.posture.posture.y_m = std::nanf("");
  send();
  next();
  wire_.sample.posture.posture.cov[3] = -1.0F;
  send();
  next();
  wire_.sample.sample.robot_id = 4;
  send();
  next();
  wire_.sample.sees_ball = 7;
  send();
  next();
  wire_.sample.posture.inlier_ratio = 2.0F;
  send();
  next();
  wire_.sample.exposure_ns = -1;
  send();

  EXPECT_EQ(refused(Reject::kNotFinite), 1U);
  EXPECT_EQ(refused(Reject::kBadCovariance), 1U);
  EXPECT_EQ(refused(Reject::kBadIdentity), 1U);
  EXPECT_EQ(refused(Reject::kBadEnum), 1U);
  EXPECT_EQ(refused(Reject::kOutOfRange), 1U);
  EXPECT_EQ(refused(Reject::kImplausibleStamp), 1U);
  EXPECT_EQ(handed_over_, 1U);
}

TEST_F(Intruder, ThatRepeatsAnOldSampleIsRefused) {
  send();
  wire_.sample.sample.sequence_number -= 1;
  send();

  EXPECT_EQ(refused(Reject::kDuplicate), 2U);
  EXPECT_EQ(handed_over_, 1U);
}

TEST_F(Intruder, WhoseStampsJumpIsRefused) {
  next();
  wire_.sample.exposure_ns += 10'000'000'000;
  wire_.sample.publish_ns += 10'000'000'000;
  send();

  EXPECT_EQ(refused(Reject::kImplausibleStamp), 1U);
  EXPECT_EQ(handed_over_, 1U);
}

TEST_F(Intruder, DoesNotKeepTheNextGoodSampleOut) {
  next();
  wire_.sample.omega_radps = std::nanf("");
  send();
  next();
  wire_.sample.sample.sequence_number += 3;
  send();

  EXPECT_EQ(handed_over_, 2U);
  EXPECT_EQ(reader_.counters().lost, 3U);
}

TEST_F(Intruder, ThatIsRefusedAndGoneStillShowsAsSilent) {
  next();
  wire_.sample.omega_radps = std::nanf("");
  ASSERT_EQ(dds_write(writer_.handle(), &wire_.sample), DDS_RETCODE_OK);
  writer_ = Entity();
  Presence presence = Presence::kAlive;
  bool with_message = false;

  take_until(
      reader_,
      [&](const auto& sample) {
        presence = sample.presence;
        with_message = with_message || sample.message.has_value();
      },
      [&] { return presence != Presence::kAlive; });

  EXPECT_EQ(presence, Presence::kSilent);
  EXPECT_FALSE(with_message);
}

TEST_F(Intruder, ThatDisposesShowsAsGone) {
  ASSERT_EQ(dds_dispose(writer_.handle(), &wire_.sample), DDS_RETCODE_OK);
  Presence presence = Presence::kAlive;

  take_until(
      reader_,
      [&](const auto& sample) { presence = sample.presence; },
      [&] { return presence != Presence::kAlive; });

  EXPECT_EQ(presence, Presence::kGone);
}

TEST(Leaving, RightAfterAWriteShowsOnTheSampleItself) {
  const DomainSettings domain = own_domain();
  const Participant here = Participant::join(domain);
  const Participant there = Participant::join(domain);
  Reader<RobotState> reader(there);
  auto writer = std::make_unique<Writer<RobotState>>(here);
  ASSERT_TRUE(wait_until([&] { return writer->live_readers() == 1; }, kPatience));
  ASSERT_EQ(writer->write(full<RobotState>()), WriteStatus::kWritten);
  writer.reset();
  ASSERT_TRUE(wait_until([&] { return reader.live_writers() == 0; }, kPatience));
  std::vector<Sample<RobotState>> got;

  reader.take(host_now(), [&](const auto& sample) { got.push_back(sample); });

  ASSERT_EQ(got.size(), 1U);
  EXPECT_TRUE(got[0].message);
  EXPECT_EQ(got[0].presence, Presence::kSilent);
}

TEST(Writer, SendsNothingThatItsReadersWouldRefuse) {
  const DomainSettings domain = own_domain();
  const Participant here = Participant::join(domain);
  const Participant there = Participant::join(domain);
  Writer<RobotState> writer(here);
  Reader<RobotState> reader(there);
  ASSERT_TRUE(wait_until([&] { return writer.live_readers() == 1; }, kPatience));
  RobotState bad = full<RobotState>();
  bad.omega = std::nan("");
  std::size_t heard = 0;

  EXPECT_EQ(writer.write(bad), WriteStatus::kInvalid);
  EXPECT_EQ(writer.write(full<RobotState>()), WriteStatus::kWritten);
  take_until(
      reader, [&](const auto&) { ++heard; }, [&] { return heard > 0; });

  EXPECT_EQ(writer.counters().invalid, 1U);
  EXPECT_EQ(reader.counters().accepted, 1U);
  EXPECT_EQ(reader.counters().total_rejected(), 0U);
}

TEST(Reader, HandsEventsOverInTheOrderInWhichTheyWereWrittenWhateverTheirKeys) {
  const DomainSettings domain = own_domain();
  const Participant here = Participant::join(domain);
  const Participant there = Participant::join(domain);
  Writer<Command> writer(here);
  Reader<Command> reader(there);
  ASSERT_TRUE(wait_until([&] { return writer.live_readers() == 1; }, kPatience));
  std::vector<std::uint32_t> written;
  std::vector<std::uint32_t> heard;

  for (std::uint32_t i = 1; i <= 12; ++i) {
    Command command = full<Command>();
    command.id.sequence = command.command = i;
    command.target = static_cast<RobotId>((7 * i) % 4);
    written.push_back(i);
    ASSERT_EQ(writer.write(command), WriteStatus::kWritten);
  }
  take_until(
      reader,
      [&](const auto& sample) {
        if (sample.message) heard.push_back(sample.message->command);
      },
      [&] { return heard.size() == written.size(); });

  EXPECT_EQ(heard, written);
}

TEST(Writer, IsNotBlockedByAReliableReaderThatStandsStill) {
  const DomainSettings domain = own_domain();
  const Participant here = Participant::join(domain);
  test::ChildProcess child = testing::start_child("commands", domain);
  Writer<Command> writer(here);
  ASSERT_TRUE(wait_until([&] { return writer.live_readers() == 1; }, kPatience));
  child.kill(SIGSTOP);
  Duration longest{0};

  for (std::uint32_t i = 1; i <= 2000; ++i) {
    Command command = full<Command>();
    command.id.sequence = command.command = i;
    const HostTime start = host_now();
    writer.write(command);
    longest = std::max(longest, host_now() - start);
  }

  EXPECT_LT(longest, 4 * kMaxBlocking);
  EXPECT_EQ(writer.counters().written + writer.counters().failed, 2000U);
}

}  // namespace
}  // namespace teamsight::bus
