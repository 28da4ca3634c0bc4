// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/compare/matcher_table.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// Whether the folders come from `run`s that differ in their matchers. Such
/// runs have different lines, which must not be paired by number.
bool have_different_matchers(const std::vector<std::string>& folders);

/// Whether the runs extracted the same segments for each patch that all of them matched.
bool match_same_segments(const std::vector<std::string>& folders);

/// The figures of every patch that all folders have, folder by folder within each patch. Segments
/// are compared by their ids, so all runs must have matched the same segments. Throws IoError for
/// files that are missing or not those of a run.
std::vector<evaluate::MatcherFigures> read_matcher_figures(const std::vector<std::string>& folders);

}  // namespace ridgeline::apps
