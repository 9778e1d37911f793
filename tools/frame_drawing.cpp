// tools/frame_drawing.cpp: rings and windows on a frame; OpenCV draws.
#include "tools/frame_drawing.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "tools/detection_report.hpp"
#include "tools/picture_mat.hpp"
#include "vision/pixel_reader.hpp"

namespace teamsight::tools {

namespace {

using vision::ColourClass;
using vision::FrameObservation;

constexpr int kZoom = 2;          // so that a mark of one pixel does not hide what it marks
constexpr int kShift = 4;         // OpenCV's fixed point: places are given in 1/16 pixel
constexpr double kLikely = 1.1;   // log-odds; three to one
constexpr double kAround = 10.0;  // px; half the size of a mark around a foot

cv::Point place(double u_px, double v_px) {
  constexpr double kScale = kZoom * (1 << kShift);
  return {static_cast<int>(std::lround((u_px + 0.5) * kScale)),
          static_cast<int>(std::lround((v_px + 0.5) * kScale))};
}

int length(double pixels) {
  return static_cast<int>(std::lround(pixels * kZoom * (1 << kShift)));
}

void mark_line_points(cv::Mat& picture, const FrameObservation& seen) {
  const bool is_lost = seen.line_fits.size() != seen.line_points.size();
  for (std::size_t i = 0; i < seen.line_points.size(); ++i) {
    const bool fits = !is_lost && seen.line_fits[i];
    const cv::Point p = place(seen.line_points[i].u_px, seen.line_points[i].v_px);
    const cv::Scalar colour = fits ? cv::Scalar(0, 255, 0) : cv::Scalar(0, 0, 255);
    cv::circle(picture, p, length(1.0), colour, 1, cv::LINE_AA, kShift);
  }
}

void mark_things(cv::Mat& picture, const FrameObservation& seen) {
  const cv::Scalar magenta(255, 0, 255);
  const cv::Scalar cyan(255, 255, 0);
  const cv::Scalar yellow(0, 255, 255);
  for (const vision::BallPixels& ball : seen.ball_pixels) {
    const cv::Point p = place(ball.u_px, ball.v_px);
    cv::circle(picture, p, length(ball.r_px + 1.5), magenta, 2, cv::LINE_AA, kShift);
  }
  for (const vision::ObstaclePixels& foot : seen.obstacle_pixels) {
    const bool is_robot = foot.kind == vision::ObstacleKind::kRobot;
    const cv::Point p = place(foot.u_px, foot.v_px);
    cv::circle(
        picture, p, length(3.0), is_robot ? cyan : yellow, is_robot ? 2 : 1, cv::LINE_AA, kShift);
  }
}

// A range of 0 is none.
std::string range_text(double range) {
  return range > 0.0 ? fmt::format("{:.1f} m", range) : std::string("-");
}

// Beside each ball: its range along the ray to the floor, by its size, and whether it may fly.
void mark_ranges(cv::Mat& picture, const FrameObservation& seen) {
  for (std::size_t i = 0; i < seen.ball_ranges.size(); ++i) {
    const vision::BallPixels& ball = seen.ball_pixels[i];
    const vision::BallRange& range = seen.ball_ranges[i];
    const std::string text = fmt::format("floor {}, size {}{}",
                                         range_text(range.on_floor),
                                         range_text(range.by_size),
                                         range.flying_log_odds > kLikely ? ", flies" : "");
    const cv::Point at = place(ball.u_px + ball.r_px + 4.0, ball.v_px) / (1 << kShift);
    cv::putText(picture, text, at, cv::FONT_HERSHEY_PLAIN, 0.8, {255, 255, 255});
  }
}

void mark_sensors(cv::Mat& picture, const Shot& shot, const FrameObservation& seen) {
  for (std::size_t i = 0; i < shot.sensors.size() && i < seen.sensors.size(); ++i) {
    const cv::Scalar colour =
        seen.sensors[i].triggered ? cv::Scalar(0, 0, 255) : cv::Scalar(255, 128, 0);
    for (const vision::Polygon& window : shot.sensors[i].windows) {
      std::vector<cv::Point> corners;
      for (const vision::Corner& corner : window) corners.push_back(place(corner.u, corner.v));
      cv::polylines(picture, corners, true, colour, 1, cv::LINE_AA, kShift);
      const cv::Point name_at = corners.front() / (1 << kShift);
      cv::putText(picture, seen.sensors[i].name, name_at, cv::FONT_HERSHEY_PLAIN, 0.8, colour);
    }
  }
}

Picture enlarged(const ImageFile& frame) {
  Picture picture = picture_of(frame);
  cv::Mat larger;
  cv::resize(mat_of(picture), larger, {}, kZoom, kZoom, cv::INTER_LINEAR);
  return picture_of(larger);
}

/// Where a label is, and how it fared.
struct Fate {
  double u{0.0};
  double v{0.0};
  double around{kAround};  ///< px
  bool counts{true};
  bool found{false};
};

void mark_fates(cv::Mat& picture, const std::vector<Fate>& fates) {
  const cv::Scalar green(0, 255, 0);
  const cv::Scalar red(0, 0, 255);
  const cv::Scalar grey(160, 160, 160);
  for (const Fate& fate : fates) {
    const cv::Scalar counted = fate.found ? green : red;
    cv::circle(picture,
               place(fate.u, fate.v),
               length(fate.around),
               fate.counts ? counted : grey,
               2,
               cv::LINE_AA,
               kShift);
  }
}

void mark_false(cv::Mat& picture,
                const std::vector<Detection>& detections,
                const std::vector<Verdict>& verdicts) {
  const cv::Scalar orange(0, 128, 255);
  const cv::Point corner(length(kAround), length(kAround));
  for (std::size_t i = 0; i < detections.size(); ++i) {
    if (verdicts[i] != Verdict::kWrong) continue;
    const cv::Point middle = place(detections[i].u, detections[i].v);
    cv::rectangle(picture, middle - corner, middle + corner, orange, 2, cv::LINE_AA, kShift);
  }
}

cv::Vec3b paint_of(ColourClass colour) {
  switch (colour) {
    case ColourClass::kGreen:
      return {0, 150, 0};
    case ColourClass::kBall:
      return {0, 140, 255};
    case ColourClass::kBlue:
      return {255, 0, 0};
    case ColourClass::kYellow:
      return {0, 255, 255};
    case ColourClass::kMagenta:
      return {255, 0, 255};
    case ColourClass::kCyan:
      return {255, 255, 0};
    case ColourClass::kRed:
      return {0, 0, 255};
    case ColourClass::kWhite:
      return {255, 255, 255};
    case ColourClass::kBlack:
      return {0, 0, 0};
    case ColourClass::kNone:
      break;
  }
  return {110, 110, 110};
}

}  // namespace

Picture marked_frame(const Shot& shot, const FrameObservation& seen) {
  Picture picture = enlarged(shot.frame);
  cv::Mat canvas = mat_of(picture);
  mark_line_points(canvas, seen);
  mark_things(canvas, seen);
  mark_ranges(canvas, seen);
  mark_sensors(canvas, shot, seen);
  return picture;
}

Picture judged_frame(const Shot& shot, const FrameObservation& seen, const ImageLabels& labels) {
  const std::vector<Detection> balls = ball_places(seen);
  const std::vector<Detection> robots = robot_places(seen);
  Picture picture = enlarged(shot.frame);
  cv::Mat canvas = mat_of(picture);
  mark_things(canvas, seen);
  mark_sensors(canvas, shot, seen);
  std::vector<Fate> fates;
  const std::vector<bool> found_balls = balls_found(labels, balls);
  for (std::size_t i = 0; i < labels.balls.size(); ++i) {
    const LabelledBall& ball = labels.balls[i];
    fates.push_back({ball.u, ball.v, ball.radius + 4.0, ball.counts, found_balls[i]});
  }
  const std::vector<bool> found_robots = robots_found(labels, robots);
  for (std::size_t i = 0; i < labels.robots.size(); ++i) {
    const LabelledFoot& robot = labels.robots[i];
    fates.push_back({robot.u, robot.v, kAround, robot.counts, found_robots[i]});
  }
  const std::vector<bool> found_people = people_found(labels, robots, leg_places(seen));
  for (std::size_t i = 0; i < labels.people.size(); ++i) {
    const LabelledFoot& person = labels.people[i];
    fates.push_back({person.u, person.v, 2.0 * kAround, person.counts, found_people[i]});
  }
  mark_fates(canvas, fates);
  mark_false(canvas, balls, judge_balls(labels, balls));
  mark_false(canvas, robots, judge_robots(labels, robots));
  return picture;
}

Picture class_picture(const ImageFile& frame, const vision::ColourClasses& colours) {
  const vision::PixelReader pixels(frame.view());
  Picture classes = picture_of(frame);
  cv::Mat canvas = mat_of(classes);
  std::size_t pixel = 0;
  for (int v = 0; v < canvas.rows; ++v) {
    for (int u = 0; u < canvas.cols; ++u, ++pixel) {
      canvas.at<cv::Vec3b>(v, u) =
          paint_of(colours.of(pixels.luminance(pixel), pixels.chroma(pixel)));
    }
  }
  return beside(picture_of(frame), classes);
}

}  // namespace teamsight::tools
