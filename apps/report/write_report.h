// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/gates/gate.h"
#include "evaluate/tables/summary_json.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace ridgeline::apps {

/// Adds `--no-report` to a command that writes results.
void add_report_flag(CLI::App& app, bool& report);

/// Writes report.html and the figures of each patch, fig1.png, fig7.IMAGE.png and
/// fig8.METHOD.png, into a results folder. Only the folder and the data named in its run.json are
/// read, so that a report made later is the same. Returns the path of the report.
/// `page`: texts for the top of the page, by name, which override those given to the run. Throws
/// IoError under the same conditions as read_report_input() and if a file cannot be written.
std::string write_report(const std::string& folder,
                         const std::optional<evaluate::GateReport>& gates = std::nullopt,
                         const evaluate::Json& page = evaluate::Json::object());

/// Writes the report after a run, like write_report(), and prints its path. A failure is only a
/// warning, because the results are complete without the report. If no report is wanted or it
/// cannot be written, the report of an earlier run is removed, because its figures would contradict
/// the new tables.
void write_report_of_run(const std::string& folder, bool is_wanted);

}  // namespace ridgeline::apps
