// process/token_bucket.hpp: lets so many bytes through a second, with a little at once.
#pragma once

#include <algorithm>

#include "geometry/time.hpp"

namespace teamsight::process {

/// A value; time as an argument.
class TokenBucket {
 public:
  /// @param rate   bytes per second
  /// @param burst  bytes that may go at once after a pause
  TokenBucket(double rate, double burst) : rate_(rate), burst_(burst), tokens_(burst) {}

  /// Takes `bytes` out, if they are there.
  [[nodiscard]] bool take(double bytes, HostTime now) {
    if (last_ != HostTime{}) tokens_ = std::min(burst_, tokens_ + rate_ * to_seconds(now - last_));
    last_ = now;
    if (bytes > tokens_) return false;
    tokens_ -= bytes;
    return true;
  }

 private:
  double rate_;
  double burst_;
  double tokens_;
  HostTime last_{};
};

}  // namespace teamsight::process
