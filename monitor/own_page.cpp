// monitor/own_page.cpp: is_own_page of monitor/web_server.hpp.
#include <algorithm>
#include <cctype>
#include <string_view>

#include "monitor/web_server.hpp"

namespace teamsight::monitor {
namespace {

/// "name" of "name:port", "[::1]" of "[::1]:port".
std::string_view without_port(std::string_view host) {
  const auto bracket = host.rfind(']');
  const auto colon = host.rfind(':');
  const bool has_port =
      colon != std::string_view::npos && (bracket == std::string_view::npos || colon > bracket);
  return has_port ? host.substr(0, colon) : host;
}

bool is_number(std::string_view name) {
  if (name.starts_with('[') && name.ends_with(']')) return true;
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char character) {
    return std::isdigit(character) != 0 || character == '.';
  });
}

}  // namespace

bool is_own_page(std::string_view host, std::string_view origin) {
  const std::string_view name = without_port(host);
  if (name != "localhost" && !is_number(name)) return false;
  constexpr std::string_view kScheme = "http://";
  if (origin.empty()) return true;  // not a browser
  return origin.starts_with(kScheme) && origin.substr(kScheme.size()) == host;
}

}  // namespace teamsight::monitor
