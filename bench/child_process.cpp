// bench/child_process.cpp: see child_process.hpp.
#include "bench/child_process.hpp"

#include <array>
#include <csignal>
#include <stdexcept>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace teamsight::bench {
namespace {

// In the child: only calls that are allowed between fork and exec.
[[noreturn]] void become(const std::vector<char*>& argv, int output) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::dup2(output, STDOUT_FILENO);
  ::execv("/proc/self/exe", argv.data());
  ::_exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"/proc/self/exe"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error("pipe2 failed");
  }
  pipe_ = ends[0];
  pid_ = ::fork();
  if (pid_ == 0) {
    become(argv, ends[1]);
  }
  ::close(ends[1]);
  if (pid_ < 0) {
    ::close(pipe_);
    throw std::runtime_error("fork failed");
  }
}

ChildProcess::~ChildProcess() {
  ::close(pipe_);
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
}

std::string ChildProcess::output() {
  std::string text;
  std::array<char, 65536> piece{};
  ssize_t got = 0;
  while ((got = ::read(pipe_, piece.data(), piece.size())) > 0) {
    text.append(piece.data(), static_cast<std::size_t>(got));
  }
  int status = 0;
  ::waitpid(pid_, &status, 0);
  pid_ = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("a measuring process failed");
  }
  return text;
}

}  // namespace teamsight::bench
