// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "apps/run/patch_run.h"
#include "io/project/block_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The task of one patch, in a folder of its own:
///   patch.yaml   the patch, as `ridgeline run` takes it
///   ID/, ...     what `ridgeline run patch.yaml --resume` writes
///   stages.json  what the lines were made from, and their hashes; written last (MadeFrom)
///   failed.txt   why it failed the last time
class BlockTask {
 public:
  /// `folder`: of the block's results. `options`: of all tasks.
  BlockTask(const std::filesystem::path& folder,
            const io::BlockFile& block,
            const BlockPlan& plan,
            const PlannedPatch& planned,
            const RunOptions& options);

  /// Whether the task is finished with these options, this plan and the block's cameras and poses,
  /// its frames are as they were planned, and its lines still as it wrote them.
  [[nodiscard]] bool is_done() const;

  /// Reconstructs the lines of the patch. Throws IoError, also for a frame that has changed since
  /// the plan.
  void run() const;

  /// What the plan says of it.
  [[nodiscard]] const PlannedPatch& planned() const { return planned_; }
  [[nodiscard]] std::string patch_path() const { return path("patch.yaml"); }
  /// The lines of a method. The task must be done.
  [[nodiscard]] std::string lines_path(reconstruct::Method method) const;
  /// Why there are none: the reason of the last failure, or that it has not run with these options.
  [[nodiscard]] std::string reason() const;
  /// Keeps the reason of a failure for reason().
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
