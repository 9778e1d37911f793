// monitor/web_files.cpp: see monitor/web_files.hpp.
#include "monitor/web_files.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace teamsight::monitor {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kIndex = "/index.html";
// The page is a few hundred kB; a folder named by mistake is not to be read into memory whole.
constexpr std::uintmax_t kMaxBytes = 32U << 20U;

std::string content_type_of(const fs::path& path) {
  static const std::map<std::string, std::string, std::less<>> types{
      {".css", "text/css; charset=utf-8"},
      {".html", "text/html; charset=utf-8"},
      {".ico", "image/x-icon"},
      {".js", "text/javascript; charset=utf-8"},
      {".json", "application/json"},
      {".map", "application/json"},
      {".png", "image/png"},
      {".svg", "image/svg+xml"},
      {".woff2", "font/woff2"}};
  const auto found = types.find(path.extension().string());
  return found == types.end() ? "application/octet-stream" : found->second;
}

std::string read_whole(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string body{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw std::runtime_error(path.string() + ": cannot be read");
  return body;
}

bool has_page(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / "index.html", ignored);
}

}  // namespace

WebFiles load_web_files(const fs::path& folder) {
  if (!has_page(folder)) {
    throw std::runtime_error("web page: no index.html in " + folder.string() +
                             ", expected the folder of the built page (see --web)");
  }
  WebFiles files;
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_symlink() || !entry.is_regular_file()) continue;
    bytes += entry.file_size();
    if (bytes > kMaxBytes) {
      throw std::runtime_error("web page: " + folder.string() +
                               " holds more than 32 MB, expected the folder of the built page");
    }
    const std::string address = "/" + entry.path().lexically_relative(folder).generic_string();
    files[address] = {content_type_of(entry.path()), read_whole(entry.path())};
  }
  files["/"] = files.find(kIndex)->second;
  return files;
}

fs::path find_web_folder(const fs::path& wanted, const fs::path& program) {
  if (!wanted.empty()) return wanted;
  // Called at start, before any thread that could change the environment.
  // NOLINTNEXTLINE(concurrency-mt-unsafe)
  const char* from_environment = std::getenv("TEAMSIGHT_WEB_DIR");
  if (from_environment != nullptr) return from_environment;
  fs::path beside = program.parent_path().parent_path() / "share/teamsight/web";
  if (has_page(beside)) return beside;
  throw std::runtime_error("web page: not found in " + beside.string() +
                           ", expected there, in TEAMSIGHT_WEB_DIR or in --web DIR");
}

}  // namespace teamsight::monitor
