// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_steps.h"
#include "apps/common/shared_options.h"
#include "apps/pipeline/parameters.h"
#include "evaluate/statistics/summary.h"
#include "io/results/judge_files.h"

#include <cstdint>
#include <memory>
#include <string>

namespace ridgeline::apps {

/// What the command line says of a block of lines. The block file says the rest.
struct LinesBlockOptions {
  ParameterArguments parameters;
  evaluate::SummaryOptions summary;
  std::string schema = "plain";  ///< see results::map_schema_named()
  ShiftArguments shift;          ///< `apply` is refused
  std::uint64_t cloud_memory_mib = results::JudgeFilesOptions{}.cloud_memory_mib;
  bool strict = false, salvage = false;
  bool report = true;
  PageFacts page;
};

/// A block of lines to be judged. `block_file` has the key `lines`, see io::read_lines_block(). Its
/// tasks are the cells of a grid that hold lines, and write `out`/tasks/NNNN.judged. merge() writes
/// into `out` what `evaluate` writes for all lines, byte for byte but for times; if results of
/// tasks are missing it writes nothing, as the figures are those of all lines or none. The object
/// serves one thread. Throws IoError for a fault of the block file or of the parameters,
/// std::invalid_argument for an option out of its range and for one that a block does not take.
std::unique_ptr<BlockSteps> make_lines_block(const std::string& block_file,
                                             const std::string& out,
                                             const LinesBlockOptions& options);

}  // namespace ridgeline::apps
