// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "apps/run/patch_run.h"
#include "io/project/block_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The task of one patch, in its own folder:
///   patch.yaml   the patch, as input for `ridgeline run`
///   ID/, ...     output of `ridgeline run patch.yaml --resume`
///   stages.json  the inputs of the lines, and their hashes; written last (MadeFrom)
///   failed.txt   reason for the last failure
class BlockTask {
 public:
  /// `folder`: of the block's results. `options`: of all tasks.
  BlockTask(const std::filesystem::path& folder,
            const io::BlockFile& block,
            const BlockPlan& plan,
            const PlannedPatch& planned,
            const RunOptions& options);

  /// Whether the task is finished with these options, this plan and the block's cameras and poses,
  /// and neither its frames have changed since planning nor its lines since they were written.
  [[nodiscard]] bool is_done() const;

  /// Reconstructs the lines of the patch. Throws IoError, also for a frame that has changed since
  /// planning.
  void run() const;

  /// Its entry in the plan.
  [[nodiscard]] const PlannedPatch& planned() const { return planned_; }
  [[nodiscard]] std::string patch_path() const { return path("patch.yaml"); }
  /// The lines of a method. The task must be done.
  [[nodiscard]] std::string lines_path(reconstruct::Method method) const;
  /// Why there are no lines: the reason for the last failure, or that the task has not run with
  /// these options.
  [[nodiscard]] std::string reason() const;
  /// Stores the reason for a failure for reason().
  void keep_failure(const std::string& reason) const;

 private:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::string key() const;
  [[nodiscard]] std::vector<std::string> line_files() const;

  std::filesystem::path folder_;
  const PlannedPatch& planned_;
  const RunOptions& options_;
  std::vector<FileState> frames_;  ///< by image of the patch
  io::PatchFile patch_;            ///< without windows
};

}  // namespace ridgeline::apps
