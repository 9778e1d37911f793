// tests/bus/other_versions_transport_test.cpp: another version in the same domain is noticed.
#include <gmock/gmock.h>
#include <teamsight.h>

#include "bus/entity.hpp"
#include "bus/other_versions.hpp"
#include "bus/writer.hpp"
#include "tests/bus/transport.hpp"

namespace teamsight::bus {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::kPatience;
using testing::own_domain;
using testing::wait_until;

TEST(OtherVersions, AreNoticedWhileTheyAreThere) {
  const DomainSettings domain = own_domain();
  const Participant here = Participant::join(domain);
  const Participant there = Participant::join(domain);
  const Writer<RobotState> same(there);
  const OtherVersions others(here);
  {
    const Entity topic(dds_create_topic(there.handle(),
                                        &teamsight_v1_RobotState_desc,
                                        "teamsight/v9/RobotState",
                                        nullptr,
                                        nullptr));
    const Entity writer(dds_create_writer(there.handle(), topic.handle(), nullptr, nullptr));
    ASSERT_GT(writer.handle(), 0);

    EXPECT_TRUE(wait_until([&] { return !others.present().empty(); }, kPatience));
    EXPECT_THAT(others.present(), ElementsAre("v9"));
  }

  EXPECT_TRUE(wait_until([&] { return others.present().empty(); }, kPatience));
}

TEST(VersionOf, IsWhatStandsInATopicsName) {
  EXPECT_EQ(version_of("teamsight/v2/RobotState"), "v2");
  EXPECT_EQ(version_of("teamsight/"), "");
  EXPECT_EQ(version_of("DCPSTopic"), "");
  EXPECT_EQ(version_of("teamsight/v2"), "");
}

}  // namespace
}  // namespace teamsight::bus
