// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/frames_block.h"

#include "apps/block/block_task.h"
#include "apps/block/merge_block.h"
#include "apps/block/plan_block.h"
#include "apps/common/say.h"
#include "apps/report/write_report.h"
#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/files/input_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

/// An error in storing the reason, e.g. on a full disk, is only logged, because the reason matters
/// more.
void keep_failure(const BlockTask& task, const std::string& reason) {
  try {
    task.keep_failure(reason);
  } catch (const io::IoError& error) {
    spdlog::debug("{}", error.what());
  }
}

}  // namespace

FramesBlock::FramesBlock(const std::string& block_file, const std::string& out, RunOptions options)
    : folder_(fs::absolute(out).lexically_normal()),
      options_(std::move(options)),
      block_(read_block(block_file)) {}

void FramesBlock::plan() {
  if (fs::exists(plan_path())) {
    take_plan();
    return;
  }
  plan_ = plan_block(block_, options_.max_image_mpx);
  io::write_file(plan_path(), to_json(*plan_));
  inform_of(block_.decisions);
  warn_of(plan_->warnings);
}

std::size_t FramesBlock::n_tasks() const { return plan_->patches.size(); }

std::string FramesBlock::name_of(std::size_t i) const { return "patch " + plan_->patches.at(i).id; }

TaskEstimate FramesBlock::estimate_of_task(std::size_t i) const {
  const PlannedPatch& patch = plan_->patches.at(i);
  return {patch.estimated_s, patch.estimated_mib};
}

TaskEstimate FramesBlock::estimate_of_merge() const {
  std::uint64_t lidar_bytes = 0;
  for (const FileState& file : plan_->inputs) {
    if (file.role == "cloud") lidar_bytes += file.bytes;
  }
  return apps::estimate_of_merge(n_tasks(), lidar_bytes);
}

void FramesBlock::run_task(std::size_t i) {
  const BlockTask task(folder_, block_, *plan_, plan_->patches.at(i), options_);
  if (task.is_done()) return;
  try {
    task.run();
  } catch (const std::exception& error) {
    keep_failure(task, error.what());
    throw;
  }
}

std::size_t FramesBlock::merge() {
  const std::size_t n_missing = merge_block(block_, *plan_, options_, folder_);
  write_report_of_run(folder_.string(), options_.report);
  return n_missing;
}

/// Reads the existing plan. Throws IoError if it belongs to another block or if its inputs have
/// changed since; the message names the changed file if the plan lists it. Frames are checked by
/// the tasks that use them.
void FramesBlock::take_plan() {
  plan_ = read_block_plan(plan_path());
  if (plan_->block_file != block_.path) {
    throw io::IoError(
        plan_path(),
        fmt::format(
            "is the plan of {}; a folder can only hold one block, choose another with --out",
            plan_->block_file));
  }
  if (plan_->key == key_of_plan(block_, planned_inputs(block_), options_.max_image_mpx)) return;
  for (const FileState& file : plan_->inputs) require_unchanged(file);
  for (const PlannedFrame& frame : plan_->frames) io::require_regular_file(frame.file.path);
  throw io::IoError(plan_path(),
                    "was made from other poses, cameras or files, or by another version of the "
                    "program; remove it to plan again (patches that do not change keep their "
                    "results)");
}

}  // namespace ridgeline::apps
