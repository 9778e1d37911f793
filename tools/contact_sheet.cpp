// tools/contact_sheet.cpp: tiles on a black sheet.
#include "tools/contact_sheet.hpp"

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "tools/picture_mat.hpp"

namespace teamsight::tools {

namespace {

constexpr int kNameHeight = 20;  // px
constexpr int kGap = 4;          // px between tiles

Picture empty_sheet(const SheetLayout& layout) {
  Picture sheet;
  sheet.width_px = layout.columns * (layout.tile_px + kGap);
  sheet.height_px = layout.rows * (layout.tile_px + kNameHeight + kGap);
  sheet.bgr.resize(std::size_t{3} * static_cast<std::size_t>(sheet.width_px) *
                   static_cast<std::size_t>(sheet.height_px));
  return sheet;
}

}  // namespace

ContactSheets::ContactSheets(std::filesystem::path folder, const SheetLayout& layout)
    : folder_(std::move(folder)),
      layout_(layout) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (!std::filesystem::is_directory(folder_)) {
    throw std::runtime_error(folder_.string() + ": cannot be made, expected a folder");
  }
}

void ContactSheets::add(const Picture& picture, const std::string& name) {
  if (on_sheet_ == 0) sheet_ = empty_sheet(layout_);
  const cv::Scalar white(255, 255, 255);
  Picture copy = picture;
  const double scale = std::min(
      1.0, static_cast<double>(layout_.tile_px) / std::max(picture.width_px, picture.height_px));
  cv::Mat tile;
  cv::resize(mat_of(copy), tile, {}, scale, scale, cv::INTER_AREA);
  cv::Mat sheet = mat_of(sheet_);
  const cv::Point corner(on_sheet_ % layout_.columns * (layout_.tile_px + kGap),
                         on_sheet_ / layout_.columns * (layout_.tile_px + kNameHeight + kGap));
  tile.copyTo(sheet(cv::Rect(corner, tile.size())));
  const cv::Point name_at(corner.x + kGap, corner.y + layout_.tile_px + kNameHeight - 2 * kGap);
  cv::putText(sheet, name, name_at, cv::FONT_HERSHEY_PLAIN, 1.0, white, 1, cv::LINE_AA);
  if (++on_sheet_ == layout_.columns * layout_.rows) finish();
}

void ContactSheets::finish() {
  if (on_sheet_ == 0) return;
  ++written_;
  write_picture(folder_ / ("sheet-" + std::to_string(written_) + ".png"), sheet_);
  on_sheet_ = 0;
}

}  // namespace teamsight::tools
