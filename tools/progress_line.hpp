// tools/progress_line.hpp: how far long work is, for who waits in front of a terminal.
#pragma once

#include <iostream>
#include <string_view>

#include <unistd.h>

namespace teamsight::tools {

/// One line of standard error, written over again and again; nothing where that is no terminal.
class ProgressLine {
 public:
  ProgressLine() : is_shown_(::isatty(STDERR_FILENO) == 1) {}

  void say(std::string_view text) const {
    if (is_shown_) std::cerr << "\r\x1b[K" << text << std::flush;
  }

  /// Leaves an empty line for what comes next.
  void clear() const { say(""); }

 private:
  bool is_shown_;
};

}  // namespace teamsight::tools
