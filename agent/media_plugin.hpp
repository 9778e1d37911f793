// agent/media_plugin.hpp: the edge to libteamsight-media.so, which decodes pictures and videos.
//
// OpenCV's image and video modules bring some 240 shared libraries; only a process that reads such
// a source loads them.
#pragma once

#include <memory>
#include <string>

#include "agent/frame_source.hpp"

namespace teamsight::agent {

/// What the plugin can open.
enum class MediaKind : std::uint8_t {
  kVideoFile,
  kGstreamer,  ///< `what` is a pipeline that ends in an appsink
  kDevice,     ///< `what` is a V4L2 device file
};

/// A video to open.
struct MediaRequest {
  MediaKind kind{MediaKind::kVideoFile};
  std::string what;
  bool loop{false};           ///< video files only
  std::uint32_t width_px{0};  ///< of the frames wanted from a device
  std::uint32_t height_px{0};
  vision::PixelFormat format{vision::PixelFormat::kBgr};  ///< of a device; kBgr: converted
};

/// The plugin's two functions. Both throw SourceError.
class MediaPlugin {
 public:
  MediaPlugin() = default;
  MediaPlugin(const MediaPlugin&) = delete;
  MediaPlugin& operator=(const MediaPlugin&) = delete;
  virtual ~MediaPlugin() = default;

  /// Decodes a PNG, JPEG or BMP file to BGR.
  [[nodiscard]] virtual Frame read_picture(const std::string& path) const = 0;

  [[nodiscard]] virtual std::unique_ptr<FrameSource> open(const MediaRequest& request) const = 0;
};

/// Loads the plugin once, from beside the program or from the library directory it is installed to.
///
/// @throws SourceError if it is not there
[[nodiscard]] const MediaPlugin& media_plugin();

/// The symbol in the plugin: a function without arguments that returns a `const MediaPlugin*`.
inline constexpr const char* kMediaPluginSymbol = "teamsight_media_plugin";

}  // namespace teamsight::agent
