// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/durable_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

[[noreturn]] void fail(const char* deed, const std::string& path, const std::string& reason) {
  throw std::runtime_error(fmt::format("cannot {} '{}': {}", deed, path, reason));
}

[[noreturn]] void fail(const char* deed, const std::string& path) {
  fail(deed, path, std::strerror(errno));
}

}  // namespace

DurableFile DurableFile::openWith(const std::string& path, int flags) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | flags, 0666);
  if (descriptor < 0) fail("write", path, errno == EEXIST ? "it exists" : std::strerror(errno));
  DurableFile file(path, descriptor);
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    fail("write", path, "another program is writing it");
  }
  return file;
}

DurableFile DurableFile::create(const std::string& path) { return openWith(path, O_EXCL); }

DurableFile DurableFile::open(const std::string& path) { return openWith(path, 0); }

DurableFile DurableFile::standardOutput() { return {"standard output", STDOUT_FILENO}; }

DurableFile::DurableFile(DurableFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

DurableFile::~DurableFile() {
  if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) ::close(descriptor_);
}

std::string DurableFile::read() const {
  std::string text;
  char buffer[1 << 16];
  while (true) {
    const ssize_t count =
        ::pread(descriptor_, buffer, sizeof(buffer), static_cast<off_t>(text.size()));
    if (count < 0) fail("read", path_);
    if (count == 0) return text;
    text.append(buffer, static_cast<size_t>(count));
  }
}

void DurableFile::append(const std::string& text) {
  if (descriptor_ == STDOUT_FILENO) {
    write(text);
    return;
  }
  const off_t end = ::lseek(descriptor_, 0, SEEK_END);
  try {
    write(text);
  } catch (...) {
    // What cannot be cut off is dropped where the file is read.
    if (end >= 0) std::ignore = ::ftruncate(descriptor_, end);
    throw;
  }
}

void DurableFile::write(const std::string& text) {
  size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(descriptor_, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("write", path_);
    done += static_cast<size_t>(count);
  }
  // Pipes and terminals have no disk to wait for.
  if (::fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP) {
    fail("write", path_);
  }
}

void DurableFile::cutTo(std::uint64_t bytes) {
  if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) fail("write", path_);
}

void replaceFile(const std::string& path, const std::string& text) {
  const std::string part = path + ".part";
  {
    DurableFile file = DurableFile::open(part);
    file.cutTo(0);
    file.append(text);
  }
  if (std::rename(part.c_str(), path.c_str()) != 0) fail("write", path);
}

}  // namespace pomdp_crowd_nav
