// tests/network/loose_clock.cpp: preloaded, it shows the program a wall clock that a test can move.
//
// TEAMSIGHT_LOOSE_CLOCK names a file of 8 bytes: how many seconds the wall clock is ahead. Nothing
// on the machine changes, and no other clock.
#include <cstdint>
#include <cstdlib>
#include <ctime>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

const volatile std::int64_t* map_offset() {
  const char* path = std::getenv("TEAMSIGHT_LOOSE_CLOCK");  // NOLINT(concurrency-mt-unsafe)
  if (path == nullptr) return nullptr;
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return nullptr;
  void* const memory = mmap(nullptr, sizeof(std::int64_t), PROT_READ, MAP_SHARED, file, 0);
  close(file);
  return memory == MAP_FAILED ? nullptr : static_cast<const volatile std::int64_t*>(memory);
}

const volatile std::int64_t* offset() {
  static const volatile std::int64_t* const mapped = map_offset();
  return mapped;
}

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* out) noexcept {
  const long code = syscall(SYS_clock_gettime, clock, out);
  if (code == 0 && clock == CLOCK_REALTIME && offset() != nullptr) out->tv_sec += *offset();
  return static_cast<int>(code);
}

// By the kernel's shared page otherwise, past the function above.
extern "C" std::time_t time(std::time_t* out) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  if (out != nullptr) *out = now.tv_sec;
  return now.tv_sec;
}
