// bus/other_domains.cpp: see other_domains.hpp. The layout is that of RTPS 2.3, chapter 9.
#include "bus/other_domains.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <vector>

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace teamsight::bus {
namespace {

constexpr std::uint32_t kDomains = 231;  // beyond, ports would exceed 16 bits
constexpr std::uint32_t kFirstPort = 7400;
constexpr std::uint32_t kPortsPerDomain = 250;
constexpr const char* kGroup = "239.255.0.1";
// Twice the slowest profile's SPDPInterval, and one second for its jitter.
constexpr Duration kRemembered = std::chrono::seconds(5);
// Of a flood nothing more is learnt.
constexpr int kMostPacketsAtOnce = 16;
constexpr std::size_t kMostNamed = 4;
constexpr std::size_t kLongestTag = 64;

constexpr std::size_t kHeader = 20;
constexpr std::uint8_t kData = 0x15;
constexpr std::array<std::uint8_t, 4> kParticipantWriter{0x00, 0x01, 0x00, 0xc2};
constexpr std::uint16_t kSentinel = 0x0001;
constexpr std::uint16_t kDomainTag = 0x4014;

using Bytes = std::span<const std::uint8_t>;

/// Reads numbers at places that may lie beyond the end; then they are 0, and `is_whole` no more.
struct Numbers {
  Bytes bytes;
  bool is_little{true};
  bool is_whole{true};

  std::uint32_t at(std::size_t place, std::size_t count) {
    if (place > bytes.size() || bytes.size() - place < count) {
      is_whole = false;
      return 0;
    }
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from_top = is_little ? count - 1 - i : i;
      number = number << 8U | bytes[place + from_top];
    }
    return number;
  }
};

/// The tag in a parameter list that begins with its encapsulation.
std::optional<std::string> tag_in(Bytes list) {
  if (list.size() < 4 || list[0] != 0 || (list[1] != 2 && list[1] != 3)) return std::nullopt;
  Numbers numbers{list, list[1] == 3};
  std::string tag;
  for (std::size_t at = 4; numbers.is_whole;) {
    const std::uint32_t parameter = numbers.at(at, 2);
    const std::uint32_t length = numbers.at(at + 2, 2);
    if (!numbers.is_whole) break;
    if (parameter == kSentinel) return tag;
    if (parameter == kDomainTag) {
      const std::uint32_t size = numbers.at(at + 4, 4);  // with its zero
      if (size == 0 || size + 4 > length || at + 8 + size > list.size()) break;
      tag.assign(list.begin() + static_cast<std::ptrdiff_t>(at + 8),
                 list.begin() + static_cast<std::ptrdiff_t>(at + 8 + size - 1));
    }
    at += 4 + length;
  }
  return std::nullopt;
}

/// What a DATA submessage of the participants' writer carries; empty: it is another one's.
Bytes announcement_in(Bytes body, std::uint8_t flags) {
  Numbers numbers{body, (flags & 1U) != 0};
  const std::size_t data = 4 + numbers.at(2, 2);  // the offset counts from behind itself
  const bool has_inline_qos = (flags & 2U) != 0;
  const bool has_data = (flags & 4U) != 0;
  if (!has_data || has_inline_qos || body.size() < 12 || data >= body.size()) return {};
  if (!std::equal(kParticipantWriter.begin(), kParticipantWriter.end(), body.begin() + 8))
    return {};
  return body.subspan(data);
}

/// What a stranger announces is shown to people: no longer than a profile's tag, no line breaks.
bool can_be_tag(std::string_view text) {
  return text.size() <= kLongestTag &&
         std::ranges::all_of(text, [](char letter) { return letter > ' ' && letter < 0x7f; });
}

std::vector<ip_mreqn> memberships() {
  std::vector<ip_mreqn> all;
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) return all;
  for (const ifaddrs* card = list; card != nullptr; card = card->ifa_next) {
    const bool is_ipv4 = card->ifa_addr != nullptr && card->ifa_addr->sa_family == AF_INET;
    if (!is_ipv4 || (card->ifa_flags & static_cast<unsigned>(IFF_UP)) == 0) continue;
    ip_mreqn membership{};
    ::inet_pton(AF_INET, kGroup, &membership.imr_multiaddr);
    membership.imr_ifindex = static_cast<int>(::if_nametoindex(card->ifa_name));
    all.push_back(membership);
  }
  ::freeifaddrs(list);
  return all;
}

/// @return -1 if somebody has the port for himself, or descriptors are at an end
int listen_at(std::uint16_t port, const std::vector<ip_mreqn>& cards) {
  const int descriptor = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return descriptor;
  const int yes = 1;
  ::setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  // Bound to the group: what is meant for a participant of this computer stays its own.
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  ::inet_pton(AF_INET, kGroup, &address.sin_addr);
  bool hears = ::bind(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0;
  if (hears) {
    hears =
        std::ranges::count_if(cards, [&](const ip_mreqn& card) {
          return ::setsockopt(descriptor, IPPROTO_IP, IP_ADD_MEMBERSHIP, &card, sizeof(card)) == 0;
        }) > 0;
  }
  if (hears) return descriptor;
  ::close(descriptor);
  return -1;
}

}  // namespace

std::optional<std::string> announced_tag(Bytes packet) {
  constexpr std::string_view kMagic = "RTPS";
  if (packet.size() < kHeader || !std::equal(kMagic.begin(), kMagic.end(), packet.begin())) {
    return std::nullopt;
  }
  for (std::size_t at = kHeader; at + 4 <= packet.size();) {
    const std::uint8_t flags = packet[at + 1];
    const std::size_t length = Numbers{packet, (flags & 1U) != 0}.at(at + 2, 2);
    const std::size_t rest = packet.size() - at - 4;
    const std::size_t size = length == 0 ? rest : length;  // 0: up to the end
    if (size > rest) return std::nullopt;
    if (packet[at] == kData) {
      auto tag = tag_in(announcement_in(packet.subspan(at + 4, size), flags));
      if (tag && can_be_tag(*tag)) return tag;
    }
    at += 4 + size;
  }
  return std::nullopt;
}

struct OtherDomains::Impl {
  std::array<int, kDomains> sockets{};
  std::map<AnnouncedDomain, HostTime> last_heard;

  void read(std::uint32_t domain, HostTime now) {
    std::array<std::uint8_t, 2048> packet{};
    for (int i = 0; i < kMostPacketsAtOnce; ++i) {
      const auto size = ::recv(sockets.at(domain), packet.data(), packet.size(), 0);
      if (size <= 0) return;
      const auto tag = announced_tag(Bytes(packet).first(static_cast<std::size_t>(size)));
      if (tag) last_heard[{domain, *tag}] = now;
    }
  }
};

OtherDomains::OtherDomains() : impl_(std::make_unique<Impl>()) {
  const std::vector<ip_mreqn> cards = memberships();
  for (std::uint32_t domain = 0; domain < kDomains; ++domain) {
    const std::uint32_t port = kFirstPort + kPortsPerDomain * domain;
    impl_->sockets.at(domain) = listen_at(static_cast<std::uint16_t>(port), cards);
  }
}

OtherDomains::~OtherDomains() {
  for (const int descriptor : impl_->sockets) {
    if (descriptor >= 0) ::close(descriptor);
  }
}

std::set<AnnouncedDomain> OtherDomains::heard(HostTime now) {
  for (std::uint32_t domain = 0; domain < kDomains; ++domain) {
    if (impl_->sockets.at(domain) >= 0) impl_->read(domain, now);
  }
  std::erase_if(impl_->last_heard,
                [&](const auto& entry) { return now - entry.second > kRemembered; });
  std::set<AnnouncedDomain> domains;
  for (const auto& [domain, when] : impl_->last_heard) domains.insert(domain);
  return domains;
}

std::string to_text(const std::set<AnnouncedDomain>& domains) {
  std::string text;
  std::size_t named = 0;
  for (const AnnouncedDomain& domain : domains) {
    if (named++ == kMostNamed) {
      return text + " and " + std::to_string(domains.size() - kMostNamed) + " more";
    }
    text += (text.empty() ? "domain " : ", domain ") + std::to_string(domain.id);
    if (!domain.tag.empty()) text += " (" + domain.tag + ")";
  }
  return text;
}

}  // namespace teamsight::bus
