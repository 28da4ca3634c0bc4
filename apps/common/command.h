// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace ridgeline::apps {

enum ExitCode : int {
  kDone = 0,
  kWrongInput = 1,  ///< invalid files, options or usage
  kInternalError = 2,
  kGateFailed = 3,
};

/// The work of a subcommand after its options have been parsed; returns an ExitCode.
using Run = std::function<int()>;

/// A row of the table in main.cpp. `add` declares the options of the subcommand and returns the
/// function to run, which owns the options.
struct Command {
  const char* name;
  const char* summary;
  const char* examples;  ///< example commands at the end of its help
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
Run add_edges(CLI::App& subcommand);
Run add_patch(CLI::App& subcommand);
Run add_simulate(CLI::App& subcommand);
Run add_info(CLI::App& subcommand);
Run add_config(CLI::App& subcommand);

}  // namespace ridgeline::apps
