// tests/support/process.hpp: starting real programs in a test, and ending them whatever happens.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace teamsight::test {

/// Asks `is_true` again and again until it says yes.
///
/// For conditions that only another process or thread can bring about; never a fixed sleep.
///
/// @param bound  how long at most, by the monotonic clock
/// @return whether it became true in time
[[nodiscard]] bool wait_until(const std::function<bool()>& is_true,
                              std::chrono::milliseconds bound);

/// The file of one of this project's programs, in the directory that TEAMSIGHT_BIN_DIR names.
///
/// @throws std::runtime_error if the variable is not set or the program is not there
[[nodiscard]] std::filesystem::path program(const std::string& name);

/// A file of the repository, in the directory that TEAMSIGHT_SOURCE_DIR names.
///
/// @throws std::runtime_error if the variable is not set
[[nodiscard]] std::filesystem::path source_path(const std::string& relative);

/// A DDS domain id that no other test or demo on this machine uses while this one lives.
///
/// Even, in [2, 98]; the next one up is free as well, for a host domain. The same in every call
/// of one process. Claimed by a lock on a file in the temporary directory, which ends with the
/// process.
///
/// @throws std::runtime_error if all of them are taken
[[nodiscard]] std::uint32_t unique_domain();

/// A directory of its own, removed with everything in it at the end.
class TempDirectory {
 public:
  TempDirectory();
  TempDirectory(const TempDirectory&) = delete;
  TempDirectory& operator=(const TempDirectory&) = delete;
  ~TempDirectory();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes a file there and returns its path.
  [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

/// A program that runs beside the test, in a process group of its own.
///
/// The destructor ends the group: SIGTERM, and SIGKILL if it is still there two seconds later. If
/// the test itself dies the kernel kills the program. What it prints is kept in files until the
/// object dies.
class ChildProcess {
 public:
  /// Changes of the environment: name and value.
  using Environment = std::vector<std::pair<std::string, std::string>>;

  /// Starts it at once.
  ///
  /// @param argv         the program's path and its arguments
  /// @param environment  set on top of the test's own
  /// @throws std::runtime_error if it cannot be started
  explicit ChildProcess(const std::vector<std::string>& argv, const Environment& environment = {});
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  [[nodiscard]] pid_t pid() const { return pid_; }

  /// Waits for its end.
  ///
  /// @return its exit code, 128 + the signal that ended it, or nothing if it still runs
  [[nodiscard]] std::optional<int> wait_exit(std::chrono::milliseconds bound);

  [[nodiscard]] bool is_running();

  /// Sends a signal to the whole group; nothing happens if it has ended.
  void kill(int signal);

  /// Ends it as the destructor would; once it has ended this does nothing.
  void end() noexcept;

  /// Everything on its standard output up to now.
  [[nodiscard]] std::string out() const;

  /// Everything on its standard error up to now.
  [[nodiscard]] std::string err() const;

 private:
  void look() noexcept;

  pid_t pid_{-1};
  std::optional<int> exit_code_;
  std::filesystem::path directory_;
};

}  // namespace teamsight::test
