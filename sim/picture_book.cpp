// sim/picture_book.cpp: see picture_book.hpp.
#include "sim/picture_book.hpp"

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "sim/match/wheels.hpp"

namespace teamsight::sim {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// One robot with all that it keeps from frame to frame.
struct Reporter {
  std::size_t player{0};
  Eye eye;
  Wheels wheels;
  Random noise;
  Scene scene;
  std::vector<std::uint8_t> picture;
};

Json pose_of(double x, double y, double theta) {
  return {{"x_m", x}, {"y_m", y}, {"theta_rad", theta}};
}

Json ball_line(const Ball& ball, const Reporter& reporter) {
  const Point3<Robot> p_RB = reporter.scene.X_FR.inverse() * ball.p_FB;
  const auto place = reporter.eye.renderer.find(p_RB);
  return {{"x_m", ball.p_FB.x},
          {"y_m", ball.p_FB.y},
          {"z_m", ball.p_FB.z},
          {"vx_mps", ball.v_FB.x},
          {"vy_mps", ball.v_FB.y},
          {"vz_mps", ball.v_FB.z},
          {"u_px", place.has_value() ? Json(place->u) : Json()},
          {"v_px", place.has_value() ? Json(place->v) : Json()}};
}

Json truth_line(const std::string& image, const Match& match, const Reporter& reporter) {
  const MatchState& state = match.state();
  const Player& self = state.players[reporter.player];
  Json line{{"image", image}, {"robot", self.number}, {"time_s", match.time()}};
  line.update(pose_of(self.X_FR.x(), self.X_FR.y(), self.X_FR.theta()));
  const auto& X_DR = reporter.wheels.pose();
  line["odometry"] = pose_of(X_DR.x(), X_DR.y(), X_DR.theta());
  line["balls"] = Json::array();
  for (const Ball& ball : state.balls) {
    line["balls"].push_back(ball_line(ball, reporter));
  }
  line["robots"] = Json::array();
  for (const Player& other : state.players) {
    if (other.on_field && other.number != self.number) {
      line["robots"].push_back(
          {{"number", other.number}, {"x_m", other.X_FR.x()}, {"y_m", other.X_FR.y()}});
    }
  }
  return line;
}

void write_picture(const fs::path& file, std::optional<int> jpeg_quality, Reporter& reporter) {
  const vision::CameraParameters& camera = reporter.eye.renderer.camera();
  const cv::Mat image(static_cast<int>(camera.height_px),
                      static_cast<int>(camera.width_px),
                      CV_8UC3,
                      reporter.picture.data());
  const std::vector<int> quality{cv::IMWRITE_JPEG_QUALITY, jpeg_quality.value_or(0)};
  if (!cv::imwrite(file.string(), image, jpeg_quality ? quality : std::vector<int>{})) {
    throw std::runtime_error(file.string() + ": cannot be written");
  }
}

std::string image_name(const Player& player, int frame, const PictureBook& book) {
  char name[40];
  const char* const ending = book.jpeg_quality ? "jpg" : "png";
  std::snprintf(name, sizeof(name), "robot%d_%06d.%s", player.number, frame, ending);
  return name;
}

std::vector<Reporter> reporters_of(const Setup& setup) {
  std::vector<Reporter> reporters;
  for (std::size_t i = 0; i < setup.parameters.own.size(); ++i) {
    const auto seed = static_cast<std::uint32_t>(i) + 1000 * setup.parameters.seed;
    reporters.push_back(
        {i, make_eye(setup, i, vision::PixelFormat::kBgr), Wheels({}, seed), Random(seed), {}, {}});
  }
  return reporters;
}

// The match and every robot's odometry go on to the time of the frame.
void play_until(double time, Match& match, std::vector<Reporter>& reporters) {
  while (match.time() + Match::kStep <= time + 1e-9) {
    match.advance_to(match.time() + Match::kStep);
    for (Reporter& reporter : reporters) {
      reporter.wheels.roll(match.state().players[reporter.player], Match::kStep);
    }
  }
}

void write_page(const Match& match,
                int frame,
                const PictureBook& book,
                Reporter& reporter,
                std::ostream& truth) {
  const Player& self = match.state().players[reporter.player];
  if (!self.on_field) {
    return;
  }
  show(match.state(), reporter.player, reporter.eye.bodies, reporter.scene);
  reporter.eye.renderer.draw(reporter.scene, reporter.noise, reporter.picture);
  const std::string image = image_name(self, frame, book);
  write_picture(book.folder / image, book.jpeg_quality, reporter);
  truth << truth_line(image, match, reporter).dump() << '\n';
}

void write_pages(const Setup& setup, const PictureBook& book, const Progress& told) {
  Match match(setup.parameters, setup.field);
  std::vector<Reporter> reporters = reporters_of(setup);
  const fs::path truth_file = book.folder / "truth.jsonl";
  std::ofstream truth(truth_file);
  const int frames = static_cast<int>(book.seconds * setup.match.frame_rate_hz);
  for (int frame = 0; frame < frames; ++frame) {
    play_until(frame / setup.match.frame_rate_hz, match, reporters);
    for (Reporter& reporter : reporters) {
      write_page(match, frame, book, reporter, truth);
    }
    told(frame + 1, frames);
  }
  if (!truth.flush()) {
    throw std::runtime_error(truth_file.string() + ": cannot be written");
  }
}

}  // namespace

void write_picture_book(const Setup& setup, const PictureBook& book, const Progress& told) {
  if (fs::exists(book.folder)) {
    throw std::runtime_error(book.folder.string() +
                             ": found something, expected no such folder yet");
  }
  PictureBook unfinished = book;
  unfinished.folder += ".part";
  fs::remove_all(unfinished.folder);
  fs::create_directories(unfinished.folder);
  try {
    write_pages(setup, unfinished, told);
    fs::rename(unfinished.folder, book.folder);
  } catch (...) {
    fs::remove_all(unfinished.folder);
    throw;
  }
}

}  // namespace teamsight::sim
