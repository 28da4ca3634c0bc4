// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/summary_json.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::results {

/// Throws IoError for a file that is no JSON object.
evaluate::Json read_json_object(const std::filesystem::path& file);

/// An evaluation.METHOD.json.
struct EvaluationFile {
  std::filesystem::path path;
  std::string subfolder;  ///< "", or "PATCH/" where `run` has written it
};

/// What the last run into a folder has evaluated, in the order of its table2.json. Evaluations that
/// the table does not name are of earlier runs and do not count; without a table all do.
class EvaluatedMethods {
 public:
  using PatchAndMethod = std::pair<std::string, std::string>;

  /// `of_files`: by `evaluate`, which writes into the folder, not into a subfolder for each patch.
  /// Throws IoError for a table2.json that is none.
  EvaluatedMethods(std::filesystem::path folder, bool of_files);

  /// Those that may be of the run by where they lie and what they are called, sorted. A file of
  /// another run may be damaged and need not even be opened.
  [[nodiscard]] std::vector<EvaluationFile> files() const;
  [[nodiscard]] bool contains(const PatchAndMethod& evaluation) const;
  /// Throws IoError naming an evaluation of the table that was not found.
  void check_all_found(const std::set<PatchAndMethod>& found) const;

  /// Places in the table; 0 without a table.
  [[nodiscard]] std::size_t rank(const std::string& patch) const;
  [[nodiscard]] std::size_t rank(const PatchAndMethod& evaluation) const;

 private:
  [[nodiscard]] bool may_hold(const EvaluationFile& file) const;

  std::filesystem::path folder_;
  bool of_files_;
  bool is_known_ = false;
  std::map<std::string, std::size_t> patch_rank_;
  std::map<PatchAndMethod, std::size_t> rank_;
};

}  // namespace ridgeline::results
