// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/table1.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

/// The results of a run, as read from its folder.
struct ResultFolder {
  std::string name;  ///< as shown to the user
  /// Whether `evaluate` wrote the folder. Its methods are then the judged line files.
  bool is_of_line_files = false;
  std::vector<Evaluation> evaluations;
  Table1 matching;  ///< without rows if the run did not match
  /// File names and hashes of the data that two runs must share to be comparable: images, clouds
  /// and references, but not the judged lines. Files of several patches may have the same name.
  std::set<std::pair<std::string, std::string>> input_hashes;
  std::optional<double> duration_s;
  /// The number of images, by patch, from which the run reconstructed lines, if recorded.
  std::map<std::string, std::size_t> n_views;
  /// SHA-256 of the segments, matches and tracks of each patch, whose rows determine the line
  /// numbers; empty for line files.
  std::map<std::string, std::set<std::string>> id_hashes;
  /// Table2::joint_adjusts_to_faces according to the recorded options; empty if not recorded.
  std::optional<bool> joint_adjusts_to_faces;
};

}  // namespace ridgeline::evaluate
