// tests/fuzz/subjects.hpp: what is done with bytes from outside, and what must then hold.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace teamsight::fuzz {

/// Each of these takes any bytes and returns what is wrong with how they were taken; "" if nothing
/// is. A crash, and what a sanitizer finds, counts as well.

/// An eye gets a frame. The bytes choose, one byte each: the camera's format, its size, what is
/// before it, the format, width, height and length that the frame claims; then places of the frame
/// are painted over, five bytes each.
[[nodiscard]] std::string fault_of_frame(std::span<const std::uint8_t> bytes);

/// A camera file: what loads must come back from being written, and see a frame if it is small.
[[nodiscard]] std::string fault_of_camera_file(std::span<const std::uint8_t> bytes);

/// A stream of frames, of which the first byte says in what pieces the others come.
[[nodiscard]] std::string fault_of_frame_stream(std::span<const std::uint8_t> bytes);

}  // namespace teamsight::fuzz
