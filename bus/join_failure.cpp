// bus/join_failure.cpp: see join_failure.hpp.
#include "bus/join_failure.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <string_view>

#include <dds/dds.h>
#include <net/if.h>

#include "bus/computer.hpp"
#include "bus/library_log.hpp"

namespace teamsight::bus {
namespace {

// The library ends its message about an unknown interface like this, its name before it.
constexpr std::string_view kNoSuchInterface = ": does not match an available interface";
constexpr std::string_view kNoInterface = "failed to find interfaces";

bool says(const std::string& reason, std::string_view words) {
  return reason.find(words) != std::string::npos;
}

bool names_an_existing_interface(const std::string& reason) {
  const std::size_t end = reason.find(kNoSuchInterface);
  if (end == std::string::npos) return false;
  const std::size_t before = reason.find_last_of(" ;\n", end == 0 ? 0 : end - 1);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  return if_nametoindex(reason.substr(start, end - start).c_str()) != 0;
}

std::string interface_list() {
  std::string all;
  struct if_nameindex* const cards = ::if_nameindex();
  for (const auto* card = cards; card != nullptr && card->if_index != 0; ++card) {
    all += (all.empty() ? "" : ", ") + std::string(card->if_name);
  }
  if (cards != nullptr) ::if_freenameindex(cards);
  return all.empty() ? "none" : all;
}

std::string advice_on_cards() {
  return "no network card is up with an address, this computer has: " + interface_list() +
         "; plug the cable in, or: ip link set NAME up";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 16> text{};
  if (::gmtime_r(&now, &parts) == nullptr) return "nothing";
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
  return text.data();
}

// What an operator can do about what the library says; empty: nothing that is known.
std::string advice_on(const std::string& reason) {
  if (says(reason, kNoInterface)) return "; " + advice_on_cards();
  if (says(reason, kNoSuchInterface)) {
    return " This computer has: " + interface_list() + "; name one of them in NetworkInterface";
  }
  const std::string clock = "this computer's clock says " + today();
  if (says(reason, "expired")) {
    return "; " + clock + ": set it if that is wrong, else make new ones: teamsight keys --renew";
  }
  if (says(reason, "not started yet") || says(reason, "not yet valid")) {
    return "; " + clock + ": set it";
  }
  return {};
}

}  // namespace

JoinFailure failure_of(const DomainSettings& settings, const char* call, std::int32_t code) {
  std::string reason = LibraryLogCapture::text();
  const bool may_pass = says(reason, kNoInterface) || names_an_existing_interface(reason);
  if (reason.empty()) reason = std::string(call) + ": " + dds_strretcode(code);
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  // How the library calls a text that it was given: nobody set that variable.
  constexpr std::string_view kGivenText = "CYCLONEDDS_URI+0 ";
  if (const std::size_t at = reason.find(kGivenText); at != std::string::npos) {
    reason.erase(at, kGivenText.size());
  }
  const bool is_keys = says(reason, "ertificate") || says(reason, "ermissions");
  const std::string file =
      is_keys ? "security " + settings.identity : "DDS profile " + settings.profile_path;
  return {file + ": " + reason + advice_on(reason), may_pass};
}

std::optional<JoinFailure> missing_card(const DomainSettings& settings,
                                        const std::string& configuration) {
  if (!says(configuration, "autodetermine=\"true\"")) return std::nullopt;
  const auto cards = cards_up();
  if (!cards || !cards->empty()) return std::nullopt;  // unknown: the library may know better
  return JoinFailure{"DDS profile " + settings.profile_path + ": " + advice_on_cards(), true};
}

}  // namespace teamsight::bus
