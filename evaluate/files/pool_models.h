// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/model_files.h"
#include "evaluate/files/pool_runs.h"

#include <vector>

namespace ridgeline::results {

/// The tables of the models that runs have judged area by area: rows of buildings in the order of
/// their file, kinds added up. `evaluations`: those of all lines, by line file. Throws IoError for
/// a table that is not that of its run.
ModelTables pooled_models(const std::vector<AreaRun>& runs,
                          const std::vector<evaluate::Evaluation>& evaluations);

}  // namespace ridgeline::results
