// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "io/lines/line_set.h"

#include <string>
#include <vector>

namespace ridgeline::results {

/// Adds warnings about suspicious values of judged lines, each prefixed with the file's path:
///   - coordinates in steps above io::kMaxCoordinateStep_m, unless the lines are closer to their
///     planes than rounded lines could be (a house drawn at whole metres may be correct). With
///     `strict` this throws IoError instead.
///   - lines with the status out_of_range because of a no-data height, and judged lines that are so
///     far from their planes that they dominate the RMS, which suggests heights in another unit or
///     system.
void add_value_warnings(const io::LineSet& set,
                        const evaluate::Evaluation& evaluation,
                        bool strict,
                        std::vector<std::string>& warnings);

}  // namespace ridgeline::results
