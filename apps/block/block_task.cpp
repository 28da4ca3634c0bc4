// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/block_task.h"

#include "apps/block/plan_block.h"
#include "apps/pipeline/parameters.h"
#include "apps/pipeline/stage_cache.h"
#include "apps/run/patch_stages.h"
#include "apps/run/run_patches.h"
#include "io/files/atomic_file.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"
#include "io/project/write_patch.h"
#include "io/results/version.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace ridgeline::apps {
namespace fs = std::filesystem;

BlockTask::BlockTask(const fs::path& folder,
                     const PlannedPatch& planned,
                     const BlockPlan& plan,
                     const RunOptions& options)
    : folder_(folder / "tasks" / planned.id), planned_(planned), plan_(plan), options_(options) {}

/// A new plan of the same block leaves the key as it is for all patches that it does not change.
std::string BlockTask::key() const {
  std::vector<std::string> parts{
      results::kVersion,
      results::kGitHash,
      planned_.id,
      plan_.crs,
      echo(options_.parameters).dump(),
      fmt::format("{} {}", options_.max_image_mpx, options_.max_y_parallax_px)};
  for (const double x :
       {planned_.area_m.min().x(), planned_.area_m.min().y(), planned_.area_m.max().x(),
        planned_.area_m.max().y(), planned_.height_range_m[0], planned_.height_range_m[1]})
    parts.push_back(fmt::format("{}", x));
  for (const reconstruct::Method method : options_.methods)
    parts.emplace_back(reconstruct::name(method));
  for (const auto matcher : options_.parameters.method.matching.matchers)
    parts.emplace_back(reconstruct::name(matcher));
  for (const std::string& id : planned_.images) {
    const auto frame = std::ranges::find(plan_.frames, id, &PlannedFrame::id);
    parts.push_back(id + " " + frame->file.sha256);
  }
  for (const PlannedFile& file : plan_.inputs) {
    if (file.role == "orientation") parts.push_back(file.sha256);
  }
  return stage_key(parts);
}

std::string BlockTask::lines_path(reconstruct::Method method) const {
  return path(planned_.id + "/" + PatchStages::line_file(method));
}

std::map<std::string, std::string> BlockTask::hashes_of_lines() const {
  std::map<std::string, std::string> hashes;
  for (const reconstruct::Method method : options_.methods)
    hashes[reconstruct::name(method)] = io::sha256_of_file(lines_path(method));
  return hashes;
}

bool BlockTask::is_done() const {
  if (!fs::exists(path("done.json"))) return false;
  try {
    const auto done = nlohmann::json::parse(io::read_text_file(path("done.json")));
    return done.at("key") == key() && done.at("lines") == nlohmann::json(hashes_of_lines());
  } catch (const std::exception&) {  // a file cut short or gone: the task runs again
    return false;
  }
}

void BlockTask::run(const io::BlockFile& block) const {
  const io::PatchFile patch = patch_of(block, plan_, planned_);
  RunOptions options = options_;
  options.resume = true;
  options.report = false;
  results::RunRecord record("block");
  for (const std::string& id : planned_.images) {
    const PlannedFrame& frame = *std::ranges::find(plan_.frames, id, &PlannedFrame::id);
    check_unchanged(frame.file);
    record.know_hash(frame.file.path, frame.file.sha256);
  }
  const Eigen::AlignedBox2d& area = planned_.area_m;
  io::write_patch(
      patch_path(), patch,
      {.area_m = std::array{area.min().x(), area.min().y(), area.max().x(), area.max().y()}});
  (void)write_patches({patch_path()}, options, folder_.string(), record);
  const nlohmann::ordered_json done{{"key", key()}, {"lines", hashes_of_lines()}};
  io::write_file(path("done.json"), done.dump(1) + "\n");
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
  return fs::exists(path("done.json"))
             ? "was run with other options or files, or its lines have changed"
             : "has not been run";
}

}  // namespace ridgeline::apps
