// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/tolerance_measures.h"

#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::evaluate {

/// Length-weighted measures of one method against one reference.
struct ToleranceRow {
  std::string patch, method;
  std::string reference;  ///< planes | lines
  ToleranceMeasures measures;
};

/// `patch,method,reference,tolerance_m,precision,completeness,f_score,redundancy,limap_r_m,
/// limap_p_percent`; missing values are left empty.
std::string tolerances_to_csv(const std::vector<ToleranceRow>& rows);
std::string tolerances_to_markdown(const std::vector<ToleranceRow>& rows);

}  // namespace ridgeline::evaluate
