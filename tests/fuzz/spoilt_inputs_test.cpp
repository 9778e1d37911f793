// tests/fuzz/spoilt_inputs_test.cpp: made-up and spoilt bytes, the same in every run. What
// libFuzzer does with the same subjects is not: it follows the code's branches.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "agent/frame_stream.hpp"
#include "tests/fuzz/subjects.hpp"
#include "tests/support/process.hpp"
#include "tests/support/property.hpp"
#include "tests/support/spoilt.hpp"

namespace teamsight::fuzz {
namespace {

using testing_support::holds_for_all;
using testing_support::spoilt_at_random;

std::vector<std::uint8_t> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

std::vector<std::string> seeds_in(const std::string& folder) {
  std::vector<std::string> seeds;
  for (const auto& entry : std::filesystem::directory_iterator(test::source_path(folder))) {
    std::ifstream file(entry.path(), std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  std::ranges::sort(seeds);
  return seeds;
}

std::string stream_of_two_frames() {
  std::string stream(1, '\x10');
  for (std::uint64_t number = 1; number <= 2; ++number) {
    const agent::StreamHeader header{
        4, 2, vision::PixelFormat::kYuyv, HostTime{Duration{1000 * number}}, number};
    const auto head = agent::encode_stream_header(header);
    stream.append(head.begin(), head.end());
    stream.append(agent::picture_bytes(header), static_cast<char>(number));
  }
  return stream;
}

struct Subject {
  const char* name;
  std::string (*fault_of)(std::span<const std::uint8_t>);
};

class KeptInputs : public testing::TestWithParam<Subject> {};

TEST_P(KeptInputs, AreTakenWell) {
  const auto inputs = seeds_in(std::string("tests/fuzz/corpus/") + GetParam().name);

  ASSERT_FALSE(inputs.empty());
  for (const std::string& input : inputs) {
    EXPECT_EQ(GetParam().fault_of(bytes_of(input)), "") << input.size() << " bytes";
  }
}

INSTANTIATE_TEST_SUITE_P(Each,
                         KeptInputs,
                         testing::Values(Subject{"frame", fault_of_frame},
                                         Subject{"camera_file", fault_of_camera_file},
                                         Subject{"frame_stream", fault_of_frame_stream}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SpoiltFrame, IsSeenOrRefusedWithSoundNumbers) {
  holds_for_all(
      51,
      [] {
        // The eye and what it looks at, a frame that claims whatever it likes, and paint over it.
        auto bytes =
            *rc::gen::container<std::vector<std::uint8_t>>(7, rc::gen::arbitrary<std::uint8_t>());
        const bool is_honest = *rc::gen::arbitrary<bool>();
        if (is_honest) std::fill(bytes.begin() + 3, bytes.end(), std::uint8_t{0});
        const auto patches =
            *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
        bytes.insert(bytes.end(), patches.begin(), patches.end());
        RC_ASSERT(fault_of_frame(bytes) == "");
      },
      400);
}

TEST(SpoiltCameraFile, IsRefusedOrMakesAnEye) {
  const auto seeds = seeds_in("tests/fuzz/corpus/camera_file");
  ASSERT_FALSE(seeds.empty());

  holds_for_all(
      52,
      [&] {
        const std::string text = spoilt_at_random(*rc::gen::elementOf(seeds));
        RC_ASSERT(fault_of_camera_file(bytes_of(text)) == "");
      },
      400);
}

TEST(SpoiltFrameStream, GivesTheSameWholeFramesHoweverItIsCut) {
  holds_for_all(
      53,
      [] {
        const std::string stream = spoilt_at_random(stream_of_two_frames());
        RC_ASSERT(fault_of_frame_stream(bytes_of(stream)) == "");
      },
      2000);
}

}  // namespace
}  // namespace teamsight::fuzz
