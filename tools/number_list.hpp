// tools/number_list.hpp: comma separated numbers from the command line.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace teamsight::tools {

/// Reads "1,2.5,-3".
///
/// @param option  its name, for the message
/// @param count   how many there must be; 0: any number
/// @throws std::runtime_error naming the option, what was found and what was expected
[[nodiscard]] std::vector<double> read_numbers(const std::string& option,
                                               const std::string& text,
                                               std::size_t count = 0);

}  // namespace teamsight::tools
