// recording/output_file.cpp: see recording/output_file.hpp.
#include "recording/output_file.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace teamsight::recording {

OutputFile::OutputFile(const std::filesystem::path& path)
    : name_(path.string()),
      descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644)) {
  exists_already_ = descriptor_ < 0 && errno == EEXIST;
  if (descriptor_ < 0) fail(errno);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::fail(int error) {
  problem_ = name_ + ": " + std::generic_category().message(error);
}

bool OutputFile::write(std::string_view bytes) {
  while (problem_.empty() && !bytes.empty()) {
    const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) {
      fail(errno);
    } else {
      bytes.remove_prefix(static_cast<std::size_t>(done));
    }
  }
  return problem_.empty();
}

void OutputFile::sync() {
  if (problem_.empty() && ::fdatasync(descriptor_) != 0) fail(errno);
}

}  // namespace teamsight::recording
