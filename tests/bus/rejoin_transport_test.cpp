// tests/bus/rejoin_transport_test.cpp: a forged sequence number shuts a live writer out; joining
// anew lets it in again.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <arpa/inet.h>
#include <dds/dds.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "bus/entity.hpp"
#include "bus/writer.hpp"
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

/// Name of the one writer of RobotState in the domain, as every participant hears it announced.
std::optional<WriterName> announced_writer(const Participant& participant) {
  const Entity reader(
      dds_create_reader(participant.handle(), DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr));
  std::array<void*, 64> samples{};
  std::array<dds_sample_info_t, 64> infos{};
  const auto count =
      dds_take(reader.handle(), samples.data(), infos.data(), samples.size(), samples.size());
  std::optional<WriterName> name;
  for (int i = 0; i < count; ++i) {
    const auto& endpoint =
        *static_cast<const dds_builtintopic_endpoint_t*>(samples[static_cast<std::size_t>(i)]);
    if (std::string(endpoint.topic_name) != "teamsight/v1/RobotState") continue;
    name.emplace();
    std::copy_n(std::begin(endpoint.key.v), name->size(), name->begin());
  }
  if (count > 0) dds_return_loan(reader.handle(), samples.data(), count);
  return name;
}

/// An RTPS message with one sample of this writer, its number a million above any true one.
std::vector<std::uint8_t> forged(const WriterName& writer) {
  std::vector<std::uint8_t> packet{'R', 'T', 'P', 'S', 2, 1, 1, 0x10};
  packet.insert(packet.end(), writer.begin(), writer.begin() + 12);
  packet.insert(packet.end(), {0x15, 0x05, 0, 0, 0, 0, 16, 0, 0, 0, 0, 0});  // DATA, any reader
  packet.insert(packet.end(), writer.begin() + 12, writer.end());
  packet.insert(packet.end(), {0, 0, 0, 0, 0x40, 0x42, 0x0f, 0, 0, 1, 0, 0});  // number; encoding
  packet.resize(packet.size() + 256);
  return packet;
}

/// As the team's own samples go: by multicast, on the loopback interface.
void send(const std::vector<std::uint8_t>& packet, std::uint32_t domain) {
  const int out = ::socket(AF_INET, SOCK_DGRAM, 0);
  in_addr loopback{};
  loopback.s_addr = htonl(INADDR_LOOPBACK);
  ::setsockopt(out, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(7401 + 250 * domain));
  inet_pton(AF_INET, "239.255.0.1", &to.sin_addr);
  ::sendto(out, packet.data(), packet.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof to);
  ::close(out);
}

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
  const auto name = announced_writer(participant_);
  ASSERT_TRUE(name);
  EXPECT_THAT(reader_.unheard_writers(host_now(), kQuiet), ::testing::IsEmpty());

  send(forged(*name), domain_.domain_id);
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
