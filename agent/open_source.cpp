// agent/open_source.cpp: see open_source.hpp.
#include "agent/open_source.hpp"

#include <array>
#include <optional>
#include <sstream>
#include <utility>

#include "agent/media_plugin.hpp"
#include "agent/stream_source.hpp"

namespace teamsight::agent {
namespace {

using Names = std::pair<const char*, SourceKind>;

constexpr std::array<Names, 6> kPrefixes{{{"raw:", SourceKind::kRaw},
                                          {"image:", SourceKind::kPictures},
                                          {"video:", SourceKind::kVideoFile},
                                          {"gst:", SourceKind::kGstreamer},
                                          {"v4l2:", SourceKind::kDevice},
                                          {"stream:", SourceKind::kStream}}};

constexpr std::array<Names, 12> kEndings{{{".raw", SourceKind::kRaw},
                                          {".yuyv", SourceKind::kRaw},
                                          {".uyvy", SourceKind::kRaw},
                                          {".png", SourceKind::kPictures},
                                          {".jpg", SourceKind::kPictures},
                                          {".jpeg", SourceKind::kPictures},
                                          {".bmp", SourceKind::kPictures},
                                          {".avi", SourceKind::kVideoFile},
                                          {".mp4", SourceKind::kVideoFile},
                                          {".mkv", SourceKind::kVideoFile},
                                          {".webm", SourceKind::kVideoFile},
                                          {".stream", SourceKind::kStream}}};

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');) {
    if (!part.empty()) {
      parts.push_back(part);
    }
  }
  return parts;
}

SourceChoice chosen(SourceKind kind, const std::string& what) {
  SourceChoice choice{kind, what, {}};
  if (kind == SourceKind::kRaw || kind == SourceKind::kPictures) {
    choice.files = split(what);
  }
  return choice;
}

std::optional<SourceKind> kind_by_ending(const std::string& spec) {
  if (spec.starts_with("/dev/")) {
    return SourceKind::kDevice;
  }
  for (const auto& [ending, kind] : kEndings) {
    if (spec.ends_with(ending)) {
      return kind;
    }
  }
  return std::nullopt;
}

void check_size(const Frame& frame, const PictureLayout& layout, const std::string& path) {
  if (frame.width_px != layout.width_px || frame.height_px != layout.height_px) {
    throw SourceError(path + ": found a picture of " + std::to_string(frame.width_px) + "x" +
                      std::to_string(frame.height_px) + ", expected " +
                      std::to_string(layout.width_px) + "x" + std::to_string(layout.height_px) +
                      " as in the camera file");
  }
}

std::unique_ptr<FrameSource> open_files(const SourceChoice& choice,
                                        const PictureLayout& layout,
                                        bool loop) {
  std::vector<Frame> frames;
  for (const std::string& path : choice.files) {
    frames.push_back(choice.kind == SourceKind::kRaw ? read_raw_dump(path, layout)
                                                     : media_plugin().read_picture(path));
    check_size(frames.back(), layout, path);
  }
  return make_still_frames(std::move(frames), loop);
}

// A video's size is only in its frames: look at the first, then begin again.
void check_video(const MediaRequest& request, const PictureLayout& layout) {
  Frame first;
  if (media_plugin().open(request)->next(first, HostTime::max()) != FrameResult::kFrame) {
    throw SourceError(request.what + ": found no frame, expected a video");
  }
  check_size(first, layout, request.what);
}

std::unique_ptr<FrameSource> open_media(MediaKind kind,
                                        const SourceChoice& choice,
                                        const PictureLayout& layout,
                                        bool loop) {
  const MediaRequest request{
      kind, choice.what, loop, layout.width_px, layout.height_px, layout.format};
  if (kind == MediaKind::kVideoFile) {
    check_video(request, layout);
  }
  return media_plugin().open(request);
}

}  // namespace

SourceChoice parse_source(const std::string& spec) {
  std::optional<SourceChoice> choice;
  for (const auto& [prefix, kind] : kPrefixes) {
    if (spec.starts_with(prefix)) {
      choice = chosen(kind, spec.substr(std::string(prefix).size()));
    }
  }
  if (!choice.has_value()) {
    if (const auto kind = kind_by_ending(spec)) {
      choice = chosen(*kind, spec);
    }
  }
  if (!choice.has_value() || choice->what.empty()) {
    throw SourceError("--source: found \"" + spec +
                      "\", expected raw:FILE, image:FILE, video:FILE, gst:PIPELINE, v4l2:DEVICE, "
                      "stream:PATH or a path with a known ending");
  }
  return *choice;
}

bool may_come_later(SourceKind kind) {
  return kind == SourceKind::kDevice || kind == SourceKind::kGstreamer ||
         kind == SourceKind::kStream;
}

std::unique_ptr<FrameSource> open_source(const SourceChoice& choice,
                                         const PictureLayout& layout,
                                         bool loop) {
  switch (choice.kind) {
    case SourceKind::kRaw:
    case SourceKind::kPictures:
      return open_files(choice, layout, loop);
    case SourceKind::kVideoFile:
      return open_media(MediaKind::kVideoFile, choice, layout, loop);
    case SourceKind::kGstreamer:
      return open_media(MediaKind::kGstreamer, choice, layout, loop);
    case SourceKind::kDevice:
      return open_media(MediaKind::kDevice, choice, layout, loop);
    case SourceKind::kStream:
      return open_stream(choice.what);
  }
  throw SourceError("unknown kind of source");
}

}  // namespace teamsight::agent
