// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/prepare_lines.h"

#include "evaluate/files/judged_lines.h"
#include "evaluate/files/plan_scale.h"
#include "io/error.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace ridgeline::results {
namespace {

std::vector<io::LineSet> read_line_files(const JudgeFilesOptions& options) {
  std::vector<io::LineSet> sets;
  std::set<std::string> stems;
  for (const std::string& path : options.line_paths) {
    if (!stems.insert(stem_of(path)).second) {
      throw io::IoError(path,
                        fmt::format("a second line file is called '{}'; names without extension "
                                    "must be unique, as the results are named after them",
                                    stem_of(path)));
    }
    sets.push_back(io::read_lines(path, options.lines));
  }
  return sets;
}

/// Gives the lines the plan scale of the cloud. Lines without a reference system are assumed to be
/// in its units, too.
void take_unit_of(const io::CloudFiles& cloud, io::LineSet& set) {
  set.plan_scale = cloud.plan_scale();
  const Eigen::Vector3d grid_from_ground(set.plan_scale.x(), set.plan_scale.y(), 1.0);
  if (!set.crs.known()) set.unit_m = cloud.unit_m().cwiseProduct(grid_from_ground);
}

/// The true lines in the frame and the units of the cloud.
std::vector<evaluate::ReferenceLine> references_beside(const io::CloudFiles& cloud,
                                                       io::LineSet set,
                                                       std::vector<std::string>& warnings) {
  take_unit_of(cloud, set);
  require_same_frame("lines and cloud", set.path, set.crs, cloud.crs(), &warnings);
  std::ranges::move(own_warnings(set), std::back_inserter(warnings));
  return reference_lines_of(set, cloud.frame());
}

LineSets lines_beside(const io::CloudFiles& cloud,
                      const JudgeFilesOptions& options,
                      JudgedFiles& judged) {
  LineSets lines;
  for (io::LineSet& set : judged.line_sets) {
    take_unit_of(cloud, set);
    require_same_frame("lines and cloud", set.path, set.crs, cloud.crs(), &judged.warnings);
    lines.push_back(
        judged_lines_of(set, cloud.frame(), options.patch, options.max_aligned_angle_deg));
  }
  return lines;
}

}  // namespace

LinesToJudge read_lines_to_judge(const JudgeFilesOptions& options) {
  LinesToJudge lines{.sets = read_line_files(options), .references = {}};
  if (options.reference_lines) {
    io::ReadLinesOptions of_truth = options.lines;
    of_truth.id_column = of_truth.building_column = "";
    lines.references = io::read_lines(*options.reference_lines, of_truth);
  }
  return lines;
}

PreparedLines prepare_lines(LinesToJudge to_judge,
                            io::CloudFiles& cloud,
                            const JudgeFilesOptions& options) {
  PreparedLines prepared;
  JudgedFiles& judged = prepared.judged;
  judged.line_sets = std::move(to_judge.sets);
  set_plan_scale(judged.line_sets, options.patch, options.scale_to_ground, cloud, judged.warnings);
  judged.frame = cloud.frame();
  if (options.patch && options.patch->crs.known()) {
    const io::Patch& patch = *options.patch;
    require_same_frame("patch and cloud", patch.path, patch.crs, cloud.crs(), &judged.warnings);
  }
  prepared.lines = lines_beside(cloud, options, judged);
  if (to_judge.references) {
    prepared.references =
        references_beside(cloud, std::move(*to_judge.references), prepared.reference_warnings);
  }
  return prepared;
}

}  // namespace ridgeline::results
