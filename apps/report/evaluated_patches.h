// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/report_input.h"
#include "apps/report/run_inputs.h"

#include <fmt/core.h>

#include <filesystem>
#include <vector>

namespace ridgeline::apps {

/// Runs `read`. Any exception becomes a note, because the rest of the report does not depend on it.
template <typename Read>
void read_or_note(ReportPatch& patch, const char* what, const Read& read) {
  try {
    read();
  } catch (const std::exception& error) {
    patch.notes.push_back(fmt::format("{}: {}", what, error.what()));
  }
}

/// Reads the patches and methods of results::read_evaluations(), with their lines, in the order of
/// the folder's table2.json.
std::vector<ReportPatch> read_evaluated_patches(const std::filesystem::path& folder,
                                                const RunInputs& inputs);

}  // namespace ridgeline::apps
