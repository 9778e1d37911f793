// agent/open_source.hpp: from the words on the command line to a source of frames.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "agent/frame_source.hpp"
#include "agent/still_frames.hpp"

namespace teamsight::agent {

enum class SourceKind : std::uint8_t { kRaw, kPictures, kVideoFile, kGstreamer, kDevice, kStream };

/// Which frames to take.
struct SourceChoice {
  SourceKind kind{SourceKind::kStream};
  std::string what;                ///< path, pipeline or device
  std::vector<std::string> files;  ///< raw dumps and pictures: at least one; else empty
};

/// Reads a SPEC: `raw:FILE,...`, `image:FILE,...`, `video:FILE`, `gst:PIPELINE`, `v4l2:DEVICE`,
/// `stream:PATH`, or only a path whose ending (or /dev/) says which of these.
///
/// @throws SourceError for anything else
[[nodiscard]] SourceChoice parse_source(const std::string& spec);

/// Whether it may come and go: if it is not there now, trying later makes sense.
[[nodiscard]] bool may_come_later(SourceKind kind);

/// Opens it now.
///
/// @param layout  the camera file's size and pixel format
/// @param loop    files begin again after the last one
/// @throws SourceError if it is not there, cannot be read, or a file's size is not the camera's
[[nodiscard]] std::unique_ptr<FrameSource> open_source(const SourceChoice& choice,
                                                       const PictureLayout& layout,
                                                       bool loop);

}  // namespace teamsight::agent
