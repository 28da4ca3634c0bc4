// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/block_task.h"

#include "apps/block/plan_block.h"
#include "apps/pipeline/decide_patch.h"
#include "apps/pipeline/parameters.h"
#include "apps/run/patch_stages.h"
#include "apps/run/run_patches.h"
#include "io/files/atomic_file.h"
#include "io/files/text_file.h"
#include "io/project/write_patch.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

constexpr const char* kStage = "lines";

}  // namespace

BlockTask::BlockTask(const fs::path& folder,
                     const io::BlockFile& block,
                     const BlockPlan& plan,
                     const PlannedPatch& planned,
                     const RunOptions& options)
    : folder_(folder / "tasks" / planned.id),
      planned_(planned),
      options_(options),
      patch_(patch_of(block, plan, planned)) {
  for (const std::string& id : planned.images)
    frames_.push_back(std::ranges::find(plan.frames, id, &PlannedFrame::id)->file);
}

/// A new plan for the same block does not change the keys of patches that it leaves unchanged.
std::string BlockTask::key() const {
  std::vector<std::string> parts{
      patch_.id, patch_.crs.definition, echo(options_.parameters).dump(),
      fmt::format("{} {} {}", options_.max_image_mpx, options_.max_y_parallax_px,
                  fmt::join(*patch_.height_range_m, " "))};
  for (const Eigen::Vector2d& corner : patch_.area_m)
    parts.push_back(fmt::format("{} {}", corner.x(), corner.y()));
  for (const reconstruct::Method method : options_.methods)
    parts.emplace_back(reconstruct::name(method));
  parts.emplace_back(reconstruct::name(options_.parameters.method.matching.matcher));
  for (std::size_t i = 0; i < frames_.size(); ++i)
    parts.push_back(key_of_view(patch_.images[i], frames_[i].sha256));
  return key_of(parts);
}

std::vector<std::string> BlockTask::line_files() const {
  return transformed(options_.methods, [&](reconstruct::Method method) {
    return patch_.id + "/" + PatchStages::line_file(method);
  });
}

std::string BlockTask::lines_path(reconstruct::Method method) const {
  return path(patch_.id + "/" + PatchStages::line_file(method));
}

bool BlockTask::is_done() const {
  return MadeFrom(folder_).is_done(kStage, key()) && std::ranges::all_of(frames_, is_unchanged);
}

void BlockTask::run() const {
  RunOptions options = options_;
  options.resume = true;
  options.report = false;
  options.completeness = false;  // of the merged lines only
  results::RunRecord record("block");
  for (const FileState& frame : frames_) {
    require_unchanged(frame);
    record.know_hash(frame.path, frame.sha256);
  }
  io::PatchFile patch = patch_;
  patch.images = decide_patch(patch_).images;
  io::write_patch(patch_path(), patch);
  (void)write_patches({patch_path()}, options, folder_.string(), record);
  MadeFrom(folder_).set_done(kStage, key(), line_files());
  fs::remove(path("failed.txt"));
}

void BlockTask::keep_failure(const std::string& reason) const {
  io::write_file(path("failed.txt"), reason + "\n");
}

std::string BlockTask::reason() const {
  if (fs::exists(path("failed.txt"))) {
    std::string text = io::read_text_file(path("failed.txt"));
    while (text.ends_with('\n')) text.pop_back();
    return text;
  }
  return fs::exists(path(kStagesFile))
             ? "was run with other options, poses or files, or its lines have changed"
             : "has not been run";
}

}  // namespace ridgeline::apps
