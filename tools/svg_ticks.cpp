// tools/svg_ticks.cpp: round numbers for axes.
#include "tools/svg_ticks.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace teamsight::plot {
namespace {

/// The smallest of 1, 2, 5 times a power of ten that is not less than `least`.
double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1.0 - 1e-9)) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

bool is_on(const Axis& axis, double value) {
  return value >= axis.low * (1.0 - 1e-9) && value <= axis.high * (1.0 + 1e-9);
}

std::vector<double> decade_ticks(const Axis& axis) {
  const bool is_wide = axis.high / axis.low > 2000.0;
  const int first = static_cast<int>(std::floor(std::log10(axis.low)));
  const int last = static_cast<int>(std::ceil(std::log10(axis.high)));
  constexpr std::array kFactors{1.0, 2.0, 5.0};
  std::vector<double> result;
  for (int k = 3 * first; k < 3 * last + 3; ++k) {
    const int exponent = static_cast<int>(std::floor(k / 3.0));
    const double factor = kFactors.at(static_cast<std::size_t>(k - 3 * exponent));
    const double value = factor * std::pow(10.0, exponent);
    if (is_on(axis, value) && (!is_wide || factor == 1.0)) {
      result.push_back(value);
    }
  }
  return result;
}

}  // namespace

std::vector<double> ticks(const Axis& axis, int count) {
  if (axis.is_logarithmic) {
    return decade_ticks(axis);
  }
  const double step = round_step((axis.high - axis.low) / count);
  std::vector<double> result;
  const double first = std::ceil(axis.low / step - 1e-9);
  for (double k = first; k * step <= axis.high + 1e-9 * step; k += 1.0) {
    result.push_back(k * step);
  }
  return result;
}

std::string tick_text(double value) {
  return fmt::format("{:g}", std::abs(value) < 1e-12 ? 0.0 : std::round(value * 1e9) / 1e9);
}

double along(const Axis& axis, double value) {
  if (axis.is_logarithmic) {
    return std::log(value / axis.low) / std::log(axis.high / axis.low);
  }
  return (value - axis.low) / (axis.high - axis.low);
}

}  // namespace teamsight::plot
