// monitor/web_files.hpp: the page's files, read once and served from memory.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace teamsight::monitor {

/// A file as a browser gets it.
struct WebFile {
  std::string content_type;
  std::string body;
  bool is_private{false};  ///< needs the token where watching does

  friend bool operator==(const WebFile&, const WebFile&) = default;
};

/// By the path in the address, e.g. "/assets/index.js"; "/" is index.html.
///
/// Only what stands here is ever served, so that no address leads anywhere else on the disk.
using WebFiles = std::map<std::string, WebFile, std::less<>>;

/// Reads a folder with the built page.
///
/// @throws std::runtime_error if it holds no index.html or cannot be read; links out of the folder
///         are not followed
[[nodiscard]] WebFiles load_web_files(const std::filesystem::path& folder);

/// Where the built page is: `wanted` if given, else TEAMSIGHT_WEB_DIR, else share/teamsight/web
/// beside the program's bin/.
///
/// @throws std::runtime_error if there is none; the line says where it was looked for
[[nodiscard]] std::filesystem::path find_web_folder(const std::filesystem::path& wanted,
                                                    const std::filesystem::path& program);

}  // namespace teamsight::monitor
