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

/// A block of frames to be reconstructed and judged, step by step. Each step may run in a process
/// of its own, on any host that sees the same folders; tasks in any order and at the same time. The
/// results have the same bytes in every case.
class FramesBlock {
 public:
  /// `block_file` has images; results go to the folder `out`. Throws IoError if the file cannot be
  /// read.
  FramesBlock(const std::string& block_file, const std::string& out, RunOptions options);

  /// Writes the plan into the folder of the block. A plan that stands there and was made of the
  /// same inputs stays; one of other inputs is an IoError.
  void plan();

  /// The number of tasks. There must be a plan.
  [[nodiscard]] std::size_t n_tasks() const;
  /// What messages call a task, 0 <= i < n_tasks().
  [[nodiscard]] std::string name_of(std::size_t i) const;

  /// What a task is expected to need, 0 <= i < n_tasks().
  [[nodiscard]] TaskEstimate estimate_of_task(std::size_t i) const;
  /// What the merge is expected to need. There must be a plan.
  [[nodiscard]] TaskEstimate estimate_of_merge() const;

  /// Does a task unless its results are there. Throws IoError for a fault of its inputs, also if
  /// they have changed since the plan.
  void run_task(std::size_t i);

  /// Merges the results of all tasks. Says which tasks have none; their parts are left out.
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
