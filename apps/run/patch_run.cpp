// SPDX-License-Identifier: BSD-3-Clause
#include "apps/run/patch_run.h"

#include "apps/common/outcome.h"
#include "apps/pipeline/check_patch.h"
#include "apps/pipeline/made_from.h"
#include "apps/pipeline/patch_scene.h"
#include "apps/run/judge_patch.h"
#include "apps/run/patch_stages.h"
#include "evaluate/tables/shift_text.h"
#include "io/cloud/cloud_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <span>
#include <utility>

namespace ridgeline::apps {
namespace {

/// The stages of a patch in order, with the judgement as the last one.
std::vector<Stage> stages_of(PatchStages& reconstruction,
                             const JudgedPatch& judgement,
                             const RunOptions& options) {
  std::vector<Stage> stages = reconstruction.table();
  std::vector<std::string> keys_of_lines;
  for (const Stage& stage : stages) {
    if (stage.name.starts_with("reconstruct ")) keys_of_lines.push_back(stage.key);
  }
  stages.push_back({kLastStage, judgement.key(std::move(keys_of_lines)), judged_files(options),
                    [&](auto&) { judgement.judge(); }});
  return stages;
}

/// The number of stages up to and including the last one selected by `until`.
std::size_t count_until(const std::vector<Stage>& stages, const std::string& until) {
  const auto last = std::find_if(stages.rbegin(), stages.rend(),
                                 [&](const Stage& stage) { return stage.name.starts_with(until); });
  return static_cast<std::size_t>(stages.rend() - last);
}

/// Runs the stage. Those of its files that exist afterwards are recorded as written.
void work(const Stage& stage, const std::string& folder, MadeFrom& made) {
  std::vector<std::string> files = stage.files;
  stage.work(files);
  std::erase_if(files, [&](const std::string& file) {
    return !std::filesystem::exists(std::filesystem::path(folder) / file);
  });
  made.set_done(stage.name, stage.key, files);
}

}  // namespace

void check_run(const io::Patch& patch,
               const RunOptions& options,
               const results::OutputFolder& out,
               results::RunRecord& record) {
  PatchStages reconstruction(patch, options, out, record);
  std::vector<std::string> files = judged_files(options);
  for (const Stage& stage : reconstruction.table())
    files.insert(files.end(), stage.files.begin(), stage.files.end());
  files.emplace_back(kStagesFile);
  for (const std::string& file : files) (void)out.path(patch.id + "/" + file);
  if (patch.lidar.empty()) return;
  io::ReadOptions cloud;
  cloud.assume_crs = options.assume_crs;
  const io::Crs of_cloud = io::CloudFiles(patch.lidar, cloud).crs();
  results::require_same_frame("patch and cloud", patch.path, patch.crs, of_cloud);
  check_scale(patch, of_cloud);
}

std::size_t count_steps(const RunOptions& options) { return 5 + options.methods.size(); }

PatchResult run_patch(const io::Patch& patch,
                      const RunOptions& options,
                      const results::OutputFolder& out,
                      Progress& progress,
                      results::RunRecord& record) {
  const std::string& id = patch.id;
  PatchStages reconstruction(patch, options, out, record);
  const JudgedPatch judgement(patch, options, out, record);
  MadeFrom made(out.path(id), options.resume);
  PatchResult result;
  const std::vector<Stage> stages = stages_of(reconstruction, judgement, options);
  const std::size_t n = count_until(stages, options.until);
  for (const Stage& stage : std::span(stages).first(n)) {
    progress.begin(fmt::format("{}: {}", id, stage.name));
    if (made.is_done(stage.name, stage.key)) {
      ++result.n_skipped_stages;
    } else {
      work(stage, out.path(id), made);
    }
    record.end_stage(id + "/" + stage.name);
    if (stage.name != kMatchStage) continue;
    result.matching = reconstruction.score_matches();
    result.tracks = reconstruction.score_tracks();
  }
  result.edges = reconstruction.edge_facts();
  for (const Stage& stage : std::span(stages).subspan(n)) {
    if (made.is_done(stage.name, stage.key)) continue;
    for (const std::string& file : stage.files) out.remove(fmt::format("{}/{}", id, file));
  }
  if (n < stages.size()) return result;
  judgement.read(result);
  remove_other_methods(options.methods, out, id + "/");
  result.messages = outcome_messages(reconstruction.counts(), result.evaluations);
  std::ranges::move(evaluate::shift_messages(result.evaluations, options.shift.apply),
                    std::back_inserter(result.messages));
  return result;
}

}  // namespace ridgeline::apps
