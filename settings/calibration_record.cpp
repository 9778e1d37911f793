// settings/calibration_record.cpp: covariance to sigmas and correlations, and back.
#include "settings/calibration_record.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "vision/camera_knob_names.hpp"

namespace teamsight::settings {

namespace {

using config::CameraFile;

// The knob of this name among those of the file's kind of mirror.
std::optional<vision::CameraKnob> knob_named(const std::string& name, const CameraFile& file) {
  for (const vision::CameraKnob knob : vision::knobs_of_mirror(file.has_profile())) {
    if (vision::name_of(knob) == name) return knob;
  }
  return std::nullopt;
}

vision::CameraKnob knob_of(const TextFile& text,
                           const CameraFile& file,
                           int i,
                           const std::vector<vision::CameraKnob>& before) {
  const CameraFile::Calibration::Knob& line = file.calibration().knob(i);
  const std::string key = "calibration." + key_of("knob", i);
  const auto knob = knob_named(line.name(), file);
  if (!knob) throw text.error(key + ".name", line.name(), "a knob of this kind of mirror");
  if (std::ranges::find(before, *knob) != before.end()) {
    throw text.error(key + ".name", line.name(), "each knob once");
  }
  if (line.correlation_size() != i) {
    throw text.error(key + ".correlation",
                     std::to_string(line.correlation_size()) + " numbers",
                     std::to_string(i) + ", one for each knob before");
  }
  return *knob;
}

}  // namespace

vision::CalibrationRecord calibration_record(const TextFile& text, const CameraFile& file) {
  const CameraFile::Calibration& source = file.calibration();
  vision::CalibrationRecord record;
  const Eigen::Index size = source.knob_size();
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(size, size);
  Eigen::VectorXd sigma(size);
  for (int i = 0; i < source.knob_size(); ++i) {
    record.knobs.push_back(knob_of(text, file, i, record.knobs));
    sigma[i] = source.knob(i).sigma();
    for (int j = 0; j < i; ++j) {
      correlation(i, j) = correlation(j, i) = source.knob(i).correlation(j);
    }
  }
  const Eigen::LDLT<Eigen::MatrixXd> factors(correlation);
  if (size > 0 && !(factors.vectorD().minCoeff() > 0.0)) {
    throw text.error("calibration.knob",
                     "correlations that contradict each other",
                     "those of a covariance matrix");
  }
  const Eigen::MatrixXd cov = sigma.asDiagonal() * correlation * sigma.asDiagonal();
  record.cov.assign(cov.data(), cov.data() + cov.size());
  record.residual_px = source.residual_px();
  record.views = source.views();
  return record;
}

void write_record(const vision::CalibrationRecord& record, CameraFile::Calibration& out) {
  const std::size_t size = record.knobs.size();
  const auto cov = [&](std::size_t i, std::size_t j) {
    return record.cov[i * size + j];
  };
  for (std::size_t i = 0; i < size; ++i) {
    auto& knob = *out.add_knob();
    knob.set_name(std::string(vision::name_of(record.knobs[i])));
    knob.set_sigma(std::sqrt(cov(i, i)));
    for (std::size_t j = 0; j < i; ++j) {
      knob.add_correlation(cov(i, j) / std::sqrt(cov(i, i) * cov(j, j)));
    }
  }
  out.set_residual_px(record.residual_px);
  out.set_views(record.views);
}

}  // namespace teamsight::settings
