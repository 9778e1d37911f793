// bench/child_process.hpp: this program once more, as another process.
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace teamsight::bench {

/// A child that runs this same program with other arguments. Its standard output can be read; it is
/// killed by the destructor, and by the kernel should this process die.
class ChildProcess {
 public:
  /// Starts it at once.
  ///
  /// @throws std::runtime_error if the system refuses
  explicit ChildProcess(const std::vector<std::string>& arguments);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ChildProcess(ChildProcess&&) = delete;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ~ChildProcess();

  /// Everything it prints until it ends by itself.
  ///
  /// @throws std::runtime_error if its exit code is not 0
  [[nodiscard]] std::string output();

 private:
  pid_t pid_{-1};
  int pipe_{-1};
};

}  // namespace teamsight::bench
