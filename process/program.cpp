// process/program.cpp: see process/program.hpp.
#include "process/program.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <random>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

namespace teamsight::process {
namespace {

/// Whatever a library wrote into its message, the operator gets one line.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::replace(text.begin(), text.end(), '\r', ' ');
  const auto last = text.find_last_not_of(' ');
  text.resize(last == std::string::npos ? 0 : last + 1);
  return text;
}

}  // namespace

int run_program(const char* name, const std::function<int()>& body) noexcept {
  try {
    return body();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, one_line(error.what()).c_str());
  } catch (...) {
    std::fprintf(stderr, "%s: something unknown was thrown\n", name);
  }
  return kBadInput;
}

std::optional<int> parse_command_line(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      app.exit(error);
      return kDone;
    }
    throw std::runtime_error(std::string("command line: ") + error.what() + " (see --help)");
  }
}

std::uint32_t draw_boot_id() {
  std::random_device entropy;
  std::uniform_int_distribution<std::uint32_t> nonzero(1);
  return nonzero(entropy);
}

}  // namespace teamsight::process
