// tests/support/spoilt.hpp: bytes that were good once, for decoders of what comes from outside.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include <rapidcheck.h>

namespace teamsight::testing_support {

/// Changes good bytes at one to four places: some are cut out, made up, or said twice.
///
/// Inside of a property only: what it does is drawn from rapidcheck.
inline std::string spoilt_at_random(std::string bytes) {
  const int changes = *rc::gen::inRange(1, 5);
  for (int i = 0; i < changes; ++i) {
    const auto size = static_cast<int>(bytes.size());
    const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, size + 1));
    const auto length = static_cast<std::size_t>(*rc::gen::inRange(0, 9));
    const std::string part = bytes.substr(at, length);
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        bytes.erase(at, length);
        break;
      case 1:
        bytes.insert(at, *rc::gen::container<std::string>(length, rc::gen::arbitrary<char>()));
        break;
      case 2:
        bytes.replace(at,
                      part.size(),
                      *rc::gen::container<std::string>(part.size(), rc::gen::arbitrary<char>()));
        break;
      default:
        bytes.insert(at, part);
        break;
    }
  }
  return bytes;
}

}  // namespace teamsight::testing_support
