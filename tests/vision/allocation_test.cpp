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

struct Yuv {
  std::uint8_t y, u, v;
};

// A carpet with a ring of paint, a ball, one of white and black, and a black pillar, moved a little
// from frame to frame.
Yuv colour_at(double du, double dv, int step) {
  if (std::hypot(du + 20.0 + step, dv + 70.0) < 9.0) {
    return dv + 70.0 < 0.3 * (du + 20.0) ? Yuv{220, 128, 128} : Yuv{20, 128, 128};
  }
  if (std::hypot(du - 60.0 - step, dv + 40.0) < 8.0) return {139, 61, 200};
  if (std::hypot(du + 70.0, dv - 30.0 - step) < 12.0) return {20, 128, 128};
  if (std::abs(std::hypot(du, dv) - 100.0 - step) < 3.0) return {220, 128, 128};
  return {90, 101, 94};
}

std::vector<std::uint8_t> picture(int step) {
  std::vector<std::uint8_t> bytes(std::size_t{kSide} * kSide * 2);
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const std::size_t u = i / 2 % kSide;
    const std::size_t v = i / 2 / kSide;
    const Yuv colour =
        colour_at(static_cast<double>(u) - 159.5, static_cast<double>(v) - 159.5, step);
    bytes[i] = colour.y;
    bytes[i + 1] = u % 2 == 0 ? colour.u : colour.v;
  }
  return bytes;
}

// @param expected_balls  that are seen in each of the frames
void expect_no_allocation(const CameraParameters& eye, std::size_t expected_balls) {
  Perception perception(eye, test_field());
  std::vector<std::vector<std::uint8_t>> frames;
  frames.reserve(4);
  for (int step = 0; step < 4; ++step) frames.push_back(picture(step));
  for (const auto& frame : frames) {
    ASSERT_TRUE(perception.see({frame, kSide, kSide, PixelFormat::kYuyv}, {}));
  }

  const std::size_t before = allocations;
  std::size_t seen = 0;
  std::size_t balls = 0;
  for (const auto& frame : frames) {
    const auto observation = perception.see({frame, kSide, kSide, PixelFormat::kYuyv}, {});
    seen += (*observation)->line_points.size();
    balls += (*observation)->balls.size();
  }
  const std::size_t after = allocations;

  EXPECT_GT(seen, 0U);
  EXPECT_EQ(balls, expected_balls * frames.size());
  EXPECT_EQ(after - before, 0U);
}

TEST(Allocation, AFrameAsksForNoMemoryOnceTheBuffersHaveGrown) {
  expect_no_allocation(camera(), 1);
}

TEST(Allocation, NorDoesOneThatIsLookedAtForPatternedBalls) {
  CameraParameters eye = camera();
  eye.colours.pattern = {ColourClass::kWhite, ColourClass::kBlack};

  expect_no_allocation(eye, 2);
}

}  // namespace
}  // namespace teamsight::vision
