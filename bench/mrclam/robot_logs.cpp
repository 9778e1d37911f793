// bench/mrclam/robot_logs.cpp: see bench/mrclam/robot_logs.hpp.
#include "bench/mrclam/robot_logs.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

#include <zlib.h>

namespace teamsight::mrclam {
namespace {

namespace fs = std::filesystem;
using Row = std::vector<double>;

[[noreturn]] void refuse(const fs::path& file, int line, const std::string& why) {
  throw std::runtime_error(file.string() + ":" + std::to_string(line) + ": " + why);
}

Row numbers_of(const std::string& text, std::size_t columns, const fs::path& file, int line) {
  std::istringstream stream(text);
  Row row;
  for (double number = 0.0; stream >> number;) row.push_back(number);
  const bool is_whole = stream.eof() && row.size() == columns;
  const bool is_finite =
      std::all_of(row.begin(), row.end(), [](double n) { return std::isfinite(n); });
  if (!is_whole || !is_finite) {
    refuse(file, line, "found \"" + text + "\", expected " + std::to_string(columns) + " numbers");
  }
  return row;
}

fs::path plain_or_packed(const fs::path& file) {
  if (fs::exists(file)) return file;
  fs::path packed = file;
  packed += ".gz";
  if (fs::exists(packed)) return packed;
  throw std::runtime_error(file.string() + ": not found, nor with .gz behind");
}

/// All lines that are no comment. Rows start with a stamp that never runs backwards if `is_timed`.
std::vector<Row> rows_of(const fs::path& name, std::size_t columns, bool is_timed) {
  const fs::path file = plain_or_packed(name);
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> in(gzopen(file.c_str(), "rb"), gzclose);
  if (!in) throw std::runtime_error(file.string() + ": cannot be opened");
  std::vector<Row> rows;
  std::array<char, 512> buffer{};
  int line = 0;
  while (gzgets(in.get(), buffer.data(), static_cast<int>(buffer.size())) != nullptr) {
    ++line;
    std::string text = buffer.data();
    text.erase(text.find_last_not_of(" \t\r\n") + 1);
    if (text.empty() || text[0] == '#') continue;
    rows.push_back(numbers_of(text, columns, file, line));
    const bool is_back = is_timed && rows.size() > 1 && rows.back()[0] < rows[rows.size() - 2][0];
    if (is_back) refuse(file, line, "its stamp is before that of the line before");
  }
  int error = Z_OK;
  const char* const what = gzerror(in.get(), &error);
  if (error != Z_OK && error != Z_STREAM_END) refuse(file, line, what);
  if (rows.empty()) throw std::runtime_error(file.string() + ": found no rows");
  return rows;
}

RobotLog read_robot(const fs::path& folder, int robot, const std::map<int, int>& subject_of) {
  const std::string stem = "Robot" + std::to_string(robot);
  RobotLog log;
  for (const Row& row : rows_of(folder / (stem + "_Groundtruth.dat"), 4, true)) {
    log.truth.push_back({row[0], {row[1], row[2], row[3]}});
  }
  for (const Row& row : rows_of(folder / (stem + "_Odometry.dat"), 3, true)) {
    log.wheels.push_back({row[0], row[1], row[2]});
  }
  for (const Row& row : rows_of(folder / (stem + "_Measurement.dat"), 4, true)) {
    const auto subject = subject_of.find(static_cast<int>(row[1]));
    log.seen.push_back({row[0], subject == subject_of.end() ? 0 : subject->second, row[2], row[3]});
  }
  return log;
}

/// From the seconds of 1970 to those since all logs have begun.
void count_from_start(RobotLogs& logs) {
  double start = 0.0;
  double end = 1e12;
  for (const RobotLog& robot : logs.robots) {
    start = std::max({start, robot.truth.front().t, robot.wheels.front().t});
    end = std::min({end, robot.truth.back().t, robot.wheels.back().t});
  }
  logs.duration = end - start;
  for (RobotLog& robot : logs.robots) {
    for (Truth& truth : robot.truth) truth.t -= start;
    for (Wheels& wheels : robot.wheels) wheels.t -= start;
    for (Seen& seen : robot.seen) seen.t -= start;
  }
}

}  // namespace

const Pose<Field, Robot>& RobotLog::truth_at(double t) const {
  auto after = std::lower_bound(
      truth.begin(), truth.end(), t, [](const Truth& one, double at) { return one.t < at; });
  if (after == truth.end()) return truth.back().X_FR;
  if (after != truth.begin() && t - std::prev(after)->t < after->t - t) --after;
  return after->X_FR;
}

RobotLogs read_robot_logs(const fs::path& folder) {
  std::map<int, int> subject_of;  // by barcode
  for (const Row& row : rows_of(folder / "Barcodes.dat", 2, false)) {
    subject_of[static_cast<int>(row[1])] = static_cast<int>(row[0]);
  }
  RobotLogs logs;
  for (const Row& row : rows_of(folder / "Landmark_Groundtruth.dat", 5, false)) {
    logs.landmarks[static_cast<int>(row[0])] = {row[1], row[2]};
  }
  for (int robot = 1; robot <= kRobots; ++robot) {
    logs.robots[static_cast<std::size_t>(robot) - 1] = read_robot(folder, robot, subject_of);
  }
  count_from_start(logs);
  if (!(logs.duration > 0.0))
    throw std::runtime_error(folder.string() + ": the robots' logs share no time");
  return logs;
}

}  // namespace teamsight::mrclam
