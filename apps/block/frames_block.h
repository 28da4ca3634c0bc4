// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_steps.h"
#include "apps/run/patch_run.h"

#include <memory>
#include <string>

namespace ridgeline::apps {

/// A block of frames to be reconstructed and judged. `block_file` has images; results go to the
/// folder `out`. Throws IoError if the file cannot be read.
std::unique_ptr<BlockSteps> make_frames_block(const std::string& block_file,
                                              const std::string& out,
                                              const RunOptions& options);

}  // namespace ridgeline::apps
