// bench/kept_play/kept_game.hpp: what the robots of one game saw, in a file, so that it is rendered
// once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/play/eyes.hpp"

namespace teamsight::kept_play {

/// All that a game's frames depend on, by name: two games with the same facts are the same game.
using Facts = std::map<std::string, std::string>;

/// Changes with every change of the code that plays, renders and perceives, and with the compiler.
[[nodiscard]] std::string_view seeing_code();

/// Every look of a game, in the order in which they were taken, with the moment as its exposure.
using Looks = std::vector<fusion::Observation>;

/// The file is whole, but another game's: one line that says which fact is found and expected.
class OtherGame : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes a recording (MCAP) with each look as a robot would publish it; what it truly shows and
/// what was true can be had from the game's seed again. A file of that name is replaced at the end.
///
/// @throws std::runtime_error naming the file if it cannot be written or a look cannot be kept to
///         the last bit
void write_game(const std::filesystem::path& file, const Facts& facts, const Looks& looks);

/// Reads a kept game.
///
/// @throws OtherGame if it was kept with other facts
/// @throws std::runtime_error naming the file if it cannot be read whole
[[nodiscard]] Looks read_game(const std::filesystem::path& file, const Facts& expected);

/// Passes on what other eyes see, and remembers it.
class KeepingEyes final : public play::Eyes {
 public:
  /// @param eyes  outlive this
  explicit KeepingEyes(play::Eyes& eyes) : eyes_(eyes) {}

  void set_fault(std::size_t robot, play::Fault fault, const play::Moment& moment) override {
    eyes_.set_fault(robot, fault, moment);
  }

  void begin(const play::Moment& first) override { eyes_.begin(first); }

  void step(const play::Moment& moment) override { eyes_.step(moment); }

  [[nodiscard]] play::Frame look(std::size_t robot,
                                 const play::Moment& moment,
                                 double since) override;

  [[nodiscard]] const Looks& looks() const { return looks_; }

 private:
  play::Eyes& eyes_;
  Looks looks_;
};

/// Sees what was kept, in the same game.
class KeptEyes final : public play::Eyes {
 public:
  KeptEyes(Looks looks, double robot_radius) : looks_(std::move(looks)), radius_(robot_radius) {}

  void set_fault(std::size_t /*robot*/,
                 play::Fault /*fault*/,
                 const play::Moment& /*moment*/) override {}

  void begin(const play::Moment& /*first*/) override {}

  void step(const play::Moment& /*moment*/) override {}

  /// @throws std::runtime_error if that look is not the next one that was kept
  [[nodiscard]] play::Frame look(std::size_t robot,
                                 const play::Moment& moment,
                                 double since) override;

 private:
  Looks looks_;
  double radius_;
  std::size_t next_{0};
};

}  // namespace teamsight::kept_play
