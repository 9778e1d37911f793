// bus/computer.cpp: see computer.hpp.
#include "bus/computer.hpp"

#include <memory>
#include <sstream>

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <netinet/in.h>

namespace teamsight::bus {
namespace {

in_addr_t number_of(const std::string& address) {
  in_addr number{};
  return ::inet_pton(AF_INET, address.c_str(), &number) == 1 ? number.s_addr : INADDR_NONE;
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

bool is_own_address(const std::string& address) {
  const in_addr_t number = number_of(address);
  if (number == INADDR_NONE) return false;
  if (ntohl(number) >> 24U == IN_LOOPBACKNET) return true;
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) return false;
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owner(list, &::freeifaddrs);
  for (const ifaddrs* one = list; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
    if (reinterpret_cast<const sockaddr_in*>(one->ifa_addr)->sin_addr.s_addr == number) return true;
  }
  return false;
}

}  // namespace teamsight::bus
