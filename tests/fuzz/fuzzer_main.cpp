// tests/fuzz/fuzzer_main.cpp: libFuzzer's way into the subject that TEAMSIGHT_FUZZ_SUBJECT names.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/subjects.hpp"

// The name is libFuzzer's.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string fault = teamsight::fuzz::TEAMSIGHT_FUZZ_SUBJECT({bytes, size});
  if (fault.empty()) return 0;
  std::fprintf(stderr, "fault: %s\n", fault.c_str());
  std::abort();
}
