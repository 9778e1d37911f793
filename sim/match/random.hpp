// sim/match/random.hpp: random numbers that are the same on every machine.
#pragma once

#include <cstdint>
#include <random>

namespace teamsight::sim {

/// A stream of random numbers from a seed. Not the standard's distributions: they differ between
/// libraries, and matches in different processes must stay equal.
class Random {
 public:
  explicit Random(std::uint32_t seed) : bits_(seed) {}

  /// In [from, to).
  [[nodiscard]] double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(bits_()) / 4294967296.0;
  }

  /// The sum of twelve uniform numbers: near enough to normal, never beyond 6 sigma.
  [[nodiscard]] double normal(double sigma) {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) {
      sum += uniform(0.0, 1.0);
    }
    return sigma * sum;
  }

  /// True with this probability.
  [[nodiscard]] bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

  /// In [0, count).
  [[nodiscard]] std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>(uniform(0.0, static_cast<double>(count)));
  }

 private:
  std::mt19937 bits_;
};

}  // namespace teamsight::sim
