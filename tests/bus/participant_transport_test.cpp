// tests/bus/participant_transport_test.cpp: joining: profiles, errors, several domains, tags.
#include <algorithm>
#include <cstdlib>
#include <regex>

#include <dds/ddsrt/log.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/library_log.hpp"
#include "bus/participant.hpp"
#include "bus/writer.hpp"
#include "tests/bus/samples.hpp"
#include "tests/bus/transport.hpp"

namespace teamsight::bus {
namespace {

using ::testing::AllOf;
using testing::full;
using ::testing::HasSubstr;
using testing::kPatience;
using ::testing::Not;
using testing::own_domain;
using testing::profile_path;
using testing::TemporaryFile;
using testing::text_of;
using testing::wait_until;

/// The message with which a profile of this text is refused; empty if it is not.
std::string refusal(const std::string& profile) {
  const TemporaryFile file(profile);
  DomainSettings domain = own_domain();
  domain.profile_path = file.path();
  ::testing::internal::CaptureStderr();
  try {
    (void)Participant::join(domain);
  } catch (const BusError& error) {
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");  // the reason is said once, by main
    EXPECT_THAT(error.what(), AllOf(HasSubstr(file.path()), Not(HasSubstr("\n"))));
    return error.what();
  }
  ::testing::internal::GetCapturedStderr();
  return "";
}

std::string with_general(const std::string& content) {
  return "<CycloneDDS><Domain Id=\"any\"><General>" + content + "</General></Domain></CycloneDDS>";
}

TEST(Join, AcceptsTheProfilesOfOneComputer) {
  for (const char* name : {"loopback.xml", "host.xml"}) {
    DomainSettings domain = own_domain();
    domain.profile_path = profile_path(name);

    EXPECT_NO_THROW((void)Participant::join(domain)) << name;
  }
}

// The other networks are not this machine's: with an interface that is nowhere, the interface must
// be all that the library finds wrong, after it has read everything else.
TEST(Join, FindsNothingButTheInterfaceMissingInTheOtherProfiles) {
  for (const char* name : {"wired.xml", "wifi.xml", "unicast.xml"}) {
    const std::regex interface("<NetworkInterface (autodetermine=\"true\"|name=\"wlan0\")/>");
    const std::string text = text_of(profile_path(name));
    ASSERT_TRUE(std::regex_search(text, interface)) << name;

    EXPECT_THAT(
        refusal(std::regex_replace(text, interface, "<NetworkInterface name=\"nowhere0\"/>")),
        HasSubstr("nowhere0: does not match an available interface"))
        << name;
  }
}

TEST(Join, GivesTheLibrarysReasonForABadProfile) {
  EXPECT_THAT(refusal(with_general("<Bogus/>")), HasSubstr("Bogus: unknown element (line 1)"));
  EXPECT_THAT(refusal(with_general("<AllowMulticast>banana</AllowMulticast>")),
              HasSubstr("'banana' undefined"));
  EXPECT_THAT(refusal(with_general("<Interfaces>")), HasSubstr("open/close tag mismatch"));
  EXPECT_THAT(refusal("<CycloneDDS><Domain Id=\"any\"><Discovery><LeaseDuration>-2s"
                      "</LeaseDuration></Discovery></Domain></CycloneDDS>"),
              HasSubstr("value out of range"));
}

TEST(Join, GivesUpAtOnceForAnInterfaceThatDoesNotExist) {
  DomainSettings domain = own_domain();
  const TemporaryFile file(
      with_general("<Interfaces><NetworkInterface name=\"nowhere0\"/></Interfaces>"));
  domain.profile_path = file.path();
  int asked = 0;

  EXPECT_THROW((void)Participant::join(domain,
                                       [&] {
                                         ++asked;
                                         return true;
                                       }),
               BusError);

  EXPECT_EQ(asked, 0);
}

TEST(Join, DoesNotFallBackAfterAFailure) {
  const TemporaryFile file(with_general("<Bogus/>"));
  const DomainSettings good = own_domain();
  DomainSettings bad = good;
  bad.profile_path = file.path();

  EXPECT_THROW((void)Participant::join(bad), BusError);
  EXPECT_THROW((void)Participant::join(bad), BusError);

  EXPECT_NO_THROW((void)Participant::join(good));
}

TEST(Join, DoesNotConsultTheEnvironment) {
  setenv("CYCLONEDDS_URI", "<broken", 1);

  EXPECT_NO_THROW((void)Participant::join(own_domain()));
}

TEST(Join, SharesADomainOfTheSameSettingsOnly) {
  const DomainSettings first = own_domain("one");
  DomainSettings other_tag = first;
  other_tag.tag = "two";
  const Participant participant = Participant::join(first);

  EXPECT_NO_THROW((void)Participant::join(first));
  EXPECT_THROW((void)Participant::join(other_tag), BusError);
}

TEST(Join, MakesTheDomainAnewWhenAllHaveLeft) {
  DomainSettings domain = own_domain("one");
  (void)Participant::join(domain);
  domain.tag = "two";

  EXPECT_NO_THROW((void)Participant::join(domain));
}

TEST(Join, ServesSeveralDomainsInOneProcess) {
  const DomainSettings team = own_domain("team");
  DomainSettings host = team;
  host.domain_id = team.domain_id + 1;
  host.tag = "host";
  const Participant in_team = Participant::join(team);
  const Participant in_host = Participant::join(host);
  const Participant other_in_host = Participant::join(host);
  Writer<Odometry> writer(in_host);
  Reader<Odometry> here(other_in_host);
  Reader<Odometry> elsewhere(in_team);
  ASSERT_TRUE(wait_until([&] { return writer.live_readers() == 1; }, kPatience));
  std::size_t heard = 0;

  writer.write(full<Odometry>());
  testing::take_until(
      here, [&](const auto&) { ++heard; }, [&] { return heard > 0; });

  EXPECT_EQ(heard, 1U);
  EXPECT_EQ(elsewhere.take(host_now(), [](const auto&) {}), 0U);
}

TEST(Join, KeepsTheParticipantWhileAReaderOrWriterLives) {
  const DomainSettings domain = own_domain();
  auto participant = std::make_unique<Participant>(Participant::join(domain));
  const Participant other = Participant::join(domain);
  Writer<Odometry> writer(*participant);
  Reader<Odometry> reader(other);
  ASSERT_TRUE(wait_until([&] { return writer.live_readers() == 1; }, kPatience));

  participant.reset();

  EXPECT_EQ(writer.write(full<Odometry>()), WriteStatus::kWritten);
}

TEST(LibraryLog, PrintsAFewLinesAndCountsTheRest) {
  install_library_log();
  const LibraryLogCounters before = library_log_counters();
  ::testing::internal::CaptureStderr();

  for (int i = 0; i < 1000; ++i) {
    dds_log(DDS_LC_WARNING, __FILE__, __LINE__, __func__, "malformed packet %d\n", i);
  }

  const std::string printed = ::testing::internal::GetCapturedStderr();
  const LibraryLogCounters after = library_log_counters();
  EXPECT_EQ(after.lines - before.lines, 1000U);
  EXPECT_EQ(std::count(printed.begin(), printed.end(), '\n'), 10);
  EXPECT_EQ(after.suppressed - before.suppressed, 990U);
}

}  // namespace
}  // namespace teamsight::bus
