// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/output_folder.h"
#include "evaluate/gates/gate.h"
#include "evaluate/tables/summary_json.h"

#include <filesystem>
#include <optional>
#include <string>

namespace ridgeline::apps {

/// Writes the report of a block into its folder: report.html, and pages/PATCH.html for each patch.
/// Only the folder and the LIDAR files named in its run.json are read, so that a report made later
/// is the same. Pages of patches that are not in the block are removed. LIDAR that cannot be read
/// is omitted with a note. `page`: see write_report().
/// @return the path of report.html
/// Throws IoError under the same conditions as read_block_folder() and if a file cannot be written.
std::string write_block_report(const std::filesystem::path& folder,
                               const std::optional<evaluate::GateReport>& gates,
                               const evaluate::Json& page = evaluate::Json::object());

/// Removes the pages that write_block_report() wrote to a folder; other files stay.
void remove_patch_pages(const results::OutputFolder& out, const std::filesystem::path& folder);

}  // namespace ridgeline::apps
