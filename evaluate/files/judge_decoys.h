// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_batches.h"
#include "evaluate/files/judge_files.h"
#include "evaluate/statistics/evaluation.h"
#include "io/cloud/cloud_files.h"

#include <string>
#include <vector>

namespace ridgeline::results {

/// The decoys (lines moved on purpose) of each file; empty if JudgeFilesOptions::n_decoys is 0.
DecoySets decoys_of(const LineSets& lines, const JudgeFilesOptions& options);

/// Judges the lines with judge_in_batches(), together with their decoys unless
/// JudgeFilesOptions::n_decoys is 0. Throws like judge_in_batches().
JudgedBatches judge_with_decoys(io::CloudFiles& cloud,
                                const LineSets& lines,
                                const JudgeFilesOptions& options);

/// Adds the figures of the decoys, if any, to `evaluation`. `lines`: the lines that it judged.
void add_decoys(const std::vector<evaluate::JudgedDecoy>& decoys,
                const std::vector<evaluate::JudgedLine>& lines,
                evaluate::Evaluation& evaluation);

/// Throws IoError for the file at `path` if its lines fit the cloud no better than elsewhere; warns
/// instead if JudgeFilesOptions::refuse_other_places is off, or if they fit hardly better.
void check_follows_cloud(const evaluate::Evaluation& evaluation,
                         const std::string& path,
                         const JudgeFilesOptions& options,
                         std::vector<std::string>& warnings);

}  // namespace ridgeline::results
