// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/reference_errors.h"

#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// One method on one patch against true lines.
struct ReferenceRow {
  std::string patch, method;
  ReferenceComparison comparison;
};

/// `patch,method,class,n_lines,n_on_reference,rms_m,median_m,q95_m,max_m,gross_share`; a figure
/// that does not exist is an empty field.
std::string reference_errors_to_csv(const std::vector<ReferenceRow>& rows);

/// `patch,method,kind,n_reference_lines,n_reconstructed,share`.
std::string reference_completeness_to_csv(const std::vector<ReferenceRow>& rows);

/// Both tables.
std::string reference_to_markdown(const std::vector<ReferenceRow>& rows);

}  // namespace ridgeline::evaluate
