// SPDX-License-Identifier: BSD-3-Clause
#include "apps/run/judge_patch.h"

#include "apps/pipeline/made_from.h"
#include "apps/run/patch_stages.h"
#include "evaluate/files/to_fix.h"
#include "evaluate/files/write_results.h"
#include "evaluate/judge/judge_lines.h"
#include "evaluate/tables/evaluation_json.h"
#include "io/cloud/cloud_files.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"
#include "io/lines/read_lines.h"

#include <fmt/format.h>

#include <utility>

namespace ridgeline::apps {
namespace {

using reconstruct::Method;

std::vector<evaluate::ReferenceLine> read_references(const io::Patch& patch,
                                                     const io::Crs& assume_crs,
                                                     results::RunRecord& record) {
  const io::LineSet set = io::read_lines(*patch.reference_lines, {.assume_crs = assume_crs});
  results::require_same_frame("reference lines and patch", set.path, set.crs, patch.crs);
  record.add_warnings(results::own_warnings(set));
  return results::reference_lines_of(set, patch.frame);
}

/// The lines at the positions at which they were judged.
std::vector<evaluate::JudgedLine> as_judged(std::vector<evaluate::JudgedLine> lines,
                                            const evaluate::Evaluation& evaluation) {
  if (!evaluation.shift || !evaluation.shift->applied) return lines;
  return results::moved(std::move(lines), -evaluation.shift->shift_m);
}

}  // namespace

results::JudgeFilesOptions judge_options(const io::Patch& patch,
                                         const RunOptions& options,
                                         const results::OutputFolder& out,
                                         const std::string& subfolder) {
  results::JudgeFilesOptions judged;
  for (const Method method : options.methods)
    judged.line_paths.push_back(out.path(subfolder + PatchStages::line_file(method)));
  judged.cloud_paths = patch.lidar;
  judged.patch = patch;
  judged.patch_name = patch.id;
  judged.judge = options.parameters.judge;
  judged.summary = options.summary;
  judged.apply_shift = options.shift.apply;
  judged.geoid = options.shift.geoid;
  judged.n_decoys = options.n_decoys;
  judged.completeness = options.completeness;
  return judged;
}

JudgedPatch::JudgedPatch(const io::Patch& patch,
                         const RunOptions& options,
                         const results::OutputFolder& out,
                         results::RunRecord& record)
    : patch_(patch), options_(options), out_(out), record_(record) {
  if (patch_.reference_lines) references_ = read_references(patch, options.assume_crs, record);
}

std::vector<std::string> judged_files(const RunOptions& options) {
  std::vector<std::string> files;
  for (const Method method : options.methods) {
    for (std::string& file : results::evaluation_names(reconstruct::name(method)))
      files.push_back(std::move(file));
  }
  files.emplace_back(results::kToFixName);
  return files;
}

std::string JudgedPatch::key(std::vector<std::string> parts) const {
  parts.push_back(options_.assume_crs.definition);
  parts.push_back(echo(options_.parameters)["judge"].dump());
  if (options_.map_schema == results::MapSchema::kFkb) parts.emplace_back("fkb");
  if (options_.shift.apply) parts.emplace_back("apply shift");
  if (options_.n_decoys) parts.push_back(fmt::format("decoys {}", *options_.n_decoys));
  if (options_.completeness) parts.emplace_back("completeness");
  if (!options_.shift.geoid.empty()) parts.push_back(io::sha256_of_file(options_.shift.geoid));
  parts.push_back(fmt::format("{} {} {} {}", options_.summary.gross_m, options_.summary.sigma_sys_m,
                              options_.summary.bootstrap.replicates,
                              options_.summary.bootstrap.seed));
  if (!patch_.lidar.empty()) {
    for (const std::string& file : io::expand_patterns(patch_.lidar))
      parts.push_back(record_.hash_of(file));
  }
  return key_of(parts);
}

void JudgedPatch::judge() const {
  results::write_judged(patch_.lidar.empty() ? without_lidar() : against_lidar(),
                        options_.map_schema, out_, patch_.id + "/");
}

void JudgedPatch::read(PatchResult& result) const {
  for (const Method method : options_.methods) {
    result.evaluations.push_back(evaluate::parse_evaluation(io::read_text_file(
        out_.path(fmt::format("{}/evaluation.{}.json", patch_.id, reconstruct::name(method))))));
    result.truth.push_back(results::compare_with_truth(
        result.evaluations.back(), as_judged(lines_of(method), result.evaluations.back()),
        references_));
  }
}

results::JudgedFiles JudgedPatch::against_lidar() const {
  results::JudgeFilesOptions options = judge_options(patch_, options_, out_, patch_.id + "/");
  options.cloud.frame = patch_.frame;
  options.cloud.assume_crs = options_.assume_crs;
  options.refuse_other_places = false;
  results::JudgedFiles judged = results::judge_files(options, record_);
  record_.add_warnings(judged.warnings);
  for (std::size_t i = 0; i < options_.methods.size(); ++i)
    judged.evaluations[i].method = reconstruct::name(options_.methods[i]);
  return judged;
}

results::JudgedFiles JudgedPatch::without_lidar() const {
  const auto nothing = evaluate::PointGrid::build(0, [](std::size_t) { return Eigen::Vector3d(); });
  results::JudgedFiles judged;
  judged.cloud_crs = patch_.crs;
  for (const Method method : options_.methods) {
    evaluate::Evaluation evaluation;
    evaluation.patch = patch_.id;
    evaluation.method = reconstruct::name(method);
    evaluation.origin_m = patch_.frame.origin_m;
    evaluation.options = options_.summary;
    for (auto& result :
         evaluate::judge_lines(nothing, lines_of(method), options_.parameters.judge)) {
      evaluation.lines.push_back(std::move(result.evaluation));
    }
    judged.line_sets.push_back(io::read_lines(line_path(method)));
    judged.evaluations.push_back(evaluate::with_summaries(std::move(evaluation)));
    judged.planes.emplace_back();
  }
  return judged;
}

std::vector<evaluate::JudgedLine> JudgedPatch::lines_of(Method method) const {
  return results::judged_lines_of(io::read_lines(line_path(method)), patch_.frame, patch_);
}

std::string JudgedPatch::line_path(Method method) const {
  return out_.path(patch_.id + "/" + PatchStages::line_file(method));
}

}  // namespace ridgeline::apps
