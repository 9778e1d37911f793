// agent/drift_complaint.cpp: see agent/drift_complaint.hpp.
#include "agent/drift_complaint.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace teamsight::agent {

namespace {

constexpr double kNotable = 0.5;        // of the whole error
constexpr std::size_t kMostWords = 95;  // of a report's message

}  // namespace

std::string drift_complaint(const vision::DriftReport& drift) {
  const double least = kNotable * drift.drift_px;
  std::string what;
  if (std::abs(drift.size_px) >= least) what = drift.size_px > 0.0 ? "larger" : "smaller";
  if (std::sqrt(0.5) * drift.shift_px.norm() >= least) {
    const double towards =
        std::atan2(drift.shift_px.y(), drift.shift_px.x()) * 180.0 / std::numbers::pi;
    what += what.empty() ? "" : ", ";
    what += "towards " + std::to_string(std::llround(towards)) + " deg";
  }
  const auto tenths = std::llround(10.0 * drift.drift_px);
  std::string words = "picture off by " + std::to_string(tenths / 10) + "." +
                      std::to_string(tenths % 10) + " px (" + what +
                      "): check the mirror, teamsight calibrate lines";
  if (words.size() > kMostWords) words.resize(kMostWords);
  return words;
}

}  // namespace teamsight::agent
