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

/// What a run left behind, as read back from its folder.
struct ResultFolder {
  std::string name;  ///< as shown to the user
  /// Whether `evaluate` wrote the folder. Its methods are then the line files that were given to be
  /// judged.
  bool is_of_line_files = false;
  std::vector<Evaluation> evaluations;
  Table1 matching;  ///< without rows if the run did not match
  /// File name and hash of the data that two runs must share to be compared: images, clouds and
  /// references, not the judged lines. Files of several patches may have one name.
  std::set<std::pair<std::string, std::string>> input_hashes;
  std::optional<double> duration_s;
  /// The number of images by patch that the run reconstructed lines from, if it recorded that.
  std::map<std::string, std::size_t> n_views;
  /// SHA-256 of the segments, matches and tracks of each patch, whose rows number the lines; empty
  /// for lines of files.
  std::map<std::string, std::set<std::string>> id_hashes;
  /// Table2::joint_adjusts_to_faces by the recorded options; empty if these do not tell.
  std::optional<bool> joint_adjusts_to_faces;
};

}  // namespace ridgeline::evaluate
