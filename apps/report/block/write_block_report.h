// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/output_folder.h"
#include "evaluate/gates/gate.h"
#include "evaluate/tables/summary_json.h"

#include <filesystem>
#include <optional>
#include <string>

namespace ridgeline::apps {

/// Writes the report of a block into its folder: report.html, and pages/PATCH.html of each patch.
/// Nothing but the folder and the LIDAR that its run.json names is read, so that a report made
/// later is the same. Pages of patches that the block no longer has are removed. LIDAR that cannot
/// be read is left out with a note. `page`: see write_report().
/// @return the path of report.html
/// Throws IoError as read_block_folder(), and if a file cannot be written.
std::string write_block_report(const std::filesystem::path& folder,
                               const std::optional<evaluate::GateReport>& gates,
                               const evaluate::Json& page = evaluate::Json::object());

/// Removes the pages that write_block_report() has left in a folder; pages of somebody else stay.
void remove_patch_pages(const results::OutputFolder& out, const std::filesystem::path& folder);

}  // namespace ridgeline::apps
