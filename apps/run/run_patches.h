// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/run/patch_run.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The results of a run of several patches.
struct PatchesResult {
  std::vector<io::Patch> patches;
  evaluate::Table1 table1;
  std::vector<evaluate::Evaluation> evaluations;
  std::vector<std::string> messages;  ///< outcome_messages() of the patches
  std::size_t n_skipped_stages = 0;   ///< finished by an earlier run (--resume)
};

/// Runs the patches one after another and writes their files, the tables over all patches and
/// run.json. Decisions, warnings and progress go to stderr. All patch files are read and checked
/// before the first patch is run. Throws IoError for an invalid file.
PatchesResult write_patches(const std::vector<std::string>& patch_files,
                            const RunOptions& options,
                            const std::string& folder,
                            results::RunRecord& record);

/// Runs the patches with write_patches(), prints Table 1 (if there are reference matches) and Table
/// 2, and writes the report.
void run_patches(const std::string& command,
                 const std::vector<std::string>& patch_files,
                 const RunOptions& options,
                 const std::string& out);

}  // namespace ridgeline::apps
