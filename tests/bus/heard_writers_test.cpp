// tests/bus/heard_writers_test.cpp: who counts as heard.
#include "bus/heard_writers.hpp"

#include <gtest/gtest.h>

namespace teamsight::bus {
namespace {

using std::chrono::seconds;

constexpr Duration kPatience = seconds(1);
constexpr std::uint64_t kWriter = 11;
constexpr std::uint64_t kOther = 12;
constexpr ObservationId kMaker{3, 77, 1};

HostTime at(Duration since) {
  return HostTime{seconds(500)} + since;
}

TEST(HeardWriters, HasWhoeverSaidSomethingNewOfLate) {
  HeardWriters heard;
  heard.note(kWriter, kMaker, false, at(seconds(0)));

  EXPECT_TRUE(heard.has(kWriter, at(seconds(1)), kPatience));
  EXPECT_FALSE(heard.has(kWriter, at(seconds(2)), kPatience));
  EXPECT_FALSE(heard.has(kOther, at(seconds(0)), kPatience));
}

TEST(HeardWriters, DoesNotHaveWhoeverOnlyRepeatsItself) {
  HeardWriters heard;
  heard.note(kWriter, kMaker, false, at(seconds(0)));
  heard.note(kWriter, kMaker, true, at(seconds(2)));

  EXPECT_FALSE(heard.has(kWriter, at(seconds(2)), kPatience));
}

TEST(HeardWriters, HasAnEchoOfSomebodyWhoIsHeardHimself) {
  HeardWriters heard;
  heard.note(kWriter, kMaker, true, at(seconds(0)));
  ASSERT_FALSE(heard.has(kWriter, at(seconds(0)), kPatience));

  heard.note(kOther, kMaker, false, at(seconds(0)));

  EXPECT_TRUE(heard.has(kWriter, at(seconds(0)), kPatience));
}

TEST(HeardWriters, NoticesAProcessThatComesThroughAnotherWriter) {
  HeardWriters heard;
  heard.note(kWriter, kMaker, false, at(seconds(0)));
  EXPECT_EQ(heard.renamed(), HostTime{});

  heard.note(kOther, {3, 78, 1}, false, at(seconds(1)));  // it has been started again
  EXPECT_EQ(heard.renamed(), HostTime{});

  heard.note(13, kMaker, false, at(seconds(2)));
  heard.note(kWriter, kMaker, false, at(seconds(3)));
  EXPECT_EQ(heard.renamed(), at(seconds(2)));
}

TEST(HeardWriters, DoesNotTakeItsOwnNewHandlesForNewNames) {
  HeardWriters heard;
  heard.note(kWriter, kMaker, false, at(seconds(0)));
  heard.forget_writers();

  heard.note(kOther, kMaker, false, at(seconds(1)));

  EXPECT_EQ(heard.renamed(), HostTime{});
}

TEST(HeardWriters, ForgetsTheOldestOfTooMany) {
  HeardWriters heard;
  for (std::uint64_t writer = 0; writer <= HeardWriters::kMost; ++writer) {
    heard.note(writer, kMaker, false, at(std::chrono::milliseconds(writer)));
  }

  EXPECT_FALSE(heard.has(0, at(seconds(0)), kPatience));
  EXPECT_TRUE(heard.has(1, at(seconds(0)), kPatience));
  EXPECT_TRUE(heard.has(HeardWriters::kMost, at(seconds(0)), kPatience));
}

}  // namespace
}  // namespace teamsight::bus
