// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "evaluate/statistics/evaluation.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The outcome of a patch by one method.
struct PatchOutcome {
  std::string reason;  ///< why it has no lines; empty if it was reconstructed
  std::size_t n_lines = 0;
  std::size_t n_evaluated = 0;
  std::optional<double> rms_m, median_m, max_m;
  std::size_t n_reference_lines = 0;
  std::size_t n_reference_found = 0;
};

/// The text of patches.csv: a row for each patch and method with
///   patch, method, x_min_m, y_min_m, x_max_m, y_max_m (its square within the area), n_images,
///   images, low_m, high_m (heights searched), status (done | failed), n_lines, n_evaluated, rms_m,
///   median_m, max_m, n_reference_lines, n_reference_found, reason
std::string patches_csv(const BlockPlan& plan,
                        const std::string& method,
                        const std::vector<PatchOutcome>& outcomes,
                        bool with_header);

}  // namespace ridgeline::apps
