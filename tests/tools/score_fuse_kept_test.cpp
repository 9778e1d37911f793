// tests/tools/score_fuse_kept_test.cpp: `teamsight score fuse --cameras --kept`: a game that was
// kept scores as the same game rendered, and no other is taken for it.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "bench/kept_play/kept_game.hpp"
#include "tests/support/process.hpp"

namespace teamsight {
namespace {

using nlohmann::json;
using test::ChildProcess;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::chrono::milliseconds kBound{60'000};

/// One short game of five robots, two frames a second each.
class KeptGames : public ::testing::Test {
 protected:
  /// The lines that it prints but for how long it took. Exit code as expected, or the test fails.
  std::vector<json> score(const std::vector<std::string>& more, int exit_code = 0) {
    const std::string config = test::source_path("config").string();
    std::vector<std::string> words{test::program("teamsight").string(),
                                   "score",
                                   "fuse",
                                   "--cameras",
                                   "--no-peers",
                                   "--scenario",
                                   "normal",
                                   "--seeds",
                                   "1",
                                   "--rate",
                                   "2",
                                   "--camera",
                                   config + "/cameras/sim-640.textproto",
                                   "--field",
                                   config + "/fields/msl-2024.textproto"};
    words.insert(words.end(), more.begin(), more.end());
    ChildProcess child(words);
    EXPECT_EQ(child.wait_exit(kBound), exit_code) << child.err();
    errors_ = child.err();
    std::istringstream lines(child.out());
    std::vector<json> said;
    for (std::string line; std::getline(lines, line);) {
      said.push_back(json::parse(line));
      said.back().erase("insert_us");
    }
    return said;
  }

  [[nodiscard]] std::vector<std::string> kept(const std::string& seconds) const {
    return {"--seconds", seconds, "--kept", directory_.path().string()};
  }

  [[nodiscard]] std::filesystem::path file() const { return directory_.path() / "normal-1.mcap"; }

  [[nodiscard]] std::string bytes() const {
    std::ifstream in(file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  void write(const std::string& bytes) const {
    std::ofstream(file(), std::ios::binary | std::ios::trunc) << bytes;
  }

  test::TempDirectory directory_;
  std::string errors_;
};

TEST_F(KeptGames, ScoreAsTheSameGamesRendered) {
  const auto rendered = score({"--seconds", "7"});
  ASSERT_EQ(rendered.size(), 2U);
  EXPECT_GT(rendered[0]["ball"]["ticks"], 50);
  EXPECT_EQ(score(kept("7")), rendered);  // rendered again, and kept
  const std::string whole = bytes();
  ASSERT_FALSE(whole.empty());
  EXPECT_EQ(score(kept("7")), rendered);
  EXPECT_THAT(errors_, IsEmpty());
  EXPECT_EQ(bytes(), whole);  // read, not written again

  // One that was cut off is said to be, and made good.
  write(whole.substr(0, whole.size() / 2));
  EXPECT_EQ(score(kept("7")), rendered);
  EXPECT_THAT(errors_, HasSubstr("normal-1.mcap: not a whole kept game"));
  EXPECT_EQ(bytes(), whole);
  write("no recording");
  EXPECT_EQ(score(kept("7")), rendered);
  EXPECT_THAT(errors_, HasSubstr("rendered again"));

  // Nothing is rendered over a game that was kept with other settings.
  EXPECT_THAT(score(kept("8"), 2), IsEmpty());
  EXPECT_THAT(errors_, HasSubstr("normal-1.mcap: seconds: found 7, expected 8"));
  EXPECT_EQ(bytes(), whole);
}

// Without rendering: looks as a game could have them.
TEST_F(KeptGames, OfOtherCodeAreKnown) {
  fusion::Observation look;
  look.id = {1, 1001, 1};
  look.exposure = HostTime{std::chrono::seconds(100)};
  const kept_play::Facts facts{{"code", "another"}, {"seed", "1"}};
  kept_play::write_game(file(), facts, {look});

  EXPECT_EQ(kept_play::read_game(file(), facts), kept_play::Looks{look});
  const kept_play::Facts now{{"code", std::string(kept_play::seeing_code())}, {"seed", "1"}};
  EXPECT_THROW((void)kept_play::read_game(file(), now), kept_play::OtherGame);
  EXPECT_THROW((void)kept_play::read_game(file(), {{"scenario", "x"}}), kept_play::OtherGame);
}

// A game that is not the one that was kept ends with a word, not with what was kept for another.
TEST_F(KeptGames, AreReadInTheirOrderOnly) {
  fusion::Observation look;
  look.id = {1, 1001, 1};
  look.exposure = HostTime{std::chrono::seconds(100)};
  play::Moment moment;
  moment.players.resize(2);
  kept_play::KeptEyes eyes({look, look}, 0.25);

  EXPECT_EQ(eyes.look(0, moment, 0.1).observation.id, look.id);
  EXPECT_THROW((void)eyes.look(1, moment, 0.1), std::runtime_error);
  moment.t = 1.0;
  EXPECT_THROW((void)eyes.look(0, moment, 0.1), std::runtime_error);
}

}  // namespace
}  // namespace teamsight
