// tests/support/process.cpp: see process.hpp.
#include "tests/support/process.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace teamsight::test {
namespace {

using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

fs::path environment_path(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets it later
  if (value == nullptr || *value == '\0') {
    throw std::runtime_error(std::string(name) + " is not set; run the tests through ctest");
  }
  return value;
}

fs::path make_temp_directory() {
  std::string name = (fs::temp_directory_path() / "teamsight-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("cannot make a temporary directory like " + name);
  }
  return name;
}

void remove_directory(const fs::path& path) noexcept {
  std::error_code ignored;
  if (!path.empty()) {
    fs::remove_all(path, ignored);
  }
}

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// Between fork and exec: only calls that are safe there.
[[noreturn]] void become(char* const* argv, char* const* envp, int out, int err, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) {
    ::_exit(127);  // the test died before the line above
  }
  const int null = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(null, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  ::execve(argv[0], argv, envp);
  const char* reason = std::strerror(errno);  // NOLINT(concurrency-mt-unsafe): one thread here
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, reason, std::strlen(reason));
  ::_exit(127);
}

std::vector<std::string> merged_environment(const ChildProcess::Environment& changes) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string name = std::string(*entry).substr(0, std::string(*entry).find('='));
    bool is_changed = false;
    for (const auto& [changed, value] : changes) {
      is_changed = is_changed || changed == name;
    }
    if (!is_changed) {
      all.emplace_back(*entry);
    }
  }
  for (const auto& [name, value] : changes) {
    all.push_back(name);
    all.back().append("=").append(value);
  }
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> all;
  all.reserve(strings.size() + 1);
  for (std::string& text : strings) {
    all.push_back(text.data());
  }
  all.push_back(nullptr);
  return all;
}

int open_log(const fs::path& path) {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
}

// Takes the lock for as long as this process lives: the descriptor is never closed.
bool claim_domain(std::uint32_t id) {
  const fs::path path =
      fs::temp_directory_path() / ("teamsight-domain-" + std::to_string(id) + ".lock");
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) {
    return false;
  }
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) {
    return true;
  }
  ::close(file);
  return false;
}

std::uint32_t claim_some_domain() {
  // A domain's ports begin at 7400 + 250 * id. From 32768 on Linux gives ports to whoever asks for
  // any, so that another process may hold one of ours: no domain from 101 on.
  constexpr std::uint32_t kDomains = 49;
  const auto start = static_cast<std::uint32_t>(::getpid());
  for (std::uint32_t i = 0; i < kDomains; ++i) {
    const std::uint32_t id = 2 + 2 * ((start + i) % kDomains);
    if (claim_domain(id)) {
      return id;
    }
  }
  throw std::runtime_error("no DDS domain id is free for this test");
}

}  // namespace

bool wait_until(const std::function<bool()>& is_true, std::chrono::milliseconds bound) {
  const auto deadline = Clock::now() + bound;
  while (!is_true()) {
    if (Clock::now() >= deadline) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // between looks, not instead of one
  }
  return true;
}

fs::path program(const std::string& name) {
  fs::path path = environment_path("TEAMSIGHT_BIN_DIR") / name;
  if (::access(path.c_str(), X_OK) != 0) {
    throw std::runtime_error(path.string() + " is not there: build it first");
  }
  return path;
}

fs::path source_path(const std::string& relative) {
  return environment_path("TEAMSIGHT_SOURCE_DIR") / relative;
}

std::uint32_t unique_domain() {
  static const std::uint32_t id = claim_some_domain();
  return id;
}

TempDirectory::TempDirectory() : path_(make_temp_directory()) {}

TempDirectory::~TempDirectory() {
  remove_directory(path_);
}

fs::path TempDirectory::write(const std::string& name, const std::string& text) const {
  fs::path path = path_ / name;
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) {
    throw std::runtime_error("cannot write " + path.string());
  }
  return path;
}

ChildProcess::ChildProcess(const std::vector<std::string>& argv, const Environment& environment)
    : directory_(make_temp_directory()) {
  std::vector<std::string> arguments = argv;
  std::vector<std::string> variables = merged_environment(environment);
  const std::vector<char*> argument_pointers = pointers(arguments);
  const std::vector<char*> variable_pointers = pointers(variables);
  const int out = open_log(directory_ / "out");
  const int err = open_log(directory_ / "err");
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) {
    become(argument_pointers.data(), variable_pointers.data(), out, err, parent);
  }
  ::close(out);
  ::close(err);
  if (pid_ < 0) {
    remove_directory(directory_);
    throw std::runtime_error("cannot fork for " + argv.at(0));
  }
  ::setpgid(pid_, pid_);  // in both processes, so that neither has to wait for the other
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept {
  *this = std::move(other);
}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(exit_code_, other.exit_code_);
  std::swap(directory_, other.directory_);
  return *this;
}

ChildProcess::~ChildProcess() {
  end();
  remove_directory(directory_);
}

void ChildProcess::look() noexcept {
  int status = 0;
  if (pid_ <= 0 || exit_code_.has_value() || ::waitpid(pid_, &status, WNOHANG) != pid_) {
    return;
  }
  exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::optional<int> ChildProcess::wait_exit(std::chrono::milliseconds bound) {
  [[maybe_unused]] const bool ended = wait_until(
      [this] {
        look();
        return exit_code_.has_value();
      },
      bound);
  return exit_code_;
}

bool ChildProcess::is_running() {
  look();
  return pid_ > 0 && !exit_code_.has_value();
}

void ChildProcess::kill(int signal) {
  if (is_running()) {
    ::kill(-pid_, signal);
  }
}

void ChildProcess::end() noexcept {
  if (pid_ <= 0) {
    return;
  }
  look();
  if (!exit_code_.has_value()) {
    ::kill(-pid_, SIGCONT);  // a stopped one would not see the next line
    ::kill(-pid_, SIGTERM);
    const auto deadline = Clock::now() + std::chrono::seconds(2);
    while (!exit_code_.has_value() && Clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      look();
    }
  }
  ::kill(-pid_, SIGKILL);  // the rest of the group, if it left anybody behind
  if (!exit_code_.has_value()) {
    ::waitpid(pid_, nullptr, 0);
    exit_code_ = 128 + SIGKILL;
  }
}

std::string ChildProcess::out() const {
  return contents(directory_ / "out");
}

std::string ChildProcess::err() const {
  return contents(directory_ / "err");
}

}  // namespace teamsight::test
