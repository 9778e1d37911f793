// bus/computer.cpp: see computer.hpp.
#include "bus/computer.hpp"

#include <array>
#include <memory>
#include <sstream>

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

namespace teamsight::bus {
namespace {

in_addr_t number_of(const std::string& address) {
  in_addr number{};
  return ::inet_pton(AF_INET, address.c_str(), &number) == 1 ? number.s_addr : INADDR_NONE;
}

using Interfaces = std::unique_ptr<ifaddrs, void (*)(ifaddrs*)>;

Interfaces interfaces() {
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) list = nullptr;
  return {list, &::freeifaddrs};
}

std::optional<in_addr> address_of(const ifaddrs& interface) {
  if (interface.ifa_addr == nullptr || interface.ifa_addr->sa_family != AF_INET)
    return std::nullopt;
  return reinterpret_cast<const sockaddr_in*>(interface.ifa_addr)->sin_addr;
}

std::string text_of(const in_addr& address) {
  std::array<char, INET_ADDRSTRLEN> text{};
  ::inet_ntop(AF_INET, &address, text.data(), text.size());
  return text.data();
}

}  // namespace

std::string to_text(const Computer& computer) {
  if (computer.is_this) return "this computer";
  const std::string name = computer.name.empty() ? "another computer" : computer.name;
  return computer.address.empty() ? name : name + " (" + computer.address + ")";
}

std::string unicast_address_in(const std::string& locators) {
  std::istringstream stream(locators);
  for (std::string locator; std::getline(stream, locator, ',');) {
    const std::size_t begin = locator.find('/');
    const std::size_t end = locator.find(':');
    if (begin == std::string::npos || end == std::string::npos || end < begin) continue;
    std::string address = locator.substr(begin + 1, end - begin - 1);
    const in_addr_t number = number_of(address);
    if (number != INADDR_NONE && !IN_MULTICAST(ntohl(number))) return address;
  }
  return {};
}

std::optional<std::vector<std::string>> cards_up() {
  const Interfaces all = interfaces();
  if (!all) return std::nullopt;
  std::vector<std::string> cards;
  for (const ifaddrs* one = all.get(); one != nullptr; one = one->ifa_next) {
    const bool is_usable = (one->ifa_flags & IFF_UP) != 0 && (one->ifa_flags & IFF_LOOPBACK) == 0;
    const auto address = address_of(*one);
    if (is_usable && address) cards.push_back(one->ifa_name + (" (" + text_of(*address) + ")"));
  }
  return cards;
}

bool is_own_address(const std::string& address) {
  const in_addr_t number = number_of(address);
  if (number == INADDR_NONE) return false;
  if (ntohl(number) >> 24U == IN_LOOPBACKNET) return true;
  const Interfaces all = interfaces();
  for (const ifaddrs* one = all.get(); one != nullptr; one = one->ifa_next) {
    const auto own = address_of(*one);
    if (own && own->s_addr == number) return true;
  }
  return false;
}

}  // namespace teamsight::bus
