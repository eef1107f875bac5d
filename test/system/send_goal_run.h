// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <string>

namespace pomdp_crowd_nav {

struct ProgramRun {
  int status = -1;     // of its end
  std::string output;  // both of its outputs
};

// Runs the tool of that name, which lies beside this test.
inline ProgramRun runSendGoal(const std::string& arguments) {
  const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string command = (folder / "send_goal").string() + " " + arguments + " 2>&1";
  ProgramRun run;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return run;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) run.output += static_cast<char>(c);
  run.status = WEXITSTATUS(pclose(pipe));
  return run;
}

}  // namespace pomdp_crowd_nav
