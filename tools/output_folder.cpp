// tools/output_folder.cpp: a staging folder and renames.
#include "tools/output_folder.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace teamsight::tools {
namespace {

namespace fs = std::filesystem;

std::runtime_error complaint(const fs::path& path, const std::string& what) {
  return std::runtime_error(path.string() + ": " + what);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error && !fs::is_directory(folder)) {
    throw complaint(folder, "found " + error.message() + ", expected a folder to write to");
  }
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder)
    : folder_(fs::absolute(folder).lexically_normal()) {
  if (!folder_.has_filename()) {
    folder_ = folder_.parent_path();  // a trailing slash
  }
  if (fs::exists(folder_) && !fs::is_directory(folder_)) {
    throw complaint(folder_, "found a file, expected a folder");
  }
  make_folder(folder_.parent_path());
  std::string pattern = folder_.string() + ".partial-XXXXXX";
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw complaint(folder_.parent_path(), "found no permission, expected a folder to write to");
  }
  staging_ = pattern;
  fs::permissions(staging_, fs::perms(0755));
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
}

void OutputFolder::write(const fs::path& name, const std::string& text) {
  const fs::path path = staging_ / name;
  make_folder(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    throw complaint(folder_ / name, "cannot be written whole");
  }
  names_.push_back(name);
}

void OutputFolder::publish() {
  make_folder(folder_);
  for (const fs::path& name : names_) {
    make_folder((folder_ / name).parent_path());
    std::error_code error;
    fs::rename(staging_ / name, folder_ / name, error);
    if (error) {
      throw complaint(folder_ / name, "cannot be put in its place: " + error.message());
    }
  }
}

}  // namespace teamsight::tools
