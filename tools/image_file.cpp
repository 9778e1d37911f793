// tools/image_file.cpp: reading frames; OpenCV reads everything but raw dumps.
#include "tools/image_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/imgcodecs.hpp>

namespace teamsight::tools {

namespace {

std::string size_text(std::uint32_t width, std::uint32_t height) {
  return std::to_string(width) + "x" + std::to_string(height) + " pixels";
}

ImageFile from_mat(const cv::Mat& picture, vision::PixelFormat format) {
  ImageFile file;
  file.width_px = static_cast<std::uint32_t>(picture.cols);
  file.height_px = static_cast<std::uint32_t>(picture.rows);
  file.format = format;
  const std::size_t row = vision::row_bytes(format, file.width_px);
  for (int v = 0; v < picture.rows; ++v) {
    const std::uint8_t* begin = picture.ptr<std::uint8_t>(v);
    file.bytes.insert(file.bytes.end(), begin, begin + row);
  }
  return file;
}

std::vector<char> bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Where the first scan of a JPEG begins, after its headers, which may hold a whole thumbnail.
std::size_t scan_of_jpeg(std::string_view bytes) {
  constexpr char kScan = '\xDA';
  const auto byte = [&](std::size_t at) {
    return std::size_t{static_cast<std::uint8_t>(bytes[at])};
  };
  std::size_t at = 2;
  while (at + 3 < bytes.size() && bytes[at + 1] != kScan) {
    at += 2 + 256 * byte(at + 2) + byte(at + 3);
  }
  return std::min(at, bytes.size());
}

// Whether the bytes begin as PNG or JPEG and have not the end of one: OpenCV fills up what is
// missing of a JPEG, and its libraries complain for themselves. What writers append does no harm.
bool is_cut_short(std::string_view bytes) {
  constexpr std::string_view kPngBegins = "\x89PNG";
  constexpr std::string_view kPngEnds = "IEND\xAE\x42\x60\x82";
  constexpr std::string_view kJpegBegins = "\xFF\xD8\xFF";
  constexpr std::string_view kJpegEnds = "\xFF\xD9";
  if (bytes.starts_with(kPngBegins)) return bytes.find(kPngEnds) == std::string_view::npos;
  return bytes.starts_with(kJpegBegins) &&
         bytes.find(kJpegEnds, scan_of_jpeg(bytes)) == std::string_view::npos;
}

cv::Mat read_picture(const std::filesystem::path& path, int mode) {
  cv::Mat picture;
  if (std::filesystem::is_regular_file(path)) {
    const std::vector<char> bytes = bytes_of(path);
    if (is_cut_short({bytes.data(), bytes.size()})) {
      throw std::runtime_error(path.string() + ": found " + std::to_string(bytes.size()) +
                               " bytes of a picture that is cut short; copy it again");
    }
    if (!bytes.empty()) picture = cv::imdecode(bytes, mode);
  }
  if (picture.empty()) {
    throw std::runtime_error(path.string() +
                             ": not a readable picture; expected PNG, JPEG or the like, or a .raw "
                             "dump of the camera's bytes");
  }
  return picture;
}

ImageFile read_dump(const std::filesystem::path& path, const vision::CameraParameters& camera) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error(path.string() + ": cannot be read");
  const std::string content{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t expected =
      vision::frame_bytes(camera.format, camera.width_px, camera.height_px);
  if (content.size() != expected) {
    throw std::runtime_error(path.string() + ": found " + std::to_string(content.size()) +
                             " bytes, expected " + std::to_string(expected) + " (" +
                             size_text(camera.width_px, camera.height_px) +
                             " in the camera file's format)");
  }
  return {{content.begin(), content.end()}, camera.width_px, camera.height_px, camera.format};
}

}  // namespace

bool is_raw_dump(const std::filesystem::path& path) {
  return path.extension() == ".raw";
}

std::vector<std::filesystem::path> images_in(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  constexpr std::array<std::string_view, 5> kKinds{".png", ".jpg", ".jpeg", ".bmp", ".raw"};
  std::vector<std::filesystem::path> images;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    const std::string kind = entry.path().extension().string();
    if (std::ranges::find(kKinds, kind) != kKinds.end()) images.push_back(entry.path());
  }
  if (images.empty()) {
    throw std::runtime_error(path.string() +
                             ": found a folder without images, expected .png, .jpg, .jpeg, .bmp or "
                             ".raw files in it");
  }
  std::ranges::sort(images);
  return images;
}

ImageFile read_image(const std::filesystem::path& path, const vision::CameraParameters& camera) {
  if (is_raw_dump(path)) return read_dump(path, camera);
  ImageFile file = from_mat(read_picture(path, cv::IMREAD_COLOR), vision::PixelFormat::kBgr);
  if (file.width_px != camera.width_px || file.height_px != camera.height_px) {
    throw std::runtime_error(path.string() + ": found " + size_text(file.width_px, file.height_px) +
                             ", expected " + size_text(camera.width_px, camera.height_px) +
                             " as the camera file says");
  }
  return file;
}

ImageFile read_grey_picture(const std::filesystem::path& path) {
  return from_mat(read_picture(path, cv::IMREAD_GRAYSCALE), vision::PixelFormat::kGrey);
}

}  // namespace teamsight::tools
