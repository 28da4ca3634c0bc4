// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace ridgeline::apps {

enum ExitCode : int {
  kDone = 0,
  kWrongInput = 1,  ///< the user's files, options or usage are at fault
  kInternalError = 2,
  kGateFailed = 3,
};

/// What a subcommand does once its options are parsed; returns an ExitCode.
using Run = std::function<int()>;

/// A row of the table in main.cpp. `add` declares the options on the subcommand and returns what to
/// run; the options live in the returned function.
struct Command {
  const char* name;
  const char* summary;
  const char* examples;  ///< commands that its help ends with
  Run (*add)(CLI::App& subcommand);
};

Run add_demo(CLI::App& subcommand);
Run add_evaluate(CLI::App& subcommand);
Run add_pool(CLI::App& subcommand);
Run add_gate(CLI::App& subcommand);
Run add_compare(CLI::App& subcommand);
Run add_report(CLI::App& subcommand);
Run add_run(CLI::App& subcommand);
Run add_block(CLI::App& subcommand);
Run add_extract(CLI::App& subcommand);
Run add_match(CLI::App& subcommand);
Run add_reconstruct(CLI::App& subcommand);
Run add_patch(CLI::App& subcommand);
Run add_simulate(CLI::App& subcommand);
Run add_info(CLI::App& subcommand);
Run add_config(CLI::App& subcommand);

}  // namespace ridgeline::apps
