// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/compare/matcher_table.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// Whether the folders come from `run`s with different matchers. Such runs have different lines,
/// which must not be paired by number.
bool have_different_matchers(const std::vector<std::string>& folders);

/// Whether the runs extracted the same segments for every patch that they all matched.
bool match_same_segments(const std::vector<std::string>& folders);

/// The figures of every patch present in all folders, by patch, then by folder. Matches are
/// compared by segment ids, so all runs must have matched the same segments. Throws IoError for
/// files that are missing or do not come from a run.
std::vector<evaluate::MatcherFigures> read_matcher_figures(const std::vector<std::string>& folders);

}  // namespace ridgeline::apps
