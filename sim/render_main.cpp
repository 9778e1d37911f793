// sim/render_main.cpp: the program `teamsight-sim-render`: a match as image files with truth.
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "process/program.hpp"
#include "sim/picture_book.hpp"

namespace teamsight::sim {
namespace {

void tell(int frames, int all) {
  if (frames % 25 == 0 || frames == all) {
    std::fprintf(stderr, "%d of %d frames\n", frames, all);
  }
}

int run(int argc, const char* const* argv) {
  std::string match;
  std::string out;
  double seconds = 10.0;
  std::optional<std::uint32_t> seed;
  std::optional<int> jpeg_quality;
  CLI::App app("Plays a simulated match and writes what each own robot sees, with the truth.");
  app.add_option("--match", match, "match file (config/matches)")->required();
  app.add_option("--out", out, "new directory for robotN_FRAME.png and truth.jsonl")->required();
  app.add_option("--seconds", seconds, "of the match")->check(CLI::PositiveNumber);
  app.add_option("--jpeg", jpeg_quality, "write JPEG of this quality, not PNG")
      ->check(CLI::Range(1, 100));
  app.add_option("--seed", seed, "instead of the match's");
  app.footer(scenario_help());
  if (const auto code = process::parse_command_line(app, argc, argv)) {
    return *code;
  }
  std::filesystem::path folder = out;
  if (!folder.has_filename()) {
    folder = folder.parent_path();  // OUT/
  }
  write_picture_book(load_setup(match, {}, seed), {folder, seconds, jpeg_quality}, tell);
  return process::kDone;
}

}  // namespace
}  // namespace teamsight::sim

int main(int argc, char** argv) {
  return teamsight::process::run_program("teamsight-sim-render",
                                         [&] { return teamsight::sim::run(argc, argv); });
}
