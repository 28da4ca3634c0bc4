// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// Counts of a patch before its lines are judged.
struct PatchCounts {
  std::string patch;
  bool has_lidar = false;
  std::size_t n_left_segments = 0;
  std::size_t n_matches = 0;
};

/// Messages about problems that the tables do not show: no line of the patch was reconstructed or
/// none was judged, and why; some lines are unconfirmed; most lines are far from the LIDAR with
/// every method. Usually empty. `evaluations`: one per method, all of that patch.
std::vector<std::string> outcome_messages(const PatchCounts& counts,
                                          std::span<const evaluate::Evaluation> evaluations);

/// Messages if none of the given lines was judged or if some are unconfirmed; else empty.
/// `evaluations`: one per line file.
std::vector<std::string> judging_messages(const std::string& patch,
                                          std::span<const evaluate::Evaluation> evaluations);

/// Whether any line was judged, so that Table 2 has figures.
bool has_figures(std::span<const evaluate::Evaluation> evaluations);

}  // namespace ridgeline::apps
