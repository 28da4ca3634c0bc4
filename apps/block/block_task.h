// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/block_plan.h"
#include "apps/run/patch_run.h"
#include "io/project/block_file.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace ridgeline::apps {

/// The task of one patch, in a folder of its own:
///   patch.yaml   the patch, as `ridgeline run` takes it
///   ID/, ...     what `ridgeline run patch.yaml --resume` writes
///   done.json    what it was made of, and the hashes of its lines; written last
///   failed.txt   why it failed the last time
class BlockTask {
 public:
  /// `folder`: of the block's results. `options`: of all tasks.
  BlockTask(const std::filesystem::path& folder,
            const PlannedPatch& planned,
            const BlockPlan& plan,
            const RunOptions& options);

  /// Whether the task is finished with these options and this plan, and its lines are still as it
  /// wrote them.
  [[nodiscard]] bool is_done() const;

  /// Reconstructs the lines of the patch. Throws IoError, also for a frame that has changed since
  /// the plan.
  void run(const io::BlockFile& block) const;

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
  [[nodiscard]] std::map<std::string, std::string> hashes_of_lines() const;

  std::filesystem::path folder_;
  const PlannedPatch& planned_;
  const BlockPlan& plan_;
  const RunOptions& options_;
};

}  // namespace ridgeline::apps
