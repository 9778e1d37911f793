// agent/media_plugin.cpp: see media_plugin.hpp.
#include "agent/media_plugin.hpp"

#include <filesystem>
#include <vector>

#include <dlfcn.h>

namespace teamsight::agent {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFileName = "libteamsight-media.so";

std::vector<fs::path> places() {
  std::error_code ignored;
  const fs::path beside = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  return {beside / kFileName, beside / ".." / TEAMSIGHT_PLUGIN_DIR / kFileName};
}

const MediaPlugin* load() {
  std::string reason = "not found beside the program";
  for (const fs::path& path : places()) {
    if (!fs::exists(path)) {
      continue;
    }
    void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* symbol = library == nullptr ? nullptr : ::dlsym(library, kMediaPluginSymbol);
    if (symbol != nullptr) {
      return reinterpret_cast<const MediaPlugin* (*)()>(symbol)();
    }
    const char* error = ::dlerror();  // NOLINT(concurrency-mt-unsafe): glibc keeps one per thread
    reason = error == nullptr ? path.string() : error;
  }
  throw SourceError(std::string(kFileName) + ": cannot be loaded (" + reason +
                    "), expected for picture and video sources");
}

}  // namespace

const MediaPlugin& media_plugin() {
  static const MediaPlugin* const plugin = load();
  return *plugin;
}

}  // namespace teamsight::agent
