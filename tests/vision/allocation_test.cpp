// tests/vision/allocation_test.cpp: a frame is looked at without asking for memory.
#include <atomic>
#include <cstdlib>
#include <new>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/synthetic_points.hpp"
#include "vision/perception.hpp"

namespace {
std::atomic<std::size_t> allocations{0};
}  // namespace

// Every other form of new ends in one of these two.
void* operator new(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto step = static_cast<std::size_t>(alignment);
  void* memory = std::aligned_alloc(step, (size + step - 1) / step * step);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace teamsight::vision {
namespace {

constexpr std::uint32_t kSide = 320;

CameraParameters camera() {
  CameraParameters camera;
  camera.width_px = kSide;
  camera.height_px = kSide;
  camera.format = PixelFormat::kYuyv;
  RadialTable table;
  table.centre_u_px = 159.5;
  table.centre_v_px = 159.5;
  table.mirror_height = 0.75;
  for (int radius = 15; radius <= 150; radius += 5) {
    table.rows.push_back({1.0 * radius, 1.57 * std::tan(0.0095 * radius), 0.1});
  }
  camera.mirror = table;
  camera.colours.samples = {{ColourClass::kGreen, 101, 94, 24}, {ColourClass::kBall, 61, 200, 30}};
  camera.sensors = {
      {"green", SensorKind::kColour, {ColourClass::kGreen}, {{{10, 10}, {60, 10}, {60, 60}}}, 0.2}};
  return camera;
}

// A carpet with rings of paint, a ball and a black pillar, moved a little from frame to frame.
std::vector<std::uint8_t> picture(int step) {
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t v = 0; v < kSide; ++v) {
    for (std::uint32_t u = 0; u < kSide; ++u) {
      const double du = u - 159.5;
      const double dv = v - 159.5;
      const double radius = std::hypot(du, dv);
      const bool ball = std::hypot(du - 60.0 - step, dv + 40.0) < 8.0;
      const bool pillar = std::hypot(du + 70.0, dv - 30.0 - step) < 12.0;
      const bool paint = std::abs(radius - 100.0 - step) < 3.0;
      bytes.push_back(static_cast<std::uint8_t>(ball ? 139 : pillar ? 20 : paint ? 220 : 90));
      const bool even = u % 2 == 0;
      const int chroma = ball ? (even ? 61 : 200) : pillar || paint ? 128 : (even ? 101 : 94);
      bytes.push_back(static_cast<std::uint8_t>(chroma));
    }
  }
  return bytes;
}

TEST(Allocation, AFrameAsksForNoMemoryOnceTheBuffersHaveGrown) {
  Perception perception(camera(), test_field());
  std::vector<std::vector<std::uint8_t>> frames;
  for (int step = 0; step < 4; ++step) frames.push_back(picture(step));
  for (const auto& frame : frames) {
    ASSERT_TRUE(perception.see({frame, kSide, kSide, PixelFormat::kYuyv}, {}));
  }

  const std::size_t before = allocations;
  std::size_t seen = 0;
  for (const auto& frame : frames) {
    seen += (*perception.see({frame, kSide, kSide, PixelFormat::kYuyv}, {}))->line_points.size();
  }
  const std::size_t after = allocations;

  EXPECT_GT(seen, 0U);
  EXPECT_EQ(after - before, 0U);
}

}  // namespace
}  // namespace teamsight::vision
