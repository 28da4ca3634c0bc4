// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "io/lines/line_set.h"

#include <string>
#include <vector>

namespace ridgeline::results {

/// Adds warnings of what the values of judged lines give away, each behind the file's path:
///   - coordinates in steps above io::kMaxCoordinateStep_m, unless the lines lie nearer to their
///     planes than rounded ones could (a house that was drawn on whole metres is right). With
///     `strict` this throws IoError instead.
///   - lines with the status out_of_range because of a mark for a missing height, and lines that
///     are judged but lie so far beside their planes that they decide the RMS: heights of another
///     unit or system.
void add_value_warnings(const io::LineSet& set,
                        const evaluate::Evaluation& evaluation,
                        bool strict,
                        std::vector<std::string>& warnings);

}  // namespace ridgeline::results
