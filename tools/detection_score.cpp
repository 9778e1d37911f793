// tools/detection_score.cpp: matching detections with labels, and counting.
#include "tools/detection_score.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace teamsight::tools {

namespace {

constexpr double kLeastBall = 4.0;     // px
constexpr double kFootReach = 15.0;    // px
constexpr double kPersonReach = 40.0;  // px; people have two feet and one label

double apart(const Detection& detection, double u, double v) {
  return std::hypot(detection.u - u, detection.v - v);
}

double reach_of(const LabelledBall& ball) {
  return std::max(ball.radius, kLeastBall);
}

/// Detections that no label has taken yet.
class Unmatched {
 public:
  explicit Unmatched(const std::vector<Detection>& detections)
      : detections_(detections),
        taken_(detections.size(), false) {}

  /// Takes the nearest free one; nothing if none is within `reach`.
  std::optional<double> take(double u, double v, double reach) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < detections_.size(); ++i) {
      const double distance = apart(detections_[i], u, v);
      if (taken_[i] || distance > reach) continue;
      if (!best || distance < apart(detections_[*best], u, v)) best = i;
    }
    if (!best) return std::nullopt;
    taken_[*best] = true;
    return apart(detections_[*best], u, v);
  }

  [[nodiscard]] bool is_taken(std::size_t i) const { return taken_[i]; }

  template <class Claim>
  void count_rest(Tally& tally, Claim is_excused) const {
    for (std::size_t i = 0; i < detections_.size(); ++i) {
      if (taken_[i] || is_excused(detections_[i])) continue;
      ++(detections_[i].on_carpet ? tally.wrong : tally.outside);
    }
  }

 private:
  const std::vector<Detection>& detections_;
  std::vector<bool> taken_;
};

void note(Tally& tally, bool counts, const std::optional<double>& error) {
  if (counts) ++tally.labelled;
  if (!error) return;
  ++tally.right;
  if (!counts) return;
  ++tally.found;
  tally.errors_px.push_back(*error);
}

LabelledFoot foot_of(const nlohmann::json& entry) {
  const bool touches = entry.contains("note");
  return {entry.at("u"), entry.at("v"), entry.at("certain").get<bool>() && !touches};
}

LabelledBall ball_of(const nlohmann::json& entry) {
  // Where something hides a part, the whole ball is what a detector should name.
  const nlohmann::json& shape = entry.contains("full") ? entry.at("full") : entry;
  return {shape.at("u"),
          shape.at("v"),
          shape.at("r_px"),
          entry.at("certain").get<bool>() && entry.at("on_field").get<bool>()};
}

ImageLabels labels_of(const nlohmann::json& entry) {
  ImageLabels labels;
  labels.image = entry.at("image");
  for (const auto& ball : entry.at("balls")) labels.balls.push_back(ball_of(ball));
  for (const auto& robot : entry.at("robots")) labels.robots.push_back(foot_of(robot));
  for (const auto& person : entry.at("people")) labels.people.push_back(foot_of(person));
  return labels;
}

// All obstacles but those that robots' labels take.
std::vector<Detection> not_of_robots(const ImageLabels& labels,
                                     const std::vector<Detection>& robots,
                                     const std::vector<Detection>& legs) {
  Unmatched unmatched(robots);
  for (const LabelledFoot& robot : labels.robots) {
    (void)unmatched.take(robot.u, robot.v, kFootReach);
  }
  std::vector<Detection> others = legs;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!unmatched.is_taken(i)) others.push_back(robots[i]);
  }
  return others;
}

bool is_excused(const ImageLabels& labels, const Detection& detection) {
  const auto is_near = [&](const LabelledFoot& foot) {
    return apart(detection, foot.u, foot.v) <= kPersonReach;
  };
  return std::ranges::any_of(labels.people, is_near) ||
         std::ranges::any_of(labels.robots, [&](const LabelledFoot& robot) {
           return !robot.counts && is_near(robot);
         });
}

}  // namespace

std::vector<ImageLabels> read_labels(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read, expected labels.json");
  try {
    std::vector<ImageLabels> labels;
    for (const auto& entry : nlohmann::json::parse(file)) labels.push_back(labels_of(entry));
    return labels;
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(path + ": " + error.what() + ", expected a list of labelled images");
  }
}

Tally& Tally::operator+=(const Tally& other) {
  labelled += other.labelled;
  found += other.found;
  right += other.right;
  wrong += other.wrong;
  outside += other.outside;
  errors_px.insert(errors_px.end(), other.errors_px.begin(), other.errors_px.end());
  return *this;
}

double Tally::recall() const {
  return labelled == 0 ? 1.0 : static_cast<double>(found) / static_cast<double>(labelled);
}

double Tally::precision() const {
  const std::size_t all = found + wrong;
  return all == 0 ? 1.0 : static_cast<double>(found) / static_cast<double>(all);
}

Tally score_balls(const ImageLabels& labels, const std::vector<Detection>& balls) {
  Tally tally;
  Unmatched unmatched(balls);
  for (const LabelledBall& ball : labels.balls) {
    note(tally, ball.counts, unmatched.take(ball.u, ball.v, reach_of(ball)));
  }
  unmatched.count_rest(tally, [](const Detection&) { return false; });
  return tally;
}

Tally score_robots(const ImageLabels& labels, const std::vector<Detection>& obstacles) {
  Tally tally;
  Unmatched unmatched(obstacles);
  for (const LabelledFoot& robot : labels.robots) {
    note(tally, robot.counts, unmatched.take(robot.u, robot.v, kFootReach));
  }
  unmatched.count_rest(tally,
                       [&](const Detection& detection) { return is_excused(labels, detection); });
  return tally;
}

Tally score_people(const ImageLabels& labels,
                   const std::vector<Detection>& robots,
                   const std::vector<Detection>& legs) {
  Tally tally;
  const std::vector<Detection> obstacles = not_of_robots(labels, robots, legs);
  Unmatched unmatched(obstacles);
  for (const LabelledFoot& person : labels.people) {
    note(tally, person.counts, unmatched.take(person.u, person.v, kPersonReach));
  }
  for (const Detection& leg : legs) {
    const auto is_near = [&](const LabelledFoot& foot) {
      return apart(leg, foot.u, foot.v) <= kPersonReach;
    };
    if (std::ranges::any_of(labels.people, is_near)) continue;
    if (std::ranges::any_of(labels.robots, is_near)) continue;
    ++(leg.on_carpet ? tally.wrong : tally.outside);
  }
  return tally;
}

std::vector<bool> people_found(const ImageLabels& labels,
                               const std::vector<Detection>& robots,
                               const std::vector<Detection>& legs) {
  const std::vector<Detection> obstacles = not_of_robots(labels, robots, legs);
  Unmatched unmatched(obstacles);
  std::vector<bool> found;
  for (const LabelledFoot& person : labels.people) {
    found.push_back(unmatched.take(person.u, person.v, kPersonReach).has_value());
  }
  return found;
}

std::vector<bool> balls_found(const ImageLabels& labels, const std::vector<Detection>& balls) {
  Unmatched unmatched(balls);
  std::vector<bool> found;
  for (const LabelledBall& ball : labels.balls) {
    found.push_back(unmatched.take(ball.u, ball.v, reach_of(ball)).has_value());
  }
  return found;
}

std::vector<bool> robots_found(const ImageLabels& labels, const std::vector<Detection>& obstacles) {
  Unmatched unmatched(obstacles);
  std::vector<bool> found;
  for (const LabelledFoot& robot : labels.robots) {
    found.push_back(unmatched.take(robot.u, robot.v, kFootReach).has_value());
  }
  return found;
}

std::vector<Verdict> judge_balls(const ImageLabels& labels, const std::vector<Detection>& balls) {
  Unmatched unmatched(balls);
  for (const LabelledBall& ball : labels.balls) {
    if (ball.counts) (void)unmatched.take(ball.u, ball.v, reach_of(ball));
  }
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const bool excused = std::ranges::any_of(labels.balls, [&](const LabelledBall& ball) {
      return apart(balls[i], ball.u, ball.v) <= reach_of(ball);
    });
    const Verdict otherwise = excused ? Verdict::kExcused : Verdict::kWrong;
    verdicts.push_back(unmatched.is_taken(i) ? Verdict::kRight : otherwise);
  }
  return verdicts;
}

std::vector<Verdict> judge_robots(const ImageLabels& labels,
                                  const std::vector<Detection>& obstacles) {
  Unmatched unmatched(obstacles);
  for (const LabelledFoot& robot : labels.robots) {
    (void)unmatched.take(robot.u, robot.v, kFootReach);
  }
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const bool excused = is_excused(labels, obstacles[i]);
    const Verdict otherwise = excused ? Verdict::kExcused : Verdict::kWrong;
    verdicts.push_back(unmatched.is_taken(i) ? Verdict::kRight : otherwise);
  }
  return verdicts;
}

Interval wilson(std::size_t hits, std::size_t trials) {
  if (trials == 0) return {};
  constexpr double kZ = 1.959964;
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(hits) / n;
  const double scale = 1.0 + kZ * kZ / n;
  const double middle = (p + kZ * kZ / (2.0 * n)) / scale;
  const double half = kZ * std::sqrt(p * (1.0 - p) / n + kZ * kZ / (4.0 * n * n)) / scale;
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace teamsight::tools
