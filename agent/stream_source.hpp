// agent/stream_source.hpp: frames from a FIFO or a file that another process writes.
#pragma once

#include <memory>
#include <string>

#include "agent/frame_source.hpp"

namespace teamsight::agent {

/// Opens a FIFO (or a recorded stream in a file) of frames as agent/frame_stream.hpp lays them out.
///
/// A FIFO nobody writes to yet gives kNothingYet; when its writer ends, kGone. When several whole
/// frames wait, they come one after the other, oldest first.
///
/// @throws SourceError if the path cannot be opened
[[nodiscard]] std::unique_ptr<FrameSource> open_stream(const std::string& path);

}  // namespace teamsight::agent
