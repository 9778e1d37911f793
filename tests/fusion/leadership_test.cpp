// tests/fusion/leadership_test.cpp: who sends the world model over the air, and when.
#include "fusion/leadership.hpp"

#include <gtest/gtest.h>

namespace teamsight::fusion {
namespace {

using std::chrono::milliseconds;

constexpr Rank kWeak{10, 1};
constexpr Rank kMiddle{20, 2};
constexpr Rank kStrong{30, 3};

HostTime at_ms(int ms) {
  return HostTime{std::chrono::seconds(50)} + milliseconds(ms);
}

/// Asks every 10 ms in [from, to), as the service does, hearing `other` every `period` ms.
bool ask(Leadership& leadership, int from, int to, const Rank* other = nullptr, int period = 33) {
  bool leads = false;
  for (int ms = from; ms < to; ++ms) {
    if (other != nullptr && (ms - from) % period == 0) leadership.heard(*other, at_ms(ms));
    if (ms % 10 == 0) leads = leadership.leads(at_ms(ms));
  }
  return leads;
}

TEST(Leadership, BeginsALeaseAfterTheStartWhenNobodyIsHeard) {
  Leadership leadership(kMiddle, {});

  EXPECT_FALSE(ask(leadership, 0, 201));
  EXPECT_TRUE(ask(leadership, 201, 221));
}

TEST(Leadership, StaysSilentWhileAStrongerOneIsHeard) {
  Leadership leadership(kMiddle, {});

  EXPECT_FALSE(ask(leadership, 0, 5000, &kStrong));
}

TEST(Leadership, TakesOverWithinALeaseOfTheStrongerOnesLastWord) {
  Leadership leadership(kMiddle, {});
  ask(leadership, 0, 1000, &kStrong);  // the last word at 990

  EXPECT_FALSE(ask(leadership, 1000, 1191));
  EXPECT_TRUE(ask(leadership, 1191, 1201));
}

TEST(Leadership, YieldsToAStrongerOneThatKeepsSending) {
  Leadership leadership(kMiddle, {});
  ASSERT_TRUE(ask(leadership, 0, 1000));

  EXPECT_FALSE(ask(leadership, 1000, 1150, &kStrong));
}

TEST(Leadership, DoesNotYieldToAStrongerOneThatStutters) {
  Leadership leadership(kMiddle, {});
  ASSERT_TRUE(ask(leadership, 0, 1000));

  // One word every 300 ms: each time the lease has ended in between.
  for (int ms = 1000; ms < 4000; ms += 10) {
    if (ms % 300 == 0) leadership.heard(kStrong, at_ms(ms));
    EXPECT_TRUE(leadership.leads(at_ms(ms))) << "at " << ms;
  }
}

TEST(Leadership, IgnoresAWeakerOneOnceItIsWarm) {
  Leadership leadership(kMiddle, {});

  EXPECT_TRUE(ask(leadership, 0, 1500, &kWeak));
}

TEST(Leadership, LetsAWeakerLeaderGoOnWhileItWarmsUp) {
  Leadership leadership(kMiddle, {});

  EXPECT_FALSE(ask(leadership, 0, 1000, &kWeak));
  EXPECT_TRUE(ask(leadership, 1000, 1050, &kWeak));
}

TEST(Leadership, StartsAnewAfterItWasStopped) {
  Leadership leadership(kStrong, {});
  ASSERT_TRUE(ask(leadership, 0, 1000));

  // Nothing asked for three seconds; meanwhile another one leads.
  EXPECT_FALSE(ask(leadership, 4000, 4900, &kMiddle));
  EXPECT_TRUE(ask(leadership, 4900, 5100, &kMiddle));
}

TEST(Leadership, DecidesBetweenEqualStrengthsByRobot) {
  Leadership first({20, 1}, {});
  Leadership second({20, 2}, {});
  const Rank of_first{20, 1};
  const Rank of_second{20, 2};

  EXPECT_FALSE(ask(first, 0, 3000, &of_second));
  EXPECT_TRUE(ask(second, 0, 3000, &of_first));
}

TEST(Leadership, DoesNotHearItself) {
  Leadership leadership(kMiddle, {});

  EXPECT_TRUE(ask(leadership, 0, 300, &kMiddle));
}

}  // namespace
}  // namespace teamsight::fusion
