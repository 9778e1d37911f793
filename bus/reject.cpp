// bus/reject.cpp: the names of the reasons.
#include "bus/reject.hpp"

#include <numeric>

namespace teamsight::bus {

std::string_view to_string(Reject reason) noexcept {
  switch (reason) {
    case Reject::kNotFinite:
      return "not_finite";
    case Reject::kBadCovariance:
      return "bad_covariance";
    case Reject::kBadIdentity:
      return "bad_identity";
    case Reject::kBadEnum:
      return "bad_enum";
    case Reject::kOutOfRange:
      return "out_of_range";
    case Reject::kUnbounded:
      return "unbounded";
    case Reject::kDuplicate:
      return "duplicate";
    case Reject::kForeignIdentity:
      return "foreign_identity";
    case Reject::kImplausibleStamp:
      return "implausible_stamp";
    case Reject::kImplausibleNumber:
      return "implausible_number";
  }
  return "unknown";
}

std::uint64_t ReadCounters::total_rejected() const noexcept {
  return std::accumulate(rejected.begin(), rejected.end(), std::uint64_t{0});
}

}  // namespace teamsight::bus
