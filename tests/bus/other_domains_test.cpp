// tests/bus/other_domains_test.cpp: announcements as bytes, laid out by hand after RTPS 2.3.
#include "bus/other_domains.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/property.hpp"

namespace teamsight::bus {
namespace {

using namespace std::string_literals;

using Packet = std::vector<std::uint8_t>;

std::optional<std::string> tag_in(const std::string& text) {
  return announced_tag(Packet(text.begin(), text.end()));
}

const std::string kHeader = "RTPS\x02\x03\x01\x10"s + std::string(12, 'g');
const std::string kTimestamp = "\x09\x01\x08\x00"s + std::string(8, 't');

// A DATA submessage, little end first, with what its parameter list holds.
std::string data(const std::string& parameters, char writer = '\xc2') {
  const std::string body = "\x00\x00\x10\x00\x00\x01\x00\xc7\x00\x01\x00"s + writer +
                           "\x00\x00\x00\x00\x01\x00\x00\x00"s + "\x00\x03\x00\x00"s + parameters;
  return "\x15\x05"s + static_cast<char>(body.size()) + '\0' + body;
}

const std::string kLease = "\x02\x00\x08\x00\x0a\x00\x00\x00\x00\x00\x00\x00"s;
const std::string kBlue =
    "\x14\x40\x0c\x00\x05\x00\x00\x00"
    "blue\x00\x00\x00\x00"s;
const std::string kEnd = "\x01\x00\x00\x00"s;

TEST(AnnouncedTag, IsReadFromAParticipantsData) {
  EXPECT_EQ(tag_in(kHeader + kTimestamp + data(kLease + kBlue + kEnd)), "blue");
  EXPECT_EQ(tag_in(kHeader + data(kLease + kEnd)), "");
}

TEST(AnnouncedTag, IsNothingInWhatIsNoWholeAnnouncement) {
  const std::string whole = kHeader + kTimestamp + data(kLease + kBlue + kEnd);

  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_EQ(tag_in(whole.substr(0, size)), std::nullopt) << size;
  }
  EXPECT_EQ(tag_in(kHeader + data(kLease + kBlue)), std::nullopt);         // no end
  EXPECT_EQ(tag_in(kHeader + data(kLease + kEnd, '\x03')), std::nullopt);  // a reader's
  EXPECT_EQ(tag_in("RTPX" + whole.substr(4)), std::nullopt);
}

TEST(AnnouncedTag, IsNothingThatCouldNotBeShown) {
  const auto named = [](const std::string& tag) {
    const auto size = static_cast<char>(tag.size() + 1);
    const auto length = static_cast<char>(tag.size() + 5);
    const std::string parameter =
        "\x14\x40"s + length + "\x00"s + size + "\x00\x00\x00"s + tag + "\x00"s;
    return kHeader + data(parameter + kEnd);
  };

  EXPECT_EQ(tag_in(named(std::string(64, 'b'))), std::string(64, 'b'));
  EXPECT_EQ(tag_in(named(std::string(65, 'b'))), std::nullopt);
  EXPECT_EQ(tag_in(named("blue\nred")), std::nullopt);
}

TEST(AnnouncedTag, SurvivesSpoiltPackets) {
  const std::string whole = kHeader + kTimestamp + data(kLease + kBlue + kEnd);
  testing_support::holds_for_all(71, [&] {
    Packet packet(whole.begin(), whole.end());
    const auto changes = *rc::gen::inRange(1, 12);
    for (int i = 0; i < changes; ++i) {
      packet[*rc::gen::inRange<std::size_t>(0, packet.size())] =
          *rc::gen::arbitrary<std::uint8_t>();
    }
    const auto tag = announced_tag(packet);
    RC_ASSERT(!tag || tag->size() < packet.size());
  });
}

TEST(DomainsText, NamesFourAndCountsTheOthers) {
  EXPECT_EQ(to_text(std::set<AnnouncedDomain>{}), "");
  EXPECT_EQ(to_text({{20, "blue"}, {22, ""}}), "domain 20 (blue), domain 22");
  EXPECT_EQ(to_text({{1, ""}, {2, ""}, {3, ""}, {4, ""}, {5, ""}, {6, ""}}),
            "domain 1, domain 2, domain 3, domain 4 and 2 more");
}

}  // namespace
}  // namespace teamsight::bus
