// tests/bus/profile_test.cpp: what the library would take for "all defaults" is an error.
#include "bus/profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/participant.hpp"
#include "bus/topics.hpp"
#include "tests/bus/files.hpp"

namespace teamsight::bus {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::profile_path;
using testing::TemporaryFile;

/// The message with which a file of this text is refused; empty if it is not.
std::string refusal(const std::string& text, const std::string& tag = "") {
  const TemporaryFile file(text);
  try {
    (void)load_profile(file.path(), tag);
  } catch (const BusError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.path()));
    return error.what();
  }
  return "";
}

constexpr const char* kGood = "<CycloneDDS><Domain Id=\"any\"></Domain></CycloneDDS>";

TEST(Profile, AcceptsOneRootForAnyDomain) {
  EXPECT_EQ(refusal(kGood), "");
  EXPECT_EQ(refusal(std::string("\n<!-- a\n b -->\n") + kGood + "\n<!-- c -->\n"), "");
  EXPECT_EQ(refusal("<CycloneDDS><Domain></Domain></CycloneDDS>"), "");
}

TEST(Profile, RefusesWhatHasNoRoot) {
  EXPECT_THAT(refusal(""), HasSubstr("expected exactly one <CycloneDDS>"));
  EXPECT_THAT(refusal("<!-- nothing else -->"), HasSubstr("expected exactly one <CycloneDDS>"));
  EXPECT_THAT(refusal("/etc/hostname"), HasSubstr("expected exactly one <CycloneDDS>"));
  EXPECT_THAT(refusal("file:///tmp/other.xml"), HasSubstr("expected exactly one <CycloneDDS>"));
}

TEST(Profile, RefusesASecondRoot) {
  EXPECT_THAT(refusal(std::string(kGood) + kGood), HasSubstr("expected exactly one"));
  EXPECT_THAT(refusal(std::string(kGood) + ",/etc/other.xml"), HasSubstr("expected exactly one"));
}

TEST(Profile, RefusesASectionThatWouldNotApply) {
  EXPECT_THAT(refusal("<CycloneDDS><Domain Id=\"3\"></Domain></CycloneDDS>"),
              AllOf(HasSubstr("Id=\"3\""), HasSubstr("expected <Domain Id=\"any\">")));
  EXPECT_THAT(refusal("<CycloneDDS></CycloneDDS>"), HasSubstr("no <Domain> section"));
}

TEST(Profile, RefusesACommentWithoutEnd) {
  EXPECT_THAT(refusal("<!-- <CycloneDDS></CycloneDDS>"), HasSubstr("comment has no end"));
}

TEST(Profile, KeepsTheLineNumbersWhenItBlanksComments) {
  const TemporaryFile file(std::string("<!-- one\ntwo -->\n") + kGood);

  const std::string text = load_profile(file.path(), "").text;

  EXPECT_EQ(text.find("<CycloneDDS>"), text.find_last_of('\n') + 1);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
}

TEST(Profile, RefusesATagThatIsNotAName) {
  EXPECT_EQ(refusal(kGood, "robot-1_a.b"), "");
  EXPECT_THAT(refusal(kGood, "a</Tag>"), HasSubstr("tag 'a</Tag>'"));
  EXPECT_THAT(refusal(kGood, std::string(65, 'x')), HasSubstr("at most 64"));
}

TEST(Profile, TakesTheLeaseOfItsNetwork) {
  const TemporaryFile slow(std::string("<?teamsight lease_ms=\"500\"?>\n") + kGood);
  const TemporaryFile plain(kGood);

  EXPECT_EQ(load_profile(slow.path(), "").lease, std::chrono::milliseconds(500));
  EXPECT_EQ(load_profile(plain.path(), "").lease, kDefaultLease);
  EXPECT_EQ(load_profile(slow.path(), "").text.find("teamsight"), std::string::npos);
}

TEST(Profile, NamesItsNetworkCardUnlessTheLibraryChooses) {
  EXPECT_EQ(load_profile(profile_path("wifi.xml"), "").card, "wlan0");
  EXPECT_EQ(load_profile(profile_path("loopback.xml"), "").card, "lo");
  EXPECT_EQ(load_profile(profile_path("wired.xml"), "").card, "");
}

TEST(Profile, RefusesALeaseThatIsNoneOrNoGood) {
  for (const char* lease :
       {"lease_ms=\"99\"", "lease_ms=\"6000\"", "lease_ms=\"fast\"", "lease=\"200\"", ""}) {
    EXPECT_THAT(refusal(std::string("<?teamsight ") + lease + "?>" + kGood),
                HasSubstr("expected <?teamsight lease_ms=\"N\"?>"));
  }
}

TEST(Profile, NamesTheFileThatIsNotThere) {
  try {
    (void)load_profile("/nonexistent/profile.xml", "");
    FAIL();
  } catch (const BusError& error) {
    EXPECT_STREQ(error.what(),
                 "DDS profile /nonexistent/profile.xml: cannot be read: No such file or directory");
  }
}

TEST(Profile, RefusesADirectory) {
  EXPECT_THROW((void)load_profile("/tmp", ""), BusError);
}

}  // namespace
}  // namespace teamsight::bus
