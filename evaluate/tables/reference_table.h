// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/reference_errors.h"
#include "evaluate/statistics/wireframe.h"

#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// The comparison with true lines for one method on one patch.
struct ReferenceRow {
  std::string patch, method;
  ReferenceComparison comparison;
  std::vector<WireframeScore> wireframe;
};

/// `patch,method,class,n_lines,n_on_reference,rms_m,median_m,q95_m,max_m,gross_share,n_parts,
/// rmse_horizontal_m,rmse_vertical_m,mean_vertical_m,n_tested,median_nees_ratio,
/// nees_beyond_99_9_share`; missing values are left empty.
std::string reference_errors_to_csv(const std::vector<ReferenceRow>& rows);

/// `patch,method,kind,n_reference_lines,n_reconstructed,share`.
std::string reference_completeness_to_csv(const std::vector<ReferenceRow>& rows);

/// `patch,method,what,threshold_m,n_found,n_true,n_matched,precision,recall,f1,mean_offset_m` for
/// edges and corners.
std::string wireframe_to_csv(const std::vector<ReferenceRow>& rows);

/// The tables of errors, completeness and wireframe scores, each with an introductory sentence that
/// explains its figures.
std::string reference_to_markdown(const std::vector<ReferenceRow>& rows);

}  // namespace ridgeline::evaluate
