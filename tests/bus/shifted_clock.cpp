// tests/bus/shifted_clock.cpp: preloaded, it shows the program a wall clock five seconds ahead.
//
// A deadline computed on that clock lies five seconds too far ahead for a wait on the real one:
// the same as a wall clock that was set back by five seconds in the meantime. Nothing on the
// machine changes.
#include <ctime>

#include <sys/syscall.h>
#include <unistd.h>

extern "C" int clock_gettime(clockid_t clock, timespec* out) noexcept {
  const long code = syscall(SYS_clock_gettime, clock, out);
  if (code == 0 && clock == CLOCK_REALTIME) out->tv_sec += 5;
  return static_cast<int>(code);
}
