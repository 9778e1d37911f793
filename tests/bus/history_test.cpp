// tests/bus/history_test.cpp: duplicates, gaps and stamps, judged by what came before.
#include "bus/history.hpp"

#include <gtest/gtest.h>

namespace teamsight::bus {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::uint64_t kInstance = 1;

PeerTime stamp(Duration d) {
  return PeerTime{seconds(5000) + d};
}

HostTime host(Duration d) {
  return HostTime{seconds(70) + d};
}

ObservationId id(std::uint32_t sequence, std::uint32_t boot = 9) {
  return {3, boot, sequence};
}

TEST(History, CountsTheGapBeforeASample) {
  History history;

  EXPECT_EQ(history.judge(kInstance, id(5), stamp({}), host({})), 0U);
  EXPECT_EQ(history.judge(kInstance, id(6), stamp(milliseconds(40)), host(milliseconds(40))), 0U);
  EXPECT_EQ(history.judge(kInstance, id(9), stamp(milliseconds(160)), host(milliseconds(160))), 2U);
}

TEST(History, DropsTheSameAndOlderSequenceNumbersOfABoot) {
  History history;
  ASSERT_TRUE(history.judge(kInstance, id(5), stamp({}), host({})));

  EXPECT_EQ(history.judge(kInstance, id(5), stamp({}), host({})).error(), Reject::kDuplicate);
  EXPECT_EQ(history.judge(kInstance, id(4), stamp({}), host({})).error(), Reject::kDuplicate);
}

TEST(History, StartsAnewWithANewBoot) {
  History history;
  ASSERT_TRUE(history.judge(kInstance, id(500), stamp({}), host({})));

  EXPECT_EQ(history.judge(kInstance, id(1, 10), PeerTime{seconds(1)}, host({})), 0U);
}

TEST(History, KeepsInstancesOfOneWriterApart) {
  History history;
  ASSERT_TRUE(history.judge(1, id(5), std::nullopt, host({})));

  EXPECT_EQ(history.judge(2, id(3), std::nullopt, host({})), 0U);
}

TEST(History, DropsAStampThatDoesNotMoveWithTheOwnClock) {
  for (const Duration jump : {Duration(seconds(3)), Duration(seconds(-3))}) {
    History history;
    ASSERT_TRUE(history.judge(kInstance, id(1), stamp({}), host({})));

    const auto late = history.judge(kInstance, id(2), stamp(jump), host(milliseconds(40)));

    ASSERT_FALSE(late);
    EXPECT_EQ(late.error(), Reject::kImplausibleStamp);
  }
}

TEST(History, AcceptsAWriterThatWasSilentForLong) {
  History history;
  ASSERT_TRUE(history.judge(kInstance, id(1), stamp({}), host({})));

  EXPECT_TRUE(history.judge(kInstance, id(2), stamp(seconds(60)), host(seconds(60))));
}

TEST(History, TakesItsPastForWrongAfterManyImplausibleStamps) {
  History history;
  ASSERT_TRUE(history.judge(kInstance, id(1), stamp({}), host({})));
  for (std::uint32_t i = 0; i < History::kSamplesToRelearn; ++i) {
    ASSERT_FALSE(history.judge(kInstance, id(2 + i), stamp(seconds(-90)), host({})));
  }

  EXPECT_TRUE(history.judge(kInstance, id(99), stamp(seconds(-90)), host({})));
  EXPECT_TRUE(history.judge(kInstance, id(100), stamp(seconds(-90)), host({})));
}

TEST(History, ForgetsTheWriterUnusedForLongestWhenThereAreTooMany) {
  History history;
  ASSERT_TRUE(history.judge(kInstance, id(1, 1), std::nullopt, host({})));
  ASSERT_TRUE(history.judge(kInstance, id(1, 2), std::nullopt, host({})));
  ASSERT_TRUE(history.judge(kInstance, id(2, 1), std::nullopt, host({})));
  for (std::uint32_t i = 0; i < History::kWriters - 1; ++i) {
    ASSERT_TRUE(history.judge(kInstance, id(1, 100 + i), std::nullopt, host({})));
  }

  EXPECT_TRUE(history.judge(kInstance, id(1, 2), std::nullopt, host({})));
  EXPECT_FALSE(
      history.judge(kInstance, id(1, 100 + History::kWriters - 2), std::nullopt, host({})));
}

TEST(History, DropsANumberThatNobodyCanHaveCountedTo) {
  History history;
  ASSERT_TRUE(history.judge(kInstance, id(5), stamp({}), host({})));

  const auto forged =
      history.judge(kInstance, id(65'541), stamp(milliseconds(40)), host(milliseconds(40)));

  ASSERT_FALSE(forged);
  EXPECT_EQ(forged.error(), Reject::kImplausibleNumber);
  EXPECT_EQ(history.judge(kInstance, id(6), stamp(milliseconds(40)), host(milliseconds(40))), 0U);
}

TEST(History, BelievesTheGapOfALongSilence) {
  History history;
  ASSERT_TRUE(history.judge(kInstance, id(5), stamp({}), host({})));

  EXPECT_EQ(history.judge(kInstance, id(3006), stamp(seconds(60)), host(seconds(60))), 3000U);
}

TEST(History, TakesAForgedFirstNumberForWrongWhenTheWriterGoesOnCounting) {
  History history;
  ASSERT_TRUE(history.judge(kInstance, id(1'000'000), stamp({}), host({})));
  for (std::uint32_t i = 0; i < History::kSamplesToRelearn; ++i) {
    ASSERT_FALSE(history.judge(kInstance, id(7 + i), stamp({}), host({})));
  }

  EXPECT_EQ(history.judge(kInstance, id(30), stamp({}), host({})), 0U);
  EXPECT_EQ(history.judge(kInstance, id(31), stamp({}), host({})), 0U);
}

TEST(History, IsNotTalkedRoundByRepetitionsBetweenNewSamples) {
  History history;
  for (std::uint32_t i = 1; i <= 3 * History::kSamplesToRelearn; ++i) {
    ASSERT_TRUE(history.judge(kInstance, id(100 + i), stamp({}), host({})));
    EXPECT_EQ(history.judge(kInstance, id(i), stamp({}), host({})).error(), Reject::kDuplicate);
  }
}

}  // namespace
}  // namespace teamsight::bus
