// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/scan_comparison.h"

#include "evaluate/files/model_lacks.h"
#include "evaluate/files/scan_cells.h"
#include "evaluate/files/scan_scope.h"
#include "reconstruct/geometry/plan_box.h"

#include <algorithm>
#include <span>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::Evaluation;
using evaluate::ScanEdges;

bool is_counted(const evaluate::LineEvaluation& line) {
  return line.segment && line.status != evaluate::Status::kNotReconstructed;
}

std::vector<Segment3> counted_lines(const Evaluation& evaluation) {
  std::vector<Segment3> counted;
  for (const evaluate::LineEvaluation& line : evaluation.lines) {
    if (is_counted(line)) counted.push_back(*line.segment);
  }
  return counted;
}

/// The edges of the scan whose middle lies in a box, local.
ScanEdges edges_in(const Eigen::AlignedBox2d& box_m,
                   io::CloudFiles& cloud,
                   const JudgeFilesOptions& options,
                   std::vector<std::string>& warnings) {
  if (box_m.isEmpty()) return {};
  const Eigen::Vector2d origin_m = cloud.frame().origin_m.head<2>();
  const Eigen::AlignedBox2d in_world_m(box_m.min() + origin_m, box_m.max() + origin_m);
  EdgesOfCloud found = edges_of_cloud(cloud, in_world_m, options.cloud_memory_mib << 20U, {},
                                      {.only_roofs = keeps_only_buildings(options.cloud)});
  for (std::string& warning : found.readings.cloud.warnings) {
    const bool is_new = std::ranges::find(warnings, warning) == warnings.end();
    if (is_new) warnings.push_back(std::move(warning));
  }
  return std::move(found.edges);
}

/// Moves lines as the judged ones were moved.
void take_shift(const Evaluation& evaluation, std::vector<Segment3>& lines) {
  if (!evaluation.shift || !evaluation.shift->applied) return;
  const Eigen::Vector3d& shift_m = evaluation.shift->shift_m;
  for (Segment3& line : lines) line = {line.start - shift_m, line.end - shift_m};
}

}  // namespace

std::vector<std::vector<Segment3>> finding_lines(const LineSets& lines) {
  std::vector<std::vector<Segment3>> finding(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const evaluate::JudgedLine& line : lines[i]) {
      if (line.reconstructed && evaluate::in_range(line.segment))
        finding[i].push_back(line.segment);
    }
  }
  return finding;
}

void compare_files_with_scan(std::vector<std::vector<Segment3>> lines,
                             io::CloudFiles& cloud,
                             const JudgeFilesOptions& options,
                             RunRecord& record,
                             JudgedFiles& judged) {
  // lines at the border of the area may follow edges whose middle lies outside
  constexpr double kBeyondArea_m = 30.0;
  const ScanArea area = scan_area(judged, options);
  const ScanEdges scan =
      edges_in(area.box_m.isEmpty() ? area.box_m : grown(area.box_m, kBeyondArea_m), cloud, options,
               judged.warnings);
  for (std::size_t i = 0; i < judged.evaluations.size(); ++i) {
    Evaluation& evaluation = judged.evaluations[i];
    take_shift(evaluation, lines[i]);
    evaluation.completeness = evaluate::compare_with_scan(lines[i], counted_lines(evaluation), scan,
                                                          area.scope, options.summary.bootstrap);
    if (!judged.models[i]) continue;
    const ModelPlan plan(judged.line_sets[i], evaluation, judged.frame);
    count_missing_edges(plan, scan, lines[i], *judged.models[i]);
    judged.models[i]->missing_roofs = missing_roofs(plan, scan, area.scope);
  }
  record.end_stage("completeness");
}

}  // namespace ridgeline::results
