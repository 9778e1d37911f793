// tests/fusion/seeded_check.hpp: rapidcheck with a seed that stands in the test.
#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace teamsight::fusion::test {

/// Fails the running test if `property` does not hold for `cases` inputs drawn with `seed`.
template <class Property>
void check_property(std::uint64_t seed, int cases, Property&& property) {
  rc::detail::TestParams parameters;
  parameters.seed = seed;
  parameters.maxSuccess = cases;
  const auto result = rc::detail::checkTestable(
      std::forward<Property>(property), rc::detail::TestMetadata{}, parameters);
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  EXPECT_TRUE(result.template is<rc::detail::SuccessResult>()) << message.str();
}

}  // namespace teamsight::fusion::test
