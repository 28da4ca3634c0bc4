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
/// fig8.METHOD.png, into a folder of results. Nothing but the folder and the data that its run.json
/// names is read, so that a report made later is the same. Returns the path of the report.
/// `page`: texts on top of the page, by name, that take the place of those that the run was given.
/// Throws IoError as read_report_input(), and if a file cannot be written.
std::string write_report(const std::string& folder,
                         const std::optional<evaluate::GateReport>& gates = std::nullopt,
                         const evaluate::Json& page = evaluate::Json::object());

/// Writes the report after a run, as write_report() does, and prints its path. A fault of the
/// report is a warning only, because the results are complete without it. If no report is wanted or
/// it cannot be written, the report of an earlier run is removed: it would show other figures than
/// the tables beside it.
void write_report_of_run(const std::string& folder, bool is_wanted);

}  // namespace ridgeline::apps
