// tests/settings/spoilt_text_test.cpp: whatever stands in a file, it loads or is refused in one
// line.
#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "settings/load.hpp"
#include "tests/settings/camera_text.hpp"
#include "tests/settings/temporary_files.hpp"
#include "tests/support/property.hpp"

namespace teamsight::settings {
namespace {

using testing_support::holds_for_all;

// Cuts a part out of the text and puts some signs in its place.
std::string spoilt_at_random(std::string text) {
  const auto size = static_cast<int>(text.size());
  const int at = *rc::gen::inRange(0, size);
  const int gone = *rc::gen::inRange(0, 30);
  using namespace std::string_literals;
  const auto signs = "{}<>[]:;,#\"'\\\n\t -+.0e9an\x00\xff"s;
  const auto put = *rc::gen::container<std::string>(rc::gen::elementOf(signs));
  return text.replace(
      static_cast<std::size_t>(at), static_cast<std::size_t>(std::min(gone, size - at)), put);
}

TEST(SpoiltText, LoadsOrIsRefusedInOneLine) {
  const TemporaryFolder folder;
  int refused = 0;

  holds_for_all(
      31,
      [&] {
        const auto path = folder.write("eye", spoilt_at_random(kRadialCamera));
        const std::string complaint = complaint_of([&] { std::ignore = load_camera(path); });
        if (complaint.empty()) return;
        ++refused;
        RC_ASSERT(complaint.starts_with(path.string() + ":"));
        RC_ASSERT(complaint.find('\n') == std::string::npos);
        RC_ASSERT(complaint.find("found ") != std::string::npos);
        RC_ASSERT(complaint.find(", expected ") != std::string::npos);
      },
      500);

  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace teamsight::settings
