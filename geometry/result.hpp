// geometry/result.hpp: a value, or the reason why there is none.
#pragma once

#include <utility>

#include <tl/expected.hpp>

namespace teamsight {

/// What a function returns that can fail for a reason the caller deals with.
///
/// An alias, so that moving to `std::expected` is this one line.
template <class Value, class Error>
using Result = tl::expected<Value, Error>;

/// The failure side of a `Result`: `return failure(Reject::kStale);`
template <class Error>
[[nodiscard]] constexpr tl::unexpected<Error> failure(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

}  // namespace teamsight
