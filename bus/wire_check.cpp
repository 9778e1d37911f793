// bus/wire_check.cpp: the rules that several wire types share.
#include "bus/wire_check.hpp"

#include <string_view>

#include <Eigen/Core>

#include "bus/wire_convert.hpp"
#include "geometry/identity.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::bus {
namespace {

// How many bytes of UTF-8 begin with this one; 0 = none may.
std::size_t utf8_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

// Overlong forms and surrogates, which only the second byte shows.
bool is_bad_second_byte(unsigned char first, unsigned char second) {
  return (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
         (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
}

bool starts_with_a_character(std::string_view text, std::size_t length) {
  if (length == 0 || text.size() < length) return false;
  const auto first = static_cast<unsigned char>(text[0]);
  if (length == 1) return first >= 0x20 && first != 0x7F;
  if (is_bad_second_byte(first, static_cast<unsigned char>(text[1]))) return false;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) return false;
  }
  return true;
}

bool is_clean_text(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(static_cast<unsigned char>(text[0]));
    if (!starts_with_a_character(text, length)) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace

void WireCheck::stamps(std::int64_t exposure_ns, std::int64_t publish_ns) noexcept {
  stamp(exposure_ns);
  stamp(publish_ns);
  require(publish_ns >= exposure_ns, Reject::kImplausibleStamp);
}

void WireCheck::sample_id(const teamsight_v1_SampleId& id) noexcept {
  require(id.robot_id <= kMaxRobotId && id.boot_id != 0 && id.sequence_number != 0,
          Reject::kBadIdentity);
}

void WireCheck::host_sample(std::uint8_t key, const teamsight_v1_SampleId& id) noexcept {
  sample_id(id);
  require(key == id.robot_id, Reject::kBadIdentity);
}

void WireCheck::robot_sample(std::uint8_t key, const teamsight_v1_SampleId& id) noexcept {
  host_sample(key, id);
  require(key != kNobody, Reject::kBadIdentity);
}

void WireCheck::team_sample(std::uint8_t key, const teamsight_v1_SampleId& id) noexcept {
  sample_id(id);
  require(key == 0, Reject::kBadIdentity);
}

void WireCheck::covariance(const float* triangle, int size) noexcept {
  for (int i = 0; i < size * (size + 1) / 2; ++i) {
    require(std::isfinite(triangle[i]), Reject::kNotFinite);
  }
  require(size == 2 ? is_covariance(symmetric<2>(triangle)) : is_covariance(symmetric<3>(triangle)),
          Reject::kBadCovariance);
}

void WireCheck::posture(const teamsight_v1_Posture& posture) noexcept {
  within(posture.x_m, kLargestDistance);
  within(posture.y_m, kLargestDistance);
  within(posture.theta_rad, kLargestAngle);
  covariance(posture.cov, 3);
}

void WireCheck::posture_report(const teamsight_v1_PostureReport& report) noexcept {
  enumerator(report.status, teamsight_v1_POSTURE_OK);
  posture(report.posture);
  within(report.half_log_odds, kLargestLogOdds);
  share(report.inlier_ratio);
}

void WireCheck::text(const char* characters, std::size_t size) noexcept {
  const std::size_t length = strnlen(characters, size);
  require(length < size, Reject::kUnbounded);
  require(is_clean_text({characters, length}), Reject::kOutOfRange);
}

}  // namespace teamsight::bus
