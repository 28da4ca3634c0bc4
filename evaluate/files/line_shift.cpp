// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/line_shift.h"

#include "evaluate/files/judged_lines.h"
#include "evaluate/files/shift_cause.h"
#include "evaluate/statistics/distribution.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::results {
namespace {

using evaluate::ConstantShift;
using evaluate::JudgedLine;
using evaluate::LineEvaluation;

/// Above this distance, the planes may not be those adjacent to the lines.
constexpr double kFar_m = 1.0;

std::vector<LineEvaluation> evaluations_of(const std::vector<evaluate::JudgedResult>& results) {
  return transformed(results, &evaluate::JudgedResult::evaluation);
}

bool is_far(const std::vector<LineEvaluation>& lines, const std::optional<ConstantShift>& shift) {
  std::vector<double> distances_m;
  for (const LineEvaluation& line : lines) {
    if (line.status == evaluate::Status::kEvaluated) distances_m.push_back(*line.mean_distance_m);
  }
  return evaluate::median(std::move(distances_m)).value_or(0.0) > kFar_m || !shift ||
         shift->shift_m.norm() > kFar_m;
}

std::optional<ConstantShift> by_own_plan(std::vector<JudgedLine> lines,
                                         const JudgeFilesOptions& options,
                                         double accuracy_m,
                                         io::CloudFiles& cloud) {
  for (JudgedLine& line : lines) line.images.reset();
  const JudgedBatches judged =
      judge_in_batches(cloud, {std::move(lines)}, options.judge, options.cloud_memory_mib << 20U);
  return evaluate::estimate_shift(evaluations_of(judged.results.front()), accuracy_m);
}

/// The first reference system of cloud, lines and cameras that includes heights; else the first
/// known one.
io::Crs crs_of(const io::CloudFiles& cloud,
               const io::LineSet& set,
               const std::optional<io::Patch>& patch) {
  std::vector<io::Crs> all{cloud.crs(), set.crs};
  if (patch) all.push_back(patch->crs);
  std::erase_if(all, [](const io::Crs& crs) { return !crs.known(); });
  if (all.empty()) return {};
  const auto with_heights = std::ranges::find_if(
      all, [](const io::Crs& crs) { return !io::describe(crs).vertical_name.empty(); });
  return with_heights == all.end() ? all.front() : *with_heights;
}

/// The midpoint of the first line that was judged.
Eigen::Vector3d place_amid(const std::vector<LineEvaluation>& judged,
                           const std::vector<JudgedLine>& lines) {
  const auto first =
      std::ranges::find(judged, evaluate::Status::kEvaluated, &LineEvaluation::status);
  if (first == judged.end()) return Eigen::Vector3d::Zero();
  return midpoint(lines[static_cast<std::size_t>(first - judged.begin())].segment);
}

}  // namespace

LineShifts shifts_of(const JudgedBatches& judged,
                     const LineSets& lines,
                     const std::vector<io::LineSet>& sets,
                     const JudgeFilesOptions& options,
                     io::CloudFiles& cloud) {
  const double accuracy_m = std::hypot(options.judge.lidar_sigma_m, options.summary.sigma_sys_m);
  LineShifts shifts;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<LineEvaluation> evaluations = evaluations_of(judged.results[i]);
    std::optional<ConstantShift> shift = evaluate::estimate_shift(evaluations, accuracy_m);
    const bool has_images = std::ranges::any_of(
        lines[i], [](const JudgedLine& line) { return line.images.has_value(); });
    if (has_images && is_far(evaluations, shift)) {
      shift = by_own_plan(lines[i], options, accuracy_m, cloud);
    }
    if (shift && shift->is_significant()) {
      shift->cause = likely_cause(*shift, {.x_in_local = place_amid(evaluations, lines[i]),
                                           .frame = cloud.frame(),
                                           .crs = crs_of(cloud, sets[i], options.patch),
                                           .unit_m = cloud.unit_m(),
                                           .geoid_path = options.geoid,
                                           .patch = &options.patch});
    }
    shifts.push_back(std::move(shift));
  }
  return shifts;
}

bool apply_shifts(LineShifts& shifts, LineSets& lines) {
  bool any = false;
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    if (!shifts[i] || !shifts[i]->is_significant()) continue;
    lines[i] = moved(std::move(lines[i]), -shifts[i]->shift_m);
    shifts[i]->applied = true;
    any = true;
  }
  return any;
}

}  // namespace ridgeline::results
