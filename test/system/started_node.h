// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <string>

namespace pomdp_crowd_nav {

// A node that the test starts itself, to end it as it likes. Killed at the end.
class StartedNode {
 public:
  enum class Log { kShown, kBlocked };  // kBlocked: into a full pipe that nobody reads

  explicit StartedNode(const std::string& program, Log log = Log::kShown) {
    if (log == Log::kBlocked) openFullPipe();
    process_ = fork();
    if (process_ < 0) throw std::runtime_error("there is no other process");
    if (process_ != 0) return;
    if (log == Log::kBlocked) {
      dup2(pipe_[1], STDOUT_FILENO);
      dup2(pipe_[1], STDERR_FILENO);
    }
    execl(program.c_str(), program.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  ~StartedNode() {
    kill(SIGKILL);
    for (const int end : pipe_) {
      if (end >= 0) close(end);
    }
  }
  StartedNode(const StartedNode&) = delete;
  StartedNode& operator=(const StartedNode&) = delete;

  // Waits for the end of a process that is killed.
  void kill(int signal) {
    if (process_ <= 0) return;
    ::kill(process_, signal);
    if (signal != SIGKILL) return;
    waitpid(process_, nullptr, 0);
    process_ = 0;
  }

  bool isRunning() {
    if (process_ > 0 && waitpid(process_, nullptr, WNOHANG) == process_) process_ = 0;
    return process_ > 0;
  }

  // Its exit status; -1 while it runs, and of one that a signal has ended.
  int exitStatus() {
    int status = 0;
    if (process_ <= 0 || waitpid(process_, &status, WNOHANG) != process_) return -1;
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  void openFullPipe() {
    if (pipe(pipe_.data()) != 0) throw std::runtime_error("there is no pipe");
    for (const int end : pipe_) fcntl(end, F_SETFD, FD_CLOEXEC);
    fcntl(pipe_[1], F_SETFL, O_NONBLOCK);
    const std::array<char, 1024> text{};
    while (write(pipe_[1], text.data(), text.size()) > 0) continue;
    while (write(pipe_[1], text.data(), 1) > 0) continue;
    fcntl(pipe_[1], F_SETFL, 0);
  }

  pid_t process_ = 0;
  std::array<int, 2> pipe_{-1, -1};
};

}  // namespace pomdp_crowd_nav
