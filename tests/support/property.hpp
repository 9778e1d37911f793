// tests/support/property.hpp: properties by rapidcheck, with the seed written in the test.
#pragma once

#include <cstdint>
#include <sstream>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace teamsight::testing_support {

/// Checks a property against `cases` random arguments and fails the running test with the smallest
/// counterexample. Inside, use RC_ASSERT; gtest's EXPECT does not stop the search.
///
/// @param seed      written in the test, so that every run tries the same arguments
/// @param property  called with arguments that rapidcheck makes, or none and `*rc::gen::...` inside
template <class Property>
void holds_for_all(std::uint64_t seed, Property&& property, int cases = 200) {
  rc::detail::TestParams params;
  params.seed = seed;
  params.maxSuccess = cases;
  const auto result = rc::detail::checkTestable(
      std::forward<Property>(property), rc::detail::TestMetadata{}, params);
  if (result.template is<rc::detail::SuccessResult>()) return;
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  FAIL() << text.str();
}

/// A number from `low` to `high` in steps of a 10,000th of the way: shrinks towards `low`.
inline rc::Gen<double> number(double low, double high) {
  constexpr int kSteps = 10000;
  return rc::gen::map(rc::gen::inRange(0, kSteps + 1),
                      [=](int step) { return low + (high - low) * step / kSteps; });
}

}  // namespace teamsight::testing_support
