// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/frames_block.h"

#include <string>

namespace ridgeline::apps {

/// Writes the scripts of slurm_job.h to the folder of a planned block and prints how to start them.
/// They call this program with its current arguments except --slurm, with `threads` threads per
/// task. Throws IoError if they cannot be written.
void write_cluster_files(const FramesBlock& block, const std::string& folder, int threads);

}  // namespace ridgeline::apps
