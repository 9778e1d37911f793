// tools/detection_report.cpp: see tools/detection_report.hpp.
#include "tools/detection_report.hpp"

#include <algorithm>
#include <vector>

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

ordered_json entry_of(const Tally& tally) {
  const Interval recall = wilson(tally.found, tally.labelled);
  const Interval precision = wilson(tally.found, tally.found + tally.wrong);
  std::vector<double> errors = tally.errors_px;
  std::ranges::sort(errors);
  ordered_json entry;
  entry["labelled"] = tally.labelled;
  entry["found"] = tally.found;
  entry["false_on_carpet"] = tally.wrong;
  entry["off_carpet"] = tally.outside;
  entry["recall"] = tally.recall();
  entry["recall_95"] = {recall.low, recall.high};
  entry["precision"] = tally.precision();
  entry["precision_95"] = {precision.low, precision.high};
  entry["median_error_px"] =
      errors.empty() ? ordered_json() : ordered_json(errors[errors.size() / 2]);
  return entry;
}

std::vector<Detection> feet_of(const vision::FrameObservation& seen, vision::ObstacleKind kind) {
  std::vector<Detection> feet;
  for (const vision::ObstaclePixels& foot : seen.obstacle_pixels) {
    if (foot.kind == kind) feet.push_back({foot.u_px, foot.v_px, foot.on_carpet});
  }
  return feet;
}

}  // namespace

Score& Score::operator+=(const Score& other) {
  balls += other.balls;
  robots += other.robots;
  people += other.people;
  return *this;
}

std::vector<Detection> ball_places(const vision::FrameObservation& seen) {
  std::vector<Detection> balls;
  for (const vision::BallPixels& ball : seen.ball_pixels) {
    balls.push_back({ball.u_px, ball.v_px, ball.on_carpet});
  }
  return balls;
}

std::vector<Detection> robot_places(const vision::FrameObservation& seen) {
  return feet_of(seen, vision::ObstacleKind::kRobot);
}

std::vector<Detection> leg_places(const vision::FrameObservation& seen) {
  return feet_of(seen, vision::ObstacleKind::kLegs);
}

Score score_of(const ImageLabels& labels, const vision::FrameObservation& seen) {
  return {score_balls(labels, ball_places(seen)),
          score_robots(labels, robot_places(seen)),
          score_people(labels, robot_places(seen), leg_places(seen))};
}

ordered_json report_of(const Score& score) {
  ordered_json report;
  report["balls"] = entry_of(score.balls);
  report["robots"] = entry_of(score.robots);
  report["people"] = entry_of(score.people);
  return report;
}

}  // namespace teamsight::tools
