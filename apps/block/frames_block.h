// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "apps/block/estimate.h"
#include "apps/run/patch_run.h"
#include "io/project/block_file.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace ridgeline::apps {

/// A block of frames to be reconstructed and judged, step by step. Each step may run in its own
/// process, on any host with access to the same folders; tasks may run in any order and
/// concurrently. The results are byte-identical in every case.
class FramesBlock {
 public:
  /// `block_file` must have images; results go to the folder `out`. Throws IoError if the file
  /// cannot be read.
  FramesBlock(const std::string& block_file, const std::string& out, RunOptions options);

  /// Writes the plan to the folder of the block. An existing plan for the same inputs is kept; one
  /// for other inputs is an IoError.
  void plan();

  /// The number of tasks. There must be a plan.
  [[nodiscard]] std::size_t n_tasks() const;
  /// The name of a task in messages, 0 <= i < n_tasks().
  [[nodiscard]] std::string name_of(std::size_t i) const;

  /// The expected resources of a task, 0 <= i < n_tasks().
  [[nodiscard]] TaskEstimate estimate_of_task(std::size_t i) const;
  /// The expected resources of the merge. There must be a plan.
  [[nodiscard]] TaskEstimate estimate_of_merge() const;

  /// Runs a task unless its results exist. Throws IoError for invalid inputs and for inputs that
  /// have changed since planning.
  void run_task(std::size_t i);

  /// Merges the results of all tasks. Reports tasks without results; their parts are left out.
  /// @return the number of tasks without results
  std::size_t merge();

 private:
  [[nodiscard]] std::string plan_path() const { return (folder_ / "plan.json").string(); }
  void take_plan();

  std::filesystem::path folder_;
  RunOptions options_;
  const io::BlockFile block_;
  std::optional<BlockPlan> plan_;
};

}  // namespace ridgeline::apps
