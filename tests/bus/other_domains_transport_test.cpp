// tests/bus/other_domains_transport_test.cpp: who announces himself in another domain is noticed.
#include <gmock/gmock.h>

#include "bus/other_domains.hpp"
#include "tests/bus/transport.hpp"

namespace teamsight::bus {
namespace {

using ::testing::Contains;
using testing::kPatience;
using ::testing::Not;
using testing::own_domain;
using testing::wait_until;

TEST(OtherDomains, AreHeardWithTheirTagWhileSomebodyIsInThem) {
  const DomainSettings blue = own_domain("blue");
  OtherDomains others;
  {
    const Participant there = Participant::join(blue);

    EXPECT_TRUE(wait_until(
        [&] {
          return others.heard(host_now()).contains({blue.domain_id, "blue"});
        },
        kPatience));
  }
  static_cast<void>(others.heard(host_now()));  // what they said before they went

  const auto later = others.heard(host_now() + std::chrono::seconds(60));
  EXPECT_THAT(later, Not(Contains(AnnouncedDomain{blue.domain_id, "blue"})));
}

TEST(OtherDomains, AreHeardByTwoWhoListenAtOnce) {
  const DomainSettings blue = own_domain("blue");
  const Participant there = Participant::join(blue);
  OtherDomains first;
  OtherDomains second;

  for (OtherDomains* others : {&first, &second}) {
    EXPECT_TRUE(wait_until(
        [&] {
          return others->heard(host_now()).contains({blue.domain_id, "blue"});
        },
        kPatience));
  }
}

}  // namespace
}  // namespace teamsight::bus
