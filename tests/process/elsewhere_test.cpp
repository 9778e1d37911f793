// tests/process/elsewhere_test.cpp: which of the announced domains are somebody else's.
#include "process/elsewhere.hpp"

#include <gmock/gmock.h>

namespace teamsight::process {
namespace {

using bus::AnnouncedDomain;
using ::testing::ElementsAre;

settings::TeamSettings blue_in(std::uint32_t domain) {
  settings::TeamSettings team;
  team.name = "blue";
  team.domain_id = domain;
  return team;
}

TEST(WithoutOwn, KeepsOtherDomainsAndOtherTeamsInTheSameOne) {
  const std::set<AnnouncedDomain> heard{
      {20, "blue"}, {20, "red"}, {21, "blue.robot3"}, {21, "match"}, {21, "red"}, {33, "blue"}};
  DomainOptions options;
  options.host_tag = "match";

  EXPECT_THAT(
      without_own(heard, blue_in(20), options),
      ElementsAre(
          AnnouncedDomain{20, "red"}, AnnouncedDomain{21, "red"}, AnnouncedDomain{33, "blue"}));
}

TEST(WithoutOwn, GoesByTheDomainOfTheCommandLine) {
  DomainOptions options;
  options.team_domain = 33;

  EXPECT_THAT(without_own({{20, "blue"}, {33, "blue"}}, blue_in(20), options),
              ElementsAre(AnnouncedDomain{20, "blue"}));
}

}  // namespace
}  // namespace teamsight::process
