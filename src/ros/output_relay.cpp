// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/output_relay.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>

namespace pomdp_crowd_nav {
namespace {

constexpr size_t kStreams = 2;
constexpr std::array<int, kStreams> kOutputs = {STDOUT_FILENO, STDERR_FILENO};

struct Pipe {
  int read_end = -1;
  int write_end = -1;
};
using Pipes = std::array<Pipe, kStreams>;

bool open(Pipe& made) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return false;
  made = {ends[0], ends[1]};
  return fcntl(made.write_end, F_SETFL, O_NONBLOCK) == 0;
}

void passOn(const char* text, ssize_t size, int output) {
  while (size > 0) {
    const ssize_t written = write(output, text, static_cast<size_t>(size));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;  // nobody is there to read it
    text += written;
    size -= written;
  }
}

// Until both are closed at the other end.
[[noreturn]] void relay(const Pipes& pipes) {
  // It outlives the node by its last words, whatever ends that.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_IGN);
  std::array<pollfd, kStreams> inputs{};
  for (size_t i = 0; i < kStreams; ++i) inputs[i] = {pipes[i].read_end, POLLIN, 0};
  std::array<char, 4096> text{};
  while (inputs[0].fd >= 0 || inputs[1].fd >= 0) {
    if (poll(inputs.data(), kStreams, -1) < 0) continue;
    for (size_t i = 0; i < kStreams; ++i) {
      if (inputs[i].fd < 0 || inputs[i].revents == 0) continue;
      const ssize_t size = read(inputs[i].fd, text.data(), text.size());
      if (size <= 0) inputs[i].fd = -1;  // poll passes over it
      passOn(text.data(), size, kOutputs[i]);
    }
  }
  _exit(0);
}

}  // namespace

void relayOutput() {
  Pipes pipes;
  if (!open(pipes[0]) || !open(pipes[1])) return;
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) return;
  if (child == 0) {
    for (const Pipe& pipe : pipes) close(pipe.write_end);
    relay(pipes);
  }
  for (size_t i = 0; i < kStreams; ++i) {
    dup2(pipes[i].write_end, kOutputs[i]);
    close(pipes[i].write_end);
    close(pipes[i].read_end);
  }
  setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // lines come when they are written, as on a terminal
}

}  // namespace pomdp_crowd_nav
