// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/merge_block.h"

#include "apps/block/block_task.h"
#include "apps/block/merged_lines.h"
#include "apps/block/patch_table.h"
#include "apps/common/outcome.h"
#include "apps/common/say.h"
#include "apps/run/judge_patch.h"
#include "apps/run/patch_stages.h"
#include "evaluate/files/judge_files.h"
#include "evaluate/files/write_results.h"
#include "evaluate/judge/plan_hull.h"
#include "evaluate/tables/completeness_table.h"
#include "evaluate/tables/shift_text.h"
#include "evaluate/tables/table2.h"
#include "evaluate/tables/terminal_table.h"
#include "io/lines/read_lines.h"
#include "io/lines/write_lines.h"
#include "reconstruct/geometry/plan_box.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

using evaluate::Evaluation;
using reconstruct::GridCell;
using reconstruct::Method;

/// The judged lines of the block by one method, with the results of each patch.
struct MethodResult {
  Evaluation evaluation;
  results::TruthRows truth;
  std::vector<Evaluation> by_patch;  ///< only patches with lines
  std::vector<results::TruthRows> truth_by_patch;
  std::vector<PatchOutcome> outcomes;  ///< of all patches
};

class BlockMerge {
 public:
  BlockMerge(const io::BlockFile& block,
             const BlockPlan& plan,
             const RunOptions& options,
             const fs::path& folder)
      : block_(block),
        plan_(plan),
        options_(options),
        folder_(folder),
        record_("block"),
        out_(folder, inputs()) {
    for (const PlannedPatch& patch : plan.patches)
      tasks_.emplace_back(folder, block, plan, patch, options);
  }

  std::size_t run() {
    check_outputs();
    find_finished();
    if (n_finished_ > 0) {
      write_results();
      remove_other_methods(options_.methods, out_, "");
    }
    write_patches_csv();
    write_record();
    return plan_.patches.size() - n_finished_;
  }

 private:
  [[nodiscard]] std::vector<std::string> inputs() const {
    std::vector<std::string> paths = transformed(plan_.inputs, &FileState::path);
    for (const PlannedFrame& frame : plan_.frames) paths.push_back(frame.file.path);
    return paths;
  }

  /// Throws IoError if a result would overwrite a foreign file.
  void check_outputs() const {
    std::vector<std::string> names = results::result_names({});
    names.emplace_back("patches.csv");
    for (const Method method : options_.methods) {
      for (const char* ending : {".geojson", ".gpkg"})
        names.push_back(PatchStages::line_file(method, ending));
      for (std::string& name : results::evaluation_names(reconstruct::name(method)))
        names.push_back(std::move(name));
    }
    for (const std::string& name : names) (void)out_.path(name);
  }

  void write_results() {
    for (const Method method : options_.methods) write_lines(method);
    record_.end_stage("merge");
    if (!block_.lidar.empty()) judge();
  }

  void find_finished() {
    reasons_.resize(tasks_.size());
    tbb::parallel_for(std::size_t{0}, tasks_.size(), [&](std::size_t i) {
      if (!tasks_[i].is_done()) reasons_[i] = tasks_[i].reason();
    });
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      if (reasons_[i].empty()) {
        ++n_finished_;
        continue;
      }
      const std::string warning =
          fmt::format("patch {} has no lines: {}", plan_.patches[i].id, reasons_[i]);
      warn_of({warning});
      record_.add_warnings({warning});
    }
  }

  void write_lines(Method method) {
    std::vector<const BlockTask*> finished;
    for (std::size_t i = 0; i < tasks_.size(); ++i)
      if (reasons_[i].empty()) finished.push_back(&tasks_[i]);
    std::vector<std::unique_ptr<io::LineWriter>> writers;
    for (const auto& [format, extension] : {std::pair(io::LineFormat::kGeoJson, ".geojson"),
                                            std::pair(io::LineFormat::kGeoPackage, ".gpkg")}) {
      writers.push_back(io::line_writer(out_.path(PatchStages::line_file(method, extension)),
                                        {plan_.crs}, format));
    }
    std::vector<std::size_t>& patch_of_line = patch_of_line_.emplace_back();
    const MergedCounts counts =
        merge_lines_of(plan_, finished, method, [&](const io::Line& line, std::size_t patch) {
          for (const auto& writer : writers) writer->add(line);
          patch_of_line.push_back(patch);
        });
    for (const auto& writer : writers) writer->commit();
    say("{}: {} lines, merged from {} lines of {} overlapping patches\n", reconstruct::name(method),
        patch_of_line.size(), counts.n_found, finished.size());
    record_.set(fmt::format("lines_{}", reconstruct::name(method)),
                {{"n_found", counts.n_found},
                 {"n_without_place", counts.n_without_place},
                 {"n_merged", patch_of_line.size()}});
  }

  /// The frames of the block as a patch, so that the image segments of the lines serve as evidence.
  [[nodiscard]] io::Patch frames_as_patch() const {
    io::Patch patch{static_cast<const io::Project&>(block_)};
    patch.id = plan_.block;
    patch.height_range_m = plan_.patches.front().height_range_m;
    for (const PlannedPatch& planned : plan_.patches) {
      patch.height_range_m[0] = std::min(patch.height_range_m[0], planned.height_range_m[0]);
      patch.height_range_m[1] = std::max(patch.height_range_m[1], planned.height_range_m[1]);
    }
    return patch;
  }

  /// The convex hull of the squares that have a patch.
  [[nodiscard]] std::vector<Eigen::Vector2d> hull_of_squares() const {
    std::vector<Eigen::Vector2d> corners;
    for (const PlannedPatch& patch : plan_.patches)
      std::ranges::copy(corners_of(patch.core_m), std::back_inserter(corners));
    return evaluate::convex_hull(std::move(corners));
  }

  void judge() {
    results::JudgeFilesOptions options = judge_options(frames_as_patch(), options_, out_, "");
    options.reference_lines = block_.reference_lines;
    options.block_area_m = plan_.area_m.empty() ? hull_of_squares() : plan_.area_m;
    results::JudgedFiles judged = results::judge_files(options, record_);
    warn_of(judged.warnings);
    record_.add_warnings(judged.warnings);
    for (std::size_t i = 0; i < options_.methods.size(); ++i)
      set_method(reconstruct::name(options_.methods[i]), judged.evaluations[i], judged.truth[i]);
    results::write_judged(judged, options_.map_schema, out_, "");
    for (std::size_t i = 0; i < options_.methods.size(); ++i)
      results_.push_back(split(judged, i, options.patch));
    write_all_tables();
  }

  /// The judge names a method after the file of its lines.
  static void set_method(const std::string& name,
                         Evaluation& evaluation,
                         results::TruthRows& truth) {
    evaluation.method = name;
    for (evaluate::ToleranceRow& row : truth.tolerances) row.method = name;
    for (evaluate::ReferenceRow& row : truth.references) row.method = name;
  }

  /// Splits the results by patch. Reference lines are also compared with the lines of neighbouring
  /// patches, to which lines that cross a seam may belong.
  MethodResult split(const results::JudgedFiles& judged,
                     std::size_t method,
                     const std::optional<io::Patch>& frames) const {
    MethodResult result{judged.evaluations[method], judged.truth[method], {}, {}, {}};
    const std::vector<evaluate::JudgedLine> lines =
        results::judged_lines_of(judged.line_sets[method], judged.frame, frames);
    const auto references = references_by_patch(judged.frame);
    std::vector<std::vector<std::size_t>> members(plan_.patches.size());
    for (std::size_t i = 0; i < lines.size(); ++i) members[patch_of_line_[method][i]].push_back(i);
    std::vector<Evaluation> evaluations(plan_.patches.size());
    std::vector<results::TruthRows> truth(plan_.patches.size());
    result.outcomes.resize(plan_.patches.size());
    tbb::parallel_for(std::size_t{0}, plan_.patches.size(), [&](std::size_t i) {
      evaluations[i] = of_patch(result.evaluation, plan_.patches[i].id, members[i]);
      std::vector<evaluate::JudgedLine> own;
      for (const std::size_t k : members[i]) own.push_back(lines[k]);
      truth[i] = results::compare_with_truth(evaluations[i], own, std::nullopt);
      result.outcomes[i] = outcome_of(i, evaluations[i]);
      const auto found = references.find(plan_.patches[i].cell);
      if (found == references.end()) return;
      for (const std::size_t j : neighbours_of(i)) {
        for (const std::size_t k : members[j]) own.push_back(lines[k]);
      }
      const evaluate::ReferenceCompleteness all =
          evaluate::compare_with_references(own, found->second).completeness.back();
      result.outcomes[i].n_reference_lines = all.n_lines;
      result.outcomes[i].n_reference_found = all.n_reconstructed;
    });
    for (std::size_t i = 0; i < plan_.patches.size(); ++i) {
      if (members[i].empty()) continue;
      result.by_patch.push_back(std::move(evaluations[i]));
      result.truth_by_patch.push_back(std::move(truth[i]));
    }
    return result;
  }

  static Evaluation of_patch(const Evaluation& block,
                             const std::string& id,
                             const std::vector<std::size_t>& members) {
    Evaluation evaluation;
    evaluation.patch = id;
    evaluation.method = block.method;
    evaluation.origin_m = block.origin_m;
    evaluation.options = block.options;
    for (const std::size_t i : members) evaluation.lines.push_back(block.lines[i]);
    return evaluate::with_summaries(std::move(evaluation));
  }

  [[nodiscard]] PatchOutcome outcome_of(std::size_t i, const Evaluation& evaluation) const {
    PatchOutcome outcome;
    outcome.reason = reasons_[i];
    const evaluate::Summary* total = evaluate::find_class(evaluation.classes, evaluate::kTotal);
    if (total == nullptr) return outcome;
    outcome.n_lines = total->n_lines;
    outcome.n_evaluated = total->n_evaluated;
    outcome.rms_m = total->rms_m;
    outcome.median_m = total->median_m;
    outcome.max_m = total->max_m;
    return outcome;
  }

  [[nodiscard]] std::vector<std::size_t> neighbours_of(std::size_t i) const {
    std::vector<std::size_t> neighbours;
    const GridCell& cell = plan_.patches[i].cell;
    for (std::int64_t column = cell.column - 1; column <= cell.column + 1; ++column) {
      for (std::int64_t row = cell.row - 1; row <= cell.row + 1; ++row) {
        const GridCell other{column, row};
        const auto patch = std::ranges::lower_bound(plan_.patches, other, {}, &PlannedPatch::cell);
        if (other == cell || patch == plan_.patches.end() || patch->cell != other) continue;
        neighbours.push_back(static_cast<std::size_t>(patch - plan_.patches.begin()));
      }
    }
    return neighbours;
  }

  [[nodiscard]] std::map<GridCell, std::vector<evaluate::ReferenceLine>> references_by_patch(
      const LocalFrame& frame) const {
    std::map<GridCell, std::vector<evaluate::ReferenceLine>> by_patch;
    if (!block_.reference_lines) return by_patch;
    const reconstruct::PatchGrid grid = grid_of(plan_);
    for (const evaluate::ReferenceLine& line :
         results::reference_lines_of(io::read_lines(*block_.reference_lines), frame)) {
      const Eigen::Vector3d middle = frame.world_from_local(midpoint(line.segment));
      by_patch[grid.cell_of(middle.head<2>())].push_back(line);
    }
    return by_patch;
  }

  /// Writes the tables with rows grouped by patch, those of the block first.
  void write_all_tables() const {
    std::vector<Evaluation> evaluations;
    std::vector<results::TruthRows> truth;
    for (const MethodResult& result : results_) {
      evaluations.push_back(result.evaluation);
      truth.push_back(result.truth);
    }
    const std::vector<Evaluation> of_block = evaluations;
    for (const MethodResult& result : results_) {
      evaluations.insert(evaluations.end(), result.by_patch.begin(), result.by_patch.end());
      truth.insert(truth.end(), result.truth_by_patch.begin(), result.truth_by_patch.end());
    }
    const bool adjusts_to_faces = options_.parameters.method.estimation.beyond.adjusts_to_faces();
    results::write_tables(evaluations, truth, out_, adjusts_to_faces);
    if (has_figures(of_block))
      say("{}\n", evaluate::to_terminal(evaluate::make_table2(of_block, adjusts_to_faces)));
    if (const std::string found = evaluate::completeness_to_terminal(of_block); !found.empty())
      say("{}\n", found);
    std::vector<std::string> messages = judging_messages(plan_.block, of_block);
    std::ranges::move(evaluate::shift_messages(of_block, options_.shift.apply),
                      std::back_inserter(messages));
    for (const std::string& message : messages) say("{}\n", message);
  }

  void write_patches_csv() {
    std::string text;
    for (std::size_t m = 0; m < options_.methods.size(); ++m) {
      std::vector<PatchOutcome> outcomes(plan_.patches.size());
      if (m < results_.size()) {
        outcomes = results_[m].outcomes;
      } else {
        for (std::size_t i = 0; i < outcomes.size(); ++i) outcomes[i].reason = reasons_[i];
        if (m < patch_of_line_.size())
          for (const std::size_t patch : patch_of_line_[m]) ++outcomes[patch].n_lines;
      }
      text += patches_csv(plan_, reconstruct::name(options_.methods[m]), outcomes, m == 0);
    }
    out_.write("patches.csv", text);
  }

  void write_record() {
    record_.set("page", to_json(options_.page));
    for (const FileState& file : plan_.inputs) record_.add_input({file.role, file.path});
    for (const PlannedFrame& frame : plan_.frames) {
      record_.know_hash(frame.file.path, frame.file.sha256);
      record_.add_input({frame.file.role, frame.file.path});
    }
    record_.end_stage("write");
    out_.write_record(record_.to_json());
  }

  const io::BlockFile& block_;
  const BlockPlan& plan_;
  const RunOptions& options_;
  fs::path folder_;
  results::RunRecord record_;
  results::OutputFolder out_;
  std::vector<BlockTask> tasks_;
  std::vector<std::string> reasons_;  ///< why a task has no lines; empty if it has
  std::size_t n_finished_ = 0;
  std::vector<std::vector<std::size_t>> patch_of_line_;  ///< of each method
  std::vector<MethodResult> results_;  ///< of each method, if the lines are judged
};

}  // namespace

std::size_t merge_block(const io::BlockFile& block,
                        const BlockPlan& plan,
                        const RunOptions& options,
                        const fs::path& folder) {
  return BlockMerge(block, plan, options, folder).run();
}

}  // namespace ridgeline::apps
