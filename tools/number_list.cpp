// tools/number_list.cpp: splitting at commas; every part must be a finite number.
#include "tools/number_list.hpp"

#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace teamsight::tools {

std::vector<double> read_numbers(const std::string& option,
                                 const std::string& text,
                                 std::size_t count) {
  const auto complain = [&] {
    const std::string expected = count > 0 ? std::to_string(count) + " numbers" : "numbers";
    throw std::runtime_error(option + ": found \"" + text + "\", expected " + expected +
                             " separated by commas");
  };
  std::vector<double> numbers;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    double number = 0.0;
    const char* end = part.data() + part.size();
    const auto [rest, error] = std::from_chars(part.data(), end, number);
    if (error != std::errc{} || rest != end || !std::isfinite(number)) complain();
    numbers.push_back(number);
  }
  const bool is_complete = count > 0 ? numbers.size() == count : !numbers.empty();
  if (!is_complete || text.back() == ',') complain();
  return numbers;
}

}  // namespace teamsight::tools
