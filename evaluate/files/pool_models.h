// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/model_files.h"
#include "evaluate/files/pool_runs.h"

#include <vector>

namespace ridgeline::results {

/// Pools the tables of models that were judged area by area: buildings in the order of their file,
/// sums of the edge kinds. `evaluations`: of all lines, by line file. Throws IoError for a table
/// that does not belong to its run.
ModelTables pooled_models(const std::vector<AreaRun>& runs,
                          const std::vector<evaluate::Evaluation>& evaluations);

}  // namespace ridgeline::results
