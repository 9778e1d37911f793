// tests/fusion/clock_book_test.cpp: stamps of peers in this host's time.
#include "fusion/service/clock_book.hpp"

#include <gtest/gtest.h>

namespace teamsight::fusion {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr HostTime kNow{seconds(100)};
// The peer's computer was started a day before this one.
constexpr Duration kAhead = std::chrono::hours(24);

PeerTime peer_stamp(HostTime time) {
  return PeerTime{time.time_since_epoch() + kAhead};
}

bus::ClockEcho echo_of(const bus::ClockProbe& probe, HostTime time) {
  return {{2, 222, 1}, peer_stamp(time), {{probe.id, peer_stamp(time)}}};
}

TEST(ClockBook, TakesThisHostsStampsAsTheyAre) {
  const ClockBook book(1, 111);

  EXPECT_EQ(book.convert(1, stamp_of(kNow), kNow + seconds(5))->time, kNow);
}

TEST(ClockBook, TakesAnUnmeasuredPeerToBeOnThisComputerIfItsStampsFit) {
  const ClockBook book(1, 111);

  EXPECT_EQ(book.convert(2, stamp_of(kNow), kNow + milliseconds(30))->time, kNow);
  EXPECT_FALSE(book.convert(2, peer_stamp(kNow), kNow).has_value());
}

TEST(ClockBook, ConvertsTheStampsOfAMeasuredPeer) {
  ClockBook book(1, 111);
  const bus::ClockProbe probe = book.next_probe(kNow);

  book.take_echo(echo_of(probe, kNow + milliseconds(1)), kNow + milliseconds(2));

  const auto converted = book.convert(2, peer_stamp(kNow), kNow + milliseconds(50));
  ASSERT_TRUE(converted.has_value());
  EXPECT_EQ(converted->time, kNow);
  EXPECT_GT(converted->sigma, Duration{0});
}

TEST(ClockBook, IgnoresAnswersToSomebodyElse) {
  ClockBook book(1, 111);
  bus::ClockProbe probe = book.next_probe(kNow);
  probe.id.boot = 999;  // the same robot before it was started anew

  book.take_echo(echo_of(probe, kNow + milliseconds(1)), kNow + milliseconds(2));

  EXPECT_FALSE(book.estimate(2, kNow).has_value());
}

TEST(ClockBook, ForgetsAPeerThatWasStartedAnew) {
  ClockBook book(1, 111);
  book.take_echo(echo_of(book.next_probe(kNow), kNow + milliseconds(1)), kNow + milliseconds(2));
  bus::ClockEcho restarted = echo_of({{1, 1, 1}, {}}, kNow);
  restarted.id.boot = 333;

  book.take_echo(restarted, kNow + seconds(4));

  EXPECT_FALSE(book.estimate(2, kNow + seconds(4)).has_value());
}

TEST(ClockBook, IsNotLedAstrayByASecondComputerOfThatId) {
  ClockBook book(1, 111);
  book.take_echo(echo_of(book.next_probe(kNow), kNow + milliseconds(1)), kNow + milliseconds(2));
  const bus::ClockProbe probe = book.next_probe(kNow + seconds(1));
  bus::ClockEcho second = echo_of(probe, kNow + std::chrono::hours(7));
  second.id.boot = 333;

  book.take_echo(second, kNow + seconds(1) + milliseconds(2));

  EXPECT_EQ(book.convert(2, peer_stamp(kNow), kNow + seconds(1))->time, kNow);
}

TEST(ClockBook, AnswersTwoComputersOfOneId) {
  ClockBook answerer(2, 222);
  answerer.take_probe(ClockBook(1, 111).next_probe(kNow), kNow);
  answerer.take_probe(ClockBook(1, 333).next_probe(kNow), kNow);

  EXPECT_EQ(answerer.next_echo(kNow)->replies.size(), 2U);
}

TEST(ClockBook, AnswersTheNewestQuestionOfEachPeerOnce) {
  ClockBook asker(1, 111);
  ClockBook answerer(2, 222);
  answerer.take_probe(asker.next_probe(kNow), kNow);
  const bus::ClockProbe second = asker.next_probe(kNow + milliseconds(5));
  answerer.take_probe(second, kNow + milliseconds(6));

  const auto echo = answerer.next_echo(kNow + milliseconds(7));

  ASSERT_TRUE(echo.has_value());
  ASSERT_EQ(echo->replies.size(), 1U);
  EXPECT_EQ(echo->replies[0].probe, second.id);
  EXPECT_FALSE(answerer.next_echo(kNow + milliseconds(8)).has_value());
}

TEST(ClockBook, DoesNotAnswerItself) {
  ClockBook book(1, 111);

  book.take_probe(book.next_probe(kNow), kNow);

  EXPECT_FALSE(book.next_echo(kNow).has_value());
}

}  // namespace
}  // namespace teamsight::fusion
