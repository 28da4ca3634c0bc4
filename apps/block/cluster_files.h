// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/frames_block.h"

#include <string>

namespace ridgeline::apps {

/// Writes the scripts of slurm_job.h into the folder of a block that is planned, and prints how to
/// start them. They start this program as it was started, but for --slurm, with so many threads a
/// task. Throws IoError if they cannot be written.
void write_cluster_files(const FramesBlock& block, const std::string& folder, int threads);

}  // namespace ridgeline::apps
