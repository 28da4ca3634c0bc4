// SPDX-License-Identifier: BSD-3-Clause
#include "apps/run/patch_run.h"

#include "apps/common/outcome.h"
#include "apps/pipeline/made_from.h"
#include "apps/pipeline/patch_scene.h"
#include "apps/run/patch_stages.h"
#include "evaluate/judge/judge_lines.h"
#include "evaluate/tables/evaluation_json.h"
#include "evaluate/tables/shift_text.h"
#include "io/cloud/cloud_files.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"
#include "io/lines/read_lines.h"
#include "io/results/judge_files.h"
#include "io/results/to_fix.h"
#include "io/results/write_results.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace ridgeline::apps {
namespace {

using reconstruct::Method;

/// One patch on its way through the stages. A stage runs, or is skipped if an earlier run has
/// finished it. The later stages read its files in both cases, so that a resumed run gives the same
/// bytes.
class PatchRun {
 public:
  PatchRun(const CheckedPatch& patch,
           const RunOptions& options,
           const results::OutputFolder& out,
           Progress& progress,
           results::RunRecord& record)
      : patch_(patch.file),
        frame_(patch.frame),
        options_(options),
        parameters_(echo(options.parameters)),
        out_(out),
        progress_(progress),
        record_(record),
        stages_(patch, options, out),
        made_(out.path(patch.file.id), options.resume) {
    if (patch_.reference_lines) references_ = read_references();
  }

  PatchResult run() {
    check_pairs();
    extract();
    match();
    keep_surface();
    result_.matching = stages_.score_matches();
    if (patch_.reference_tracks) result_.tracks = stages_.score_tracks();
    for (const Method method : options_.methods) reconstruct(method);
    evaluate();
    remove_other_methods(options_.methods, out_, patch_.id + "/");
    result_.edges = stages_.edge_facts();
    result_.messages = outcome_messages(stages_.counts(), result_.evaluations);
    std::ranges::move(evaluate::shift_messages(result_.evaluations, options_.shift.apply),
                      std::back_inserter(result_.messages));
    return std::move(result_);
  }

 private:
  /// Runs the stage unless it is done. `files` are the files that it writes, in the patch's folder.
  /// The list is read after the work, which may fill it.
  template <typename Work>
  void stage(const std::string& name,
             const std::string& key,
             const std::vector<std::string>& files,
             const Work& work) {
    progress_.begin(fmt::format("{}: {}", patch_.id, name));
    if (made_.is_done(name, key)) {
      ++result_.n_skipped_stages;
    } else {
      work();
      made_.set_done(name, key, files);
    }
    record_.end_stage(patch_.id + "/" + name);
  }

  /// The key of the images, their cameras and their range of heights.
  [[nodiscard]] std::string views_key() const {
    std::vector<std::string> parts{fmt::format("{}", fmt::join(patch_.height_range_m, " "))};
    for (const io::PatchImage& image : patch_.images)
      parts.push_back(key_of_view(image, record_.hash_of(image.path)));
    return key_of(parts);
  }

  void check_pairs() {
    stage("check pairs",
          key_of({views_key(), parameters_["tracks"].dump(),
                  fmt::format("{}", options_.max_y_parallax_px)}),
          {}, [&] { record_.add_warnings(stages_.check_pairs()); });
  }

  /// All images at once, as they are searched at a common size.
  void extract() {
    std::vector<std::string> parts{parameters_["extract"].dump()};
    for (const io::PatchImage& image : patch_.images) {
      parts.push_back(key_of_picture(image, record_.hash_of(image.path)));
      parts.push_back(own_segments_key(image));
    }
    extract_key_ = key_of(parts);
    stage("extract", extract_key_, stages_.edge_files(),
          [&] { record_.add_warnings(stages_.extract()); });
  }

  /// The segments of another detector, as text; empty if the image has none.
  [[nodiscard]] std::string own_segments_key(const io::PatchImage& image) const {
    if (!image.segments) return "";
    return fmt::format("{} {}", record_.hash_of(*image.segments), patch_.segment_sigma_px);
  }

  void match() {
    std::vector<std::string> parts{views_key(), parameters_["match"].dump(),
                                   parameters_["tracks"].dump(), parameters_["chio"].dump(),
                                   extract_key_};
    for (const auto matcher : options_.parameters.method.matching.matchers) {
      parts.emplace_back(reconstruct::name(matcher));
    }
    match_key_ = key_of(parts);
    std::vector<std::string> files;
    stage("match", match_key_, files, [&] { files = stages_.match(); });
  }

  /// The options of the groups `match`, `chio` and `reconstruct` are in the key, because any of
  /// them may ask for the surface.
  void keep_surface() {
    std::vector<std::string> files;
    stage(kSurfaceStage,
          key_of({match_key_, parameters_["reconstruct"].dump(), patch_.crs.definition}), files,
          [&] { files = stages_.keep_surface(); });
  }

  void reconstruct(Method method) {
    const std::string name = reconstruct::name(method);
    std::vector<std::string> parts{match_key_, name, parameters_["reconstruct"].dump(),
                                   patch_.crs.definition};
    for (const std::string& file : stages_.line_files(method)) parts.push_back(file);
    if (options_.local_origin) parts.emplace_back("local origin");
    lines_keys_.push_back(key_of(parts));
    stage("reconstruct " + name, lines_keys_.back(), stages_.line_files(method),
          [&] { stages_.reconstruct(method); });
  }

  /// All methods are judged in one stage, so that the cloud is read only once.
  void evaluate() {
    std::vector<std::string> files;
    for (const Method method : options_.methods) {
      for (const std::string& file : results::evaluation_names(reconstruct::name(method))) {
        files.push_back(file);
      }
    }
    files.emplace_back(results::kToFixName);
    stage("evaluate", evaluation_key(), files, [&] {
      results::write_judged(patch_.lidar.empty() ? judge_without_lidar() : judge_against_lidar(),
                            options_.map_schema, out_, patch_.id + "/");
    });
    for (const Method method : options_.methods) {
      result_.evaluations.push_back(
          evaluate::parse_evaluation(io::read_text_file(in_folder(evaluation_file(method)))));
      result_.truth.push_back(results::compare_with_truth(
          result_.evaluations.back(), as_judged(lines_of(method), result_.evaluations.back()),
          references_));
    }
  }

  /// The lines at the places where they were judged.
  static std::vector<evaluate::JudgedLine> as_judged(std::vector<evaluate::JudgedLine> lines,
                                                     const evaluate::Evaluation& evaluation) {
    if (!evaluation.shift || !evaluation.shift->applied) return lines;
    return results::moved(std::move(lines), -evaluation.shift->shift_m);
  }

  static std::string evaluation_file(Method method) {
    return fmt::format("evaluation.{}.json", reconstruct::name(method));
  }

  [[nodiscard]] std::string evaluation_key() const {
    std::vector<std::string> parts = lines_keys_;
    parts.push_back(options_.assume_crs.definition);
    parts.push_back(parameters_["judge"].dump());
    if (options_.map_schema == results::MapSchema::kFkb) parts.emplace_back("fkb");
    if (options_.shift.apply) parts.emplace_back("apply shift");
    if (options_.n_decoys) parts.push_back(fmt::format("decoys {}", *options_.n_decoys));
    if (!options_.shift.geoid.empty()) parts.push_back(io::sha256_of_file(options_.shift.geoid));
    parts.push_back(fmt::format("{} {} {} {}", options_.summary.gross_m,
                                options_.summary.sigma_sys_m, options_.summary.bootstrap.replicates,
                                options_.summary.bootstrap.seed));
    if (!patch_.lidar.empty()) {
      for (const std::string& file : io::expand_patterns(patch_.lidar)) {
        parts.push_back(record_.hash_of(file));
      }
    }
    return key_of(parts);
  }

  results::JudgedFiles judge_against_lidar() {
    results::JudgeFilesOptions options;
    for (const Method method : options_.methods) {
      options.line_paths.push_back(in_folder(PatchStages::line_file(method)));
    }
    options.cloud_paths = patch_.lidar;
    options.patch = patch_;
    options.patch_name = patch_.id;
    options.cloud.frame = frame_;
    options.cloud.assume_crs = options_.assume_crs;
    options.judge = options_.parameters.judge;
    options.summary = options_.summary;
    options.apply_shift = options_.shift.apply;
    options.geoid = options_.shift.geoid;
    options.n_decoys = options_.n_decoys;
    options.refuse_other_places = false;
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
      evaluation.origin_m = frame_.origin_m;
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
                                    frame_, patch_);
  }

  [[nodiscard]] std::vector<evaluate::ReferenceLine> read_references() {
    const io::LineSet set =
        io::read_lines(*patch_.reference_lines, {.assume_crs = options_.assume_crs});
    results::refuse_mismatch("reference lines and patch", set.path, set.crs, patch_.crs);
    record_.add_warnings(results::own_warnings(set));
    return results::reference_lines_of(set, frame_);
  }

  [[nodiscard]] std::string in_folder(const std::string& file) const {
    return out_.path(patch_.id + "/" + file);
  }

  const io::PatchFile& patch_;
  const LocalFrame& frame_;
  const RunOptions& options_;
  nlohmann::ordered_json parameters_;  ///< echo of the parameters, by group
  const results::OutputFolder& out_;
  Progress& progress_;
  results::RunRecord& record_;
  PatchStages stages_;
  MadeFrom made_;
  std::string extract_key_;
  std::string match_key_;
  std::vector<std::string> lines_keys_;
  std::optional<std::vector<evaluate::ReferenceLine>> references_;
  PatchResult result_;
};

}  // namespace

void check_run(const CheckedPatch& checked,
               const RunOptions& options,
               const results::OutputFolder& out) {
  PatchStages(checked, options, out).check_outputs();
  const io::PatchFile& patch = checked.file;
  for (const Method method : options.methods) {
    for (const std::string& file : results::evaluation_names(reconstruct::name(method))) {
      (void)out.path(patch.id + "/" + file);
    }
  }
  (void)out.path(patch.id + "/" + results::kToFixName);
  if (patch.lidar.empty()) return;
  io::ReadOptions cloud;
  cloud.assume_crs = options.assume_crs;
  const io::Crs of_cloud = io::CloudFiles(patch.lidar, cloud).crs();
  results::refuse_mismatch("patch and cloud", patch.path, patch.crs, of_cloud);
  check_scale(patch, of_cloud);
}

std::size_t count_steps(const RunOptions& options) { return 5 + options.methods.size(); }

PatchResult run_patch(const CheckedPatch& patch,
                      const RunOptions& options,
                      const results::OutputFolder& out,
                      Progress& progress,
                      results::RunRecord& record) {
  return PatchRun(patch, options, out, progress, record).run();
}

}  // namespace ridgeline::apps
