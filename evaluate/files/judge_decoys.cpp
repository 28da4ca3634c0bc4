// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/judge_decoys.h"

#include "evaluate/tables/decoy_table.h"
#include "io/error.h"

#include <Eigen/Core>

#include <algorithm>
#include <iterator>
#include <utility>

namespace ridgeline::results {

DecoySets decoys_of(const LineSets& lines, const JudgeFilesOptions& options) {
  DecoySets decoys;
  if (options.n_decoys != std::size_t{0}) {
    for (const std::vector<evaluate::JudgedLine>& set : lines) {
      const std::size_t n = options.n_decoys.value_or(evaluate::default_n_decoys(set.size()));
      decoys.push_back(evaluate::make_decoys(set, n));
      std::ranges::move(evaluate::move_elsewhere(set), std::back_inserter(decoys.back()));
    }
  }
  return decoys;
}

JudgedBatches judge_with_decoys(io::CloudFiles& cloud,
                                const LineSets& lines,
                                const JudgeFilesOptions& options) {
  return judge_in_batches(cloud, lines, options.judge, options.cloud_memory_mib << 20U,
                          decoys_of(lines, options));
}

void add_decoys(const std::vector<evaluate::JudgedDecoy>& decoys,
                const std::vector<evaluate::JudgedLine>& lines,
                evaluate::Evaluation& evaluation) {
  if (evaluation.area) evaluation.area->decoys = decoys;
  if (decoys.empty()) return;
  const auto& shift = evaluation.shift;
  // An applied shift has already been removed, and an insignificant one may be due to chance.
  const bool has_shift = shift && shift->is_significant() && !shift->applied;
  const Eigen::Vector3d shift_m = has_shift ? shift->shift_m : Eigen::Vector3d::Zero().eval();
  std::vector<evaluate::JudgedDecoy> elsewhere;
  std::ranges::copy_if(decoys, std::back_inserter(elsewhere), [](const auto& judged) {
    return judged.decoy.kind == evaluate::DecoyKind::kElsewhere;
  });
  const evaluate::BootstrapOptions& bootstrap = evaluation.options.bootstrap;
  evaluation.decoys = evaluate::decoy_figures(decoys, evaluation.lines, bootstrap);
  evaluation.elsewhere =
      evaluate::cloud_following(lines, evaluation.lines, elsewhere, shift_m, bootstrap);
}

void check_follows_cloud(const evaluate::Evaluation& evaluation,
                         const std::string& path,
                         const JudgeFilesOptions& options,
                         std::vector<std::string>& warnings) {
  const std::string note = evaluate::following_note(evaluation);
  if (note.empty()) return;
  if (!evaluation.elsewhere->is_of_another_place()) {
    warnings.push_back(path + ": the lines barely fit the cloud: " + note);
    return;
  }
  const std::string problem = "the lines do not fit the cloud: " + note;
  if (options.refuse_other_places) {
    throw io::IoError(
        path, problem + "; are they of another place? `decoys` 0 judges them without this check");
  }
  warnings.push_back(path + ": " + problem);
}

}  // namespace ridgeline::results
