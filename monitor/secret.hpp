// monitor/secret.hpp: the station's token: drawn, and compared.
#pragma once

#include <string>
#include <string_view>

namespace teamsight::monitor {

/// 128 random bits of the system, as 32 hexadecimal digits.
///
/// @throws std::runtime_error if the system has none
[[nodiscard]] std::string draw_token();

/// Whether two secrets are the same, in a time that does not tell how much of them is.
[[nodiscard]] bool is_same_secret(std::string_view a, std::string_view b);

}  // namespace teamsight::monitor
