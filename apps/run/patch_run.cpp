// SPDX-License-Identifier: BSD-3-Clause
#include "apps/run/patch_run.h"

#include "apps/common/outcome.h"
#include "apps/common/stage_cache.h"
#include "apps/common/surface_file.h"
#include "apps/run/patch_stages.h"
#include "evaluate/judge/judge_lines.h"
#include "evaluate/tables/evaluation_json.h"
#include "io/cloud/cloud_files.h"
#include "io/lines/read_lines.h"
#include "io/results/judge_files.h"
#include "io/results/write_results.h"
#include "io/sha256.h"
#include "io/text_file.h"

#include <fmt/core.h>

#include <filesystem>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

using reconstruct::Method;

/// One patch on its way through the stages. Each stage either runs or, being done, leaves its files
/// to be read; what comes after reads files in both cases, so that a resumed run gives the same
/// bytes.
class PatchRun {
 public:
  PatchRun(const io::PatchFile& patch,
           const RunOptions& options,
           const results::OutputFolder& out,
           Progress& progress,
           results::RunRecord& record)
      : patch_(patch),
        options_(options),
        parameters_(echo(options.parameters)),
        out_(out),
        progress_(progress),
        record_(record),
        stages_(patch, options, out),
        cache_(out.path(patch.id), options.resume) {
    patch_key_ = stage_key({io::sha256_of_file(patch.path), options.assume_crs.definition});
    if (patch_.reference_lines) references_ = read_references();
  }

  PatchResult run() {
    extract();
    keep_surface();
    match();
    result_.matching = stages_.score_matches();
    for (const Method method : options_.methods) reconstruct(method);
    evaluate();
    result_.messages = outcome_messages(stages_.counts(), result_.evaluations);
    return std::move(result_);
  }

 private:
  /// Runs the stage unless it is done. `files` are those that it writes, in the patch's folder; they may
  /// be known after the work only.
  template <typename Work>
  void stage(const std::string& name,
             const std::string& key,
             const std::vector<std::string>& files,
             const Work& work) {
    progress_.begin(fmt::format("{}: {}", patch_.id, name));
    if (cache_.is_done(name, key)) {
      ++result_.n_skipped_stages;
    } else {
      work();
      cache_.set_done(name, key, files);
    }
    record_.end_stage(patch_.id + "/" + name);
  }

  void extract() {
    std::vector<std::string> parts{patch_key_, parameters_["extract"].dump(),
                                   fmt::format("{}", options_.max_y_parallax_px)};
    for (std::size_t i = 0; i < 2; ++i) {
      parts.push_back(io::sha256_of_file(patch_.images[i].path));
    }
    extract_key_ = stage_key(parts);
    stage("extract", extract_key_, stages_.segment_files(), [&] { stages_.extract(); });
  }

  /// Any option of these groups may ask for the surface.
  void keep_surface() {
    std::vector<std::string> files;
    stage(kSurfaceStage,
          stage_key({extract_key_, parameters_["match"].dump(), parameters_["reconstruct"].dump()}),
          files, [&] { files = stages_.keep_surface(); });
  }

  void match() {
    std::vector<std::string> parts{extract_key_, parameters_["match"].dump(),
                                   parameters_["chio"].dump()};
    for (const auto matcher : options_.parameters.method.matching.matchers) {
      parts.emplace_back(reconstruct::name(matcher));
    }
    match_key_ = stage_key(parts);
    stage("match", match_key_, stages_.match_files(), [&] {
      stages_.match();
      cache_.set_done("extract", extract_key_, stages_.segment_files());  // guided ones joined them
    });
  }

  void reconstruct(Method method) {
    const std::string name = reconstruct::name(method);
    std::vector<std::string> parts{match_key_, name, parameters_["reconstruct"].dump()};
    for (const std::string& file : stages_.line_files(method)) parts.push_back(file);
    if (options_.local_origin) parts.emplace_back("local origin");
    lines_keys_.push_back(stage_key(parts));
    stage("reconstruct " + name, lines_keys_.back(), stages_.line_files(method),
          [&] { stages_.reconstruct(method); });
  }

  /// All methods at once: the cloud is read once.
  void evaluate() {
    std::vector<std::string> files;
    for (const Method method : options_.methods) {
      for (const std::string& file : results::evaluation_names(reconstruct::name(method))) {
        files.push_back(file);
      }
    }
    stage("evaluate", evaluation_key(), files, [&] {
      results::write_judged(patch_.lidar.empty() ? judge_without_lidar() : judge_against_lidar(),
                            options_.map_schema, out_, patch_.id + "/");
    });
    for (const Method method : options_.methods) {
      result_.evaluations.push_back(
          evaluate::parse_evaluation(io::read_text_file(in_folder(evaluation_file(method)))));
      result_.truth.push_back(
          results::compare_with_truth(result_.evaluations.back(), lines_of(method), references_));
    }
  }

  static std::string evaluation_file(Method method) {
    return fmt::format("evaluation.{}.json", reconstruct::name(method));
  }

  [[nodiscard]] std::string evaluation_key() const {
    std::vector<std::string> parts = lines_keys_;
    parts.push_back(parameters_["judge"].dump());
    if (options_.map_schema == results::MapSchema::kFkb) parts.emplace_back("fkb");
    parts.push_back(fmt::format("{} {} {} {}", options_.summary.gross_m,
                                options_.summary.sigma_sys_m, options_.summary.bootstrap.replicates,
                                options_.summary.bootstrap.seed));
    if (!patch_.lidar.empty()) {
      for (const std::string& file : io::expand_patterns(patch_.lidar)) {
        parts.push_back(io::sha256_of_file(file));
      }
    }
    return stage_key(parts);
  }

  results::JudgedFiles judge_against_lidar() {
    results::JudgeFilesOptions options;
    for (const Method method : options_.methods) {
      options.line_paths.push_back(in_folder(PatchStages::line_file(method)));
    }
    options.cloud_paths = patch_.lidar;
    options.patch = patch_;
    options.patch_name = patch_.id;
    options.cloud.frame = stages_.frame();
    options.cloud.assume_crs = options_.assume_crs;
    options.judge = options_.parameters.judge;
    options.summary = options_.summary;
    results::JudgedFiles judged = results::judge_files(options, record_);
    record_.add_warnings(judged.warnings);
    for (std::size_t i = 0; i < options_.methods.size(); ++i) {
      judged.evaluations[i].method = reconstruct::name(options_.methods[i]);
    }
    return judged;
  }

  /// Every line gets the status `no_lidar`.
  [[nodiscard]] results::JudgedFiles judge_without_lidar() const {
    const auto nothing =
        evaluate::PointGrid::build(0, [](std::size_t) { return Eigen::Vector3d(); });
    results::JudgedFiles judged;
    judged.cloud_crs = patch_.crs;
    for (const Method method : options_.methods) {
      evaluate::Evaluation evaluation;
      evaluation.patch = patch_.id;
      evaluation.method = reconstruct::name(method);
      evaluation.origin_m = stages_.frame().origin_m;
      evaluation.options = options_.summary;
      for (auto& result :
           evaluate::judge_lines(nothing, lines_of(method), options_.parameters.judge)) {
        evaluation.lines.push_back(std::move(result.evaluation));
      }
      judged.line_sets.push_back(io::read_lines(in_folder(PatchStages::line_file(method))));
      judged.evaluations.push_back(evaluate::with_summaries(std::move(evaluation)));
      judged.planes.emplace_back();
    }
    return judged;
  }

  [[nodiscard]] std::vector<evaluate::JudgedLine> lines_of(Method method) const {
    return results::judged_lines_of(io::read_lines(in_folder(PatchStages::line_file(method))),
                                    stages_.frame(), patch_);
  }

  [[nodiscard]] std::vector<evaluate::ReferenceLine> read_references() {
    const io::LineSet set =
        io::read_lines(*patch_.reference_lines, {.assume_crs = options_.assume_crs});
    results::refuse_mismatch("reference lines and patch", set.path, set.crs, patch_.crs);
    record_.add_warnings(results::own_warnings(set));
    return results::reference_lines_of(set, stages_.frame());
  }

  [[nodiscard]] std::string in_folder(const std::string& file) const {
    return out_.path(patch_.id + "/" + file);
  }

  const io::PatchFile& patch_;
  const RunOptions& options_;
  nlohmann::ordered_json parameters_;  ///< by group
  const results::OutputFolder& out_;
  Progress& progress_;
  results::RunRecord& record_;
  PatchStages stages_;
  StageCache cache_;
  std::string patch_key_, extract_key_, match_key_;
  std::vector<std::string> lines_keys_;
  std::optional<std::vector<evaluate::ReferenceLine>> references_;
  PatchResult result_;
};

}  // namespace

void check_run(const io::PatchFile& patch,
               const RunOptions& options,
               const results::OutputFolder& out) {
  PatchStages(patch, options, out).check_outputs();
  for (const Method method : options.methods) {
    for (const std::string& file : results::evaluation_names(reconstruct::name(method))) {
      (void)out.path(patch.id + "/" + file);
    }
  }
  if (patch.lidar.empty()) return;
  io::ReadOptions cloud;
  cloud.assume_crs = options.assume_crs;
  const io::Crs of_cloud = io::CloudFiles(patch.lidar, cloud).crs();
  results::refuse_mismatch("patch and cloud", patch.path, patch.crs, of_cloud);
  check_scale(patch, of_cloud);
}

std::size_t count_steps(const RunOptions& options) { return 4 + options.methods.size(); }

PatchResult run_patch(const io::PatchFile& patch,
                      const RunOptions& options,
                      const results::OutputFolder& out,
                      Progress& progress,
                      results::RunRecord& record) {
  return PatchRun(patch, options, out, progress, record).run();
}

}  // namespace ridgeline::apps
