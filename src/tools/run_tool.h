// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <string>
#include <vector>

#include "interruption.h"
#include "pomdp_crowd_nav/params/closest_name.h"

namespace pomdp_crowd_nav {

// What --help says of the status of a tool that only succeeds or fails.
constexpr const char* kExitStatus =
    "\nExit status: 0, or 2 and one line for a bad argument or file.";
constexpr const char* kExitStatusOfLongRuns =
    "\nExit status: 0; 2 and one line for a bad argument or file; 130, 143 or 129 after Ctrl-C,\n"
    "SIGTERM or SIGHUP.";

// The first argument that the tool does not know, and the option that may have been meant.
inline std::string unknownArgument(const CLI::App& app) {
  const std::vector<std::string> rest = app.remaining();
  const std::string argument = rest.empty() ? "" : rest.front();
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options()) known.push_back(option->get_name());
  const bool is_option = argument.rfind("--", 0) == 0;
  const std::string name = argument.substr(0, argument.find('='));
  return fmt::format("unknown argument '{}'{} (--help lists the options)", argument,
                     is_option ? didYouMean(name, known) : "");
}

// Takes the command line and runs the tool `name`. Its exit status: what `run` returns, 0 after
// help, 2 and one line for a bad argument or file, 128 and the signal's number when interrupted.
template <class Run>
int runTool(const char* name, CLI::App& app, int argc, char** argv, Run&& run) {
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ExtrasError&) {
    fmt::print(stderr, "{}: {}\n", name, unknownArgument(app));
    return 2;
  } catch (const Interruption::Signal& signal) {
    return signal.exitStatus();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 2;
  }
}

}  // namespace pomdp_crowd_nav
