// bus/monotonic_wait.cpp: timed waits of the whole process that no step of the wall clock moves.
//
// Cyclone DDS 0.10.2 waits with pthread_cond_timedwait on CLOCK_REALTIME: when the wall clock is
// set back by five seconds, its event thread stands still for as long. This definition, linked into
// the executable, takes the place of glibc's for every library of the process. Not for sanitizer
// builds, which put their own in the same place.
#include <cstdint>
#include <ctime>

#include <pthread.h>

namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

std::int64_t nanoseconds(const timespec& time) {
  return time.tv_sec * kNanosecondsPerSecond + time.tv_nsec;
}

std::int64_t now_on(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return nanoseconds(now);
}

std::int64_t magnitude(std::int64_t value) {
  return value < 0 ? -value : value;
}

}  // namespace

// NOLINTNEXTLINE(readability-inconsistent-declaration-parameter-name): glibc's names are reserved
extern "C" int pthread_cond_timedwait(pthread_cond_t* condition,
                                      pthread_mutex_t* mutex,
                                      const timespec* deadline) {
  // Out of range is the caller's error to hear about; a deadline centuries away needs no care.
  constexpr std::int64_t kFarAwaySeconds = 4'000'000'000;
  const bool ordinary = deadline->tv_sec >= 0 && deadline->tv_sec < kFarAwaySeconds &&
                        deadline->tv_nsec >= 0 && deadline->tv_nsec < kNanosecondsPerSecond;
  if (!ordinary) return pthread_cond_clockwait(condition, mutex, CLOCK_REALTIME, deadline);
  const std::int64_t until = nanoseconds(*deadline);
  const std::int64_t real = now_on(CLOCK_REALTIME);
  const std::int64_t monotonic = now_on(CLOCK_MONOTONIC);
  // A condition may have been made for CLOCK_MONOTONIC; its deadlines lie near uptime, not near
  // the years since 1970.
  const bool is_real = magnitude(until - real) < magnitude(until - monotonic);
  const std::int64_t converted = is_real ? monotonic + (until - real) : until;
  const timespec target{
      converted < 0 ? 0 : converted / kNanosecondsPerSecond,
      converted < 0 ? 0 : converted % kNanosecondsPerSecond,
  };
  return pthread_cond_clockwait(condition, mutex, CLOCK_MONOTONIC, &target);
}
