// settings/profile_csv.cpp: reading and writing of a mirror's meridian.
#include "settings/profile_csv.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include "settings/text_format.hpp"

namespace teamsight::settings {

namespace {

constexpr std::string_view kColumns = "x_m,y_m";

class Complaint {
 public:
  explicit Complaint(std::filesystem::path path) : path_(std::move(path)) {}

  [[nodiscard]] SettingsError at(int line,
                                 std::string_view key,
                                 const std::string& found,
                                 const std::string& expected) const {
    return SettingsError(path_.string() + ":" + std::to_string(line) + ":1: key '" +
                         std::string(key) + "': found " + found + ", expected " + expected);
  }

 private:
  std::filesystem::path path_;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// Cuts the first column off `rest`.
std::string_view next_column(std::string_view& rest) {
  const std::size_t comma = rest.find(',');
  const std::string_view column = trimmed(rest.substr(0, comma));
  rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
  return column;
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

double column_value(std::string_view& rest,
                    std::string_view key,
                    int line,
                    const Complaint& complaint) {
  const std::string_view text = next_column(rest);
  const std::optional<double> value = number(text);
  if (!value) throw complaint.at(line, key, "'" + std::string(text) + "'", "a finite number");
  return *value;
}

// The row on one line, which must lie further out than `before`.
vision::ProfilePoint row_of(std::string_view rest,
                            int line,
                            const vision::ProfilePoint* before,
                            const Complaint& complaint) {
  const double x = column_value(rest, "x_m", line, complaint);
  const double y = column_value(rest, "y_m", line, complaint);
  if (before != nullptr && x <= before->x) {
    throw complaint.at(line, "x_m", text_of(x), "more than the row before, " + text_of(before->x));
  }
  if (x < 0.0) throw complaint.at(line, "x_m", text_of(x), "at least 0");
  return {x, y};
}

std::vector<vision::ProfilePoint> rows_of(std::istream& file, const Complaint& complaint) {
  std::vector<vision::ProfilePoint> rows;
  std::string text;
  bool has_head = false;
  for (int line = 1; std::getline(file, text); ++line) {
    const std::string_view content = trimmed(text);
    if (content.empty() || content.front() == '#') continue;
    if (has_head) {
      rows.push_back(row_of(content, line, rows.empty() ? nullptr : &rows.back(), complaint));
    } else if (!content.starts_with(kColumns)) {
      throw complaint.at(line, kColumns, "'" + std::string(content) + "'", "the head x_m,y_m");
    }
    has_head = true;
  }
  return rows;
}

}  // namespace

std::vector<vision::ProfilePoint> read_profile(const std::filesystem::path& path) {
  const Complaint complaint(path);
  std::error_code ignored;
  std::ifstream file(path);
  if (!file || !std::filesystem::is_regular_file(path, ignored)) {
    throw complaint.at(1, kColumns, "no readable file", "a CSV file");
  }
  std::vector<vision::ProfilePoint> profile = rows_of(file, complaint);
  if (profile.size() < 3) {
    throw complaint.at(1, kColumns, std::to_string(profile.size()) + " rows", "at least 3 rows");
  }
  return profile;
}

std::string profile_csv(const std::vector<vision::ProfilePoint>& profile) {
  std::string text = std::string(kColumns) + "\n";
  for (const vision::ProfilePoint& point : profile) {
    text += text_of(point.x) + "," + text_of(point.y) + "\n";
  }
  return text;
}

}  // namespace teamsight::settings
