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

/// The files that a run has read, as its run.json records them.
class RunInputs {
 public:
  /// `run`: the record, or an empty object. Throws IoError naming `file` if it is no run's record.
  RunInputs(const evaluate::Json& run, const std::string& file);

  /// Whether the run judged given line files (`evaluate`), instead of making them.
  [[nodiscard]] bool is_of_files() const { return is_of_files_; }
  [[nodiscard]] std::vector<std::string> paths(const std::string& role) const;
  [[nodiscard]] std::vector<std::string> all_paths() const;
  /// Files, folders and patterns as they stood on the command line.
  [[nodiscard]] std::vector<std::string> given_paths() const;

  /// Returns `path` if the run did not read it or its size has not changed since. Throws IoError if
  /// it is gone or has changed, because the data that are shown must be those that the figures were
  /// made from. Of a folder the recorded files are checked.
  [[nodiscard]] std::string unchanged(const std::string& path) const;

  /// The line file (or folder) given to `evaluate` that the method is named after; empty if there
  /// is none.
  [[nodiscard]] std::string lines_of(const std::string& method) const;
  /// The run's patch of this id. Throws IoError if it is not found and a patch file is gone or has
  /// changed.
  [[nodiscard]] std::optional<io::Patch> patch(const std::string& id) const;
  [[nodiscard]] std::optional<std::string> reference_lines(
      const std::optional<io::Patch>& patch) const;

  /// The options that the run had, as far as its record holds them.
  /// Of the judged lines, or of true lines, whose ids and buildings are those of their own file.
  [[nodiscard]] io::ReadLinesOptions lines_options(bool of_truth = false) const;
  [[nodiscard]] io::ReadOptions cloud_options() const;
  /// The options of the judge: the widths that planes are fitted with, and defaults for the rest.
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
  /// Unit of the cloud of `evaluate`: its lines without CRS are in this unit.
  Eigen::Vector3d cloud_unit_m_ = Eigen::Vector3d::Ones();
  Eigen::Vector2d plan_scale_ = Eigen::Vector2d::Ones();
};

}  // namespace ridgeline::apps
