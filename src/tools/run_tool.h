// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "interruption.h"

namespace pomdp_crowd_nav {

// Takes the command line and runs the tool `name`. Its exit status: what `run` returns, 0 after
// help, 2 and one line for a bad argument or file, 128 and the signal's number when interrupted.
template <class Run>
int runTool(const char* name, CLI::App& app, int argc, char** argv, Run&& run) {
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const Interruption::Signal& signal) {
    return signal.exitStatus();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 2;
  }
}

}  // namespace pomdp_crowd_nav
