// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// What a patch came to before its lines were judged.
struct PatchCounts {
  std::string patch;
  bool has_lidar = false;
  std::size_t n_left_segments = 0;
  std::size_t n_matches = 0;
};

/// Sentences for what the tables cannot show or would hide: that no line of the patch was
/// reconstructed or none was judged, and why; how many are unconfirmed; that most lines are far
/// from the LIDAR by every method. Usually there is none. `evaluations` holds one per method, all
/// of that patch.
std::vector<std::string> outcome_messages(const PatchCounts& counts,
                                          std::span<const evaluate::Evaluation> evaluations);

/// A sentence if none of the given lines was judged or some are unconfirmed, else nothing.
/// `evaluations` holds one per file of lines.
std::vector<std::string> judging_messages(const std::string& patch,
                                          std::span<const evaluate::Evaluation> evaluations);

/// Whether any line was judged, so that Table 2 has figures.
bool has_figures(std::span<const evaluate::Evaluation> evaluations);

}  // namespace ridgeline::apps
