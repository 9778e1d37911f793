// tests/tools/keys_command_test.cpp: `teamsight keys` makes what openssl verifies and the bus
// takes.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/participant.hpp"
#include "tests/support/process.hpp"

namespace teamsight::tools {
namespace {

namespace fs = std::filesystem;
using test::ChildProcess;
using ::testing::HasSubstr;

constexpr std::chrono::seconds kPatience{20};

/// Keys of a team with robots 1 and 2, made once.
class Keys : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = std::make_unique<test::TempDirectory>();
    ChildProcess keys({test::program("teamsight").string(),
                       "keys",
                       "--out",
                       folder("").string(),
                       "--team",
                       test::source_path("config/teams/demo.textproto").string(),
                       "--robots",
                       "1,2"});
    ASSERT_EQ(keys.wait_exit(kPatience), 0) << keys.err();
    ASSERT_EQ(keys.err(), "") << "what openssl says is for nobody while it works";
  }

  static void TearDownTestSuite() { directory_.reset(); }

  static fs::path folder(const std::string& name) { return directory_->path() / "keys" / name; }

  static bus::DomainSettings domain_of(const std::string& identity) {
    return {test::unique_domain(),
            test::source_path("config/dds/loopback.xml").string(),
            "",
            folder(identity).string()};
  }

  static std::string refusal(const std::string& identity) {
    try {
      const auto joined = bus::Participant::join(domain_of(identity));
      return "";
    } catch (const bus::BusError& error) {
      return error.what();
    }
  }

  static bool openssl(std::vector<std::string> words) {
    words.insert(words.begin(), "/usr/bin/openssl");
    return ChildProcess(words).wait_exit(kPatience) == 0;
  }

  static std::unique_ptr<test::TempDirectory> directory_;
};

std::unique_ptr<test::TempDirectory> Keys::directory_;

TEST_F(Keys, HaveAnIdentityThatItsAuthorityVouchesFor) {
  EXPECT_TRUE(openssl({"verify",
                       "-CAfile",
                       folder("authority/identity_ca.pem").string(),
                       folder("robot1/identity.pem").string()}));
}

TEST_F(Keys, HaveTwoAuthoritiesNeitherOfWhichCanDoTheOthersWork) {
  EXPECT_FALSE(openssl({"verify",
                        "-CAfile",
                        folder("authority/permissions_ca.pem").string(),
                        folder("robot1/identity.pem").string()}));
  EXPECT_FALSE(openssl({"smime",
                        "-verify",
                        "-in",
                        folder("robot1/permissions.p7s").string(),
                        "-CAfile",
                        folder("authority/identity_ca.pem").string()}));
}

TEST_F(Keys, LeaveNothingForOthersToRead) {
  for (const auto& entry : fs::recursive_directory_iterator(folder(""))) {
    const auto open = fs::perms::group_all | fs::perms::others_all;
    EXPECT_EQ(entry.status().permissions() & open, fs::perms::none) << entry.path();
  }
}

TEST_F(Keys, AreTakenByTheBus) {
  EXPECT_EQ(refusal("robot1"), "");
  EXPECT_EQ(refusal("coach"), "");
}

TEST_F(Keys, AreRefusedWhenOthersMayReadThem) {
  const fs::path key = folder("robot2/identity.key");
  fs::permissions(key, fs::perms::others_read, fs::perm_options::add);

  EXPECT_THAT(refusal("robot2"), HasSubstr("chmod 600 " + key.string()));

  fs::permissions(key, fs::perms::others_read, fs::perm_options::remove);
}

TEST_F(Keys, AreMissedByNameWhenTheTeamLacksARobot) {
  EXPECT_THAT(refusal("robot7"), HasSubstr("robot7"));
  EXPECT_THAT(refusal("robot7"), HasSubstr("expected a folder made by `teamsight keys`"));
}

}  // namespace
}  // namespace teamsight::tools
