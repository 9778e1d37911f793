// tests/process/identity_guard_test.cpp: of two processes with one id exactly one goes.
#include "process/identity_guard.hpp"

#include <gtest/gtest.h>

#include "tests/support/property.hpp"

namespace teamsight::process {
namespace {

TEST(JudgeRival, TakesNoNoticeOfOthersAndOfItself) {
  const ObservationId own{3, 100, 50};

  EXPECT_EQ(judge_rival(own, {4, 200, 50}), Rivalry::kNone);
  EXPECT_EQ(judge_rival(own, {3, 100, 49}), Rivalry::kNone);
}

TEST(JudgeRival, LetsTheNewcomerYieldWhateverItsBootId) {
  EXPECT_EQ(judge_rival({3, 1, 10}, {3, 2, 5000}), Rivalry::kYield);
  EXPECT_EQ(judge_rival({3, 2, 10}, {3, 1, 5000}), Rivalry::kYield);
  EXPECT_EQ(judge_rival({3, 1, 5000}, {3, 2, 10}), Rivalry::kStay);
  EXPECT_EQ(judge_rival({3, 2, 5000}, {3, 1, 10}), Rivalry::kStay);
}

TEST(JudgeRival, IsDecidedTheOtherWayRoundByTheOther) {
  testing_support::holds_for_all(4711, [] {
    const auto boot = rc::gen::inRange<std::uint32_t>(1, 1000);
    const auto count = rc::gen::inRange<std::uint32_t>(1, 100000);
    const ObservationId a{3, *boot, *count};
    ObservationId b{3, *boot, *count};
    RC_PRE(a.boot != b.boot);

    const bool a_yields = judge_rival(a, b) == Rivalry::kYield;
    const bool b_yields = judge_rival(b, a) == Rivalry::kYield;

    RC_ASSERT(a_yields != b_yields);
  });
}

TEST(WordsOnRival, SayWhoTheOtherIsAndWhatToDo) {
  EXPECT_EQ(words_on_rival(3, {"omni2", "192.168.1.12", false}),
            "robot id 3 is used on omni2 (192.168.1.12) too: give one robot another id");
  EXPECT_EQ(words_on_rival(3, {}),
            "robot id 3 is used on another computer too: give one robot another id");
  EXPECT_EQ(words_on_rival(3, {"omni1", "192.168.1.11", true}),
            "robot id 3 is used twice on this computer: end one of the two");
}

}  // namespace
}  // namespace teamsight::process
