// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/standards.h"

#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// The standards blocks of one method on one patch.
struct StandardsRow {
  std::string patch, method;
  std::vector<StandardsBlock> blocks;
};

/// ASPRS, NSSDA and the uncertainty budget by class, then the measures of ISO 19157 of `total`.
std::string standards_to_markdown(const std::vector<StandardsBlock>& blocks);

/// `patch,method,class,iso19157_id,measure,value,unit,n`; missing values are left empty.
std::string measures_to_csv(const std::vector<StandardsRow>& rows);

/// The measures of `total` as DQ_* elements with DQ_QuantitativeResult, in the encoding of ISO/TS
/// 19139:2007.
std::string measures_to_xml(const std::vector<StandardsRow>& rows);

}  // namespace ridgeline::evaluate
