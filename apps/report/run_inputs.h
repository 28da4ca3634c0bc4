// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/options.h"
#include "evaluate/tables/summary_json.h"
#include "io/cloud/read_cloud.h"
#include "io/lines/read_lines.h"
#include "io/project/patch.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The files that a run has read, as recorded in its run.json.
class RunInputs {
 public:
  /// `run`: the record, or an empty object. Throws IoError naming `file` if it is not the record of
  /// a run.
  RunInputs(const evaluate::Json& run, const std::string& file);

  /// Whether the run judged existing line files (`evaluate`) instead of reconstructing lines.
  [[nodiscard]] bool is_of_files() const { return is_of_files_; }
  [[nodiscard]] std::vector<std::string> paths(const std::string& role) const;
  [[nodiscard]] std::vector<std::string> all_paths() const;
  /// Files, folders and patterns as given on the command line.
  [[nodiscard]] std::vector<std::string> given_paths() const;

  /// Returns `path` if the run did not read it or if its size has not changed since. Throws IoError
  /// if it no longer exists or has changed, because the data shown must be those from which the
  /// figures were computed. For a folder, the recorded files are checked.
  [[nodiscard]] std::string unchanged(const std::string& path) const;

  /// The line file (or folder) given to `evaluate` that the method is named after; empty if there
  /// is none.
  [[nodiscard]] std::string lines_of(const std::string& method) const;
  /// The patch of the run with this id. Throws IoError if it is not found and a patch file has
  /// changed or cannot be read.
  [[nodiscard]] std::optional<io::Patch> patch(const std::string& id) const;
  [[nodiscard]] std::optional<std::string> reference_lines(
      const std::optional<io::Patch>& patch) const;

  /// The options of the run, as far as they are recorded. For true lines (`of_truth`), the columns
  /// of ids and buildings are not set.
  [[nodiscard]] io::ReadLinesOptions lines_options(bool of_truth = false) const;
  [[nodiscard]] io::ReadOptions cloud_options() const;
  /// The options of the judge: the recorded widths for fitting planes, and defaults for the rest.
  [[nodiscard]] evaluate::JudgeOptions judge_options() const;
  [[nodiscard]] double max_aligned_angle_deg() const;
  [[nodiscard]] double max_image_mpx() const { return options_.value("max_image_mpx", 0.0); }

 private:
  struct Input {
    std::string role, path;
    std::uint64_t bytes = 0;
  };
  static void require_unchanged(const Input& input);

  std::vector<Input> inputs_;
  evaluate::Json options_;
  bool is_of_files_ = false;
  /// Unit of the cloud given to `evaluate`; lines without a CRS are in this unit.
  Eigen::Vector3d cloud_unit_m_ = Eigen::Vector3d::Ones();
  Eigen::Vector2d plan_scale_ = Eigen::Vector2d::Ones();
};

}  // namespace ridgeline::apps
