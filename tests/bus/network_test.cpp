// tests/bus/network_test.cpp: joining on a host whose interfaces come up later, as a namespace.
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/bus/transport.hpp"

namespace teamsight::bus {
namespace {

using testing::kPatience;
using testing::own_domain;
using testing::profile_path;
using testing::wait_until;

/// bus_test_child "patient" in a network namespace of its own, where lo is down until `go` exists.
test::ChildProcess start_without_network(const DomainSettings& domain, const std::string& go) {
  const std::string command = std::string(BUS_TEST_CHILD) + " patient " + domain.profile_path +
                              " " + std::to_string(domain.domain_id) + " " + domain.tag +
                              " & child=$!; " + "trap : TERM; " + "while [ ! -e " + go +
                              " ] && kill -0 $child; do sleep 0.05; done; " +
                              "ip link set lo up; wait $child";
  return test::ChildProcess({"/usr/bin/unshare", "-rn", "/bin/sh", "-c", command});
}

class NoInterface : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("unshare -rn true 2>/dev/null") != 0) {
      GTEST_SKIP() << "no network namespaces here (unshare -rn)";
    }
  }

  test::TempDirectory directory_;
  std::string go_ = (directory_.path() / "go").string();
  DomainSettings domain_ = own_domain();
};

TEST_F(NoInterface, IsWaitedForUntilOneComesUp) {
  test::ChildProcess child = start_without_network(domain_, go_);
  ASSERT_TRUE(wait_until([&] { return child.out().starts_with("trying\n"); }, kPatience))
      << child.err();

  (void)directory_.write("go", "");

  EXPECT_TRUE(wait_until([&] { return child.out().ends_with("joined\n"); }, kPatience))
      << child.err();
}

TEST_F(NoInterface, EndsWithTheReasonWhenTheProcessIsToldToStop) {
  test::ChildProcess child = start_without_network(domain_, go_);
  ASSERT_TRUE(wait_until([&] { return child.out().starts_with("trying\n"); }, kPatience))
      << child.err();

  child.kill(SIGTERM);

  EXPECT_TRUE(wait_until([&] { return child.err().find("loopback.xml: ") != std::string::npos; },
                         kPatience))
      << child.err();
}

TEST_F(NoInterface, LoopbackIsNoneToAProfileThatChoosesItsCard) {
  const std::string command = "ip link set lo up; exec " + std::string(BUS_TEST_CHILD) +
                              " patient " + profile_path("wired.xml") + " " +
                              std::to_string(domain_.domain_id) + " " + domain_.tag;

  test::ChildProcess child({"/usr/bin/unshare", "-rn", "/bin/sh", "-c", command});

  const auto says_why = [&] {
    return child.err().find("wired.xml: no network card is up with an address") !=
           std::string::npos;
  };
  EXPECT_TRUE(wait_until(says_why, kPatience)) << child.err();
  EXPECT_EQ(child.out(), "trying\n");
}

}  // namespace
}  // namespace teamsight::bus
