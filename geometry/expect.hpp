// geometry/expect.hpp: a precondition that a caller inside this code base must keep.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace teamsight::detail {

[[noreturn]] inline void expectation_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: expected: %s\n", file, line, condition);
  std::abort();
}

}  // namespace teamsight::detail

/// Active in every build: prints the broken precondition and aborts, so that the supervisor
/// restarts the process. For mistakes of the caller only, never for data from outside.
#define TEAMSIGHT_EXPECT(condition)   \
  ((condition) ? static_cast<void>(0) \
               : ::teamsight::detail::expectation_failed(#condition, __FILE__, __LINE__))
