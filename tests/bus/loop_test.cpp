// tests/bus/loop_test.cpp: the loop with real timers, descriptors, threads and signals.
#include "bus/loop.hpp"

#include <atomic>
#include <csignal>
#include <memory>
#include <thread>

#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "bus/clock.hpp"

namespace teamsight::bus {
namespace {

using std::chrono::milliseconds;

class EventFd {
 public:
  EventFd() : descriptor_(eventfd(0, EFD_NONBLOCK)) {}

  ~EventFd() { ::close(descriptor_); }

  EventFd(const EventFd&) = delete;
  EventFd& operator=(const EventFd&) = delete;

  void signal() const { eventfd_write(descriptor_, 1); }

  void clear() const {
    eventfd_t value = 0;
    eventfd_read(descriptor_, &value);
  }

  [[nodiscard]] int get() const { return descriptor_; }

 private:
  int descriptor_;
};

TEST(Loop, CallsATimerNotBeforeItsPeriod) {
  Loop loop;
  int calls = 0;
  const HostTime start = host_now();
  loop.every(milliseconds(20), [&] {
    if (++calls == 3) loop.stop();
  });

  loop.run();

  EXPECT_EQ(calls, 3);
  EXPECT_GE(host_now() - start, milliseconds(60));
}

TEST(Loop, DoesNotMakeUpMissedTicks) {
  Loop loop;
  int calls = 0;
  loop.every(milliseconds(5), [&] {
    ++calls;
    const HostTime until = host_now() + milliseconds(52);  // ten ticks pass meanwhile
    while (host_now() < until) {
    }
    if (calls == 2) loop.stop();
  });

  const HostTime start = host_now();
  loop.run();

  EXPECT_EQ(calls, 2);
  EXPECT_GE(host_now() - start, milliseconds(100));
}

TEST(Loop, CallsWhatIsReadableUntilItIsForgotten) {
  Loop loop;
  const EventFd event;
  int calls = 0;
  loop.on_readable(event.get(), [&] {
    ++calls;
    event.clear();
    event.signal();
    if (calls == 3) loop.forget(event.get());  // itself, while it runs
  });
  loop.every(milliseconds(50), [&] { loop.stop(); });
  event.signal();

  loop.run();

  EXPECT_EQ(calls, 3);
}

TEST(Loop, IsStoppedFromAnotherThread) {
  Loop loop;
  EXPECT_TRUE(loop.keeps_running());
  std::thread other([&] { loop.stop(); });

  loop.run();
  other.join();

  EXPECT_FALSE(loop.keeps_running());
}

TEST(Loop, DoesNotRunAfterAnEarlierStop) {
  Loop loop;
  loop.stop();
  bool called = false;
  loop.every(milliseconds(1), [&] { called = true; });

  loop.run();

  EXPECT_FALSE(called);
}

class EndingSignal : public ::testing::TestWithParam<int> {};

TEST_P(EndingSignal, EndsTheLoopAndNotTheProcess) {
  Loop loop;
  loop.every(milliseconds(1), [&] { kill(getpid(), GetParam()); });

  loop.run();

  EXPECT_FALSE(loop.keeps_running());
}

TEST_P(EndingSignal, IsSeenBeforeTheLoopRuns) {
  Loop loop;
  kill(getpid(), GetParam());

  EXPECT_FALSE(loop.keeps_running());
}

// Else a program that was told to stop while it joined would die before it could say why.
TEST_P(EndingSignal, ThatNobodyAskedForEndsWithTheLoop) {
  auto loop = std::make_unique<Loop>();
  kill(getpid(), GetParam());

  loop.reset();

  SUCCEED();  // still here
}

INSTANTIATE_TEST_SUITE_P(Both, EndingSignal, ::testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace teamsight::bus
