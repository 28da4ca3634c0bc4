// SPDX-License-Identifier: BSD-3-Clause
#include "apps/evaluate/judge_files.h"

#include "apps/evaluate/judge_batches.h"
#include "apps/evaluate/judged_lines.h"
#include "evaluate/statistics/frame_check.h"
#include "io/error.h"

#include <Eigen/Geometry>
#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

namespace ridgeline::apps {
namespace {

using evaluate::Evaluation;
using evaluate::JudgedLine;

/// Largest median distance, divided by 20, of lines that are in the frame of the cloud: a geoid
/// taken for an ellipsoid (tens of metres) is found, lines a storey too high are judged.
constexpr double kFrameTolerance_m = 1.0;

std::vector<io::LineSet> read_line_files(const JudgeFilesOptions& options) {
  std::vector<io::LineSet> sets;
  std::set<std::string> stems;
  for (const std::string& path : options.line_paths) {
    if (!stems.insert(stem_of(path)).second) {
      throw io::IoError(path,
                        fmt::format("a second line file named '{}'; names without extension must "
                                    "differ, as the results are named after them",
                                    stem_of(path)));
    }
    sets.push_back(io::read_lines(path, options.lines));
  }
  return sets;
}

/// `what`: "lines" or "patch", which `path` holds.
void refuse_mismatch(std::string_view what,
                     const std::string& path,
                     const io::Crs& crs,
                     const io::Crs& cloud_crs,
                     std::vector<std::string>& warnings) {
  const io::CrsAgreement agreement = io::compare(crs, cloud_crs);
  if (!agreement.compatible) {
    throw io::IoError(path, fmt::format("{} and cloud do not match: {}; transform one of them, or "
                                        "declare the CRS with --assume-crs",
                                        what, agreement.reason));
  }
  if (!agreement.warning.empty()) warnings.push_back(path + ": " + agreement.warning);
}

std::string bounds_text(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) return "empty";
  return fmt::format("x {:.2f}..{:.2f}, y {:.2f}..{:.2f}, z {:.2f}..{:.2f}", box.min().x(),
                     box.max().x(), box.min().y(), box.max().y(), box.min().z(), box.max().z());
}

Eigen::AlignedBox3d bounds_of(const io::LineSet& set) {
  Eigen::AlignedBox3d box;
  for (const io::Line& line : set.lines) {
    if (!all_finite(line.segment_in_world)) continue;
    box.extend(line.segment_in_world.start);
    box.extend(line.segment_in_world.end);
  }
  return box;
}

void refuse_foreign_frame(const Evaluation& evaluation,
                          const io::LineSet& set,
                          io::CloudFiles& cloud,
                          const JudgeFilesOptions& options) {
  const evaluate::FrameCheck check = evaluate::check_frame(evaluation.lines, kFrameTolerance_m);
  if (check.same_frame) return;
  const Eigen::AlignedBox3d cloud_box = cloud.extent_in_world();
  if (cloud_box.isEmpty()) {
    throw io::IoError(options.cloud_paths.front(),
                      "no point lies within --bounds; must be given in the cloud's CRS");
  }
  throw io::IoError(
      set.path, fmt::format("lines and cloud are not in the same frame: {}; lines [{}] {}; "
                            "cloud [{}] {}",
                            check.reason, io::describe(set.crs).name, bounds_text(bounds_of(set)),
                            io::describe(cloud.crs()).name, bounds_text(cloud_box)));
}

nlohmann::ordered_json cloud_facts(const CloudReadings& readings, const io::CloudFiles& files) {
  const io::PointCloud& cloud = readings.cloud;
  nlohmann::ordered_json json;
  json["crs"] = io::describe(cloud.crs).name;
  json["horizontal_unit_m"] = cloud.horizontal_unit_m;
  json["vertical_unit_m"] = cloud.vertical_unit_m;
  json["n_batches"] = readings.n_batches;
  json["n_files_unread"] = files.unread_paths().size();
  json["n_read"] = cloud.n_read;
  json["n_kept"] = readings.n_kept;
  json["n_dropped_class"] = cloud.n_dropped_class;
  json["n_dropped_withheld"] = cloud.n_dropped_withheld;
  json["n_dropped_return"] = cloud.n_dropped_return;
  json["n_dropped_bounds"] = cloud.n_dropped_bounds;
  json["n_dropped_non_finite"] = cloud.n_dropped_non_finite;
  return json;
}

void refuse_empty(const io::PointCloud& cloud, const JudgeFilesOptions& options) {
  if (cloud.n_read == 0) {
    throw io::IoError(options.cloud_paths.front(), "holds no points; nothing to judge lines by");
  }
  const std::uint64_t filtered = cloud.n_dropped_class + cloud.n_dropped_withheld +
                                 cloud.n_dropped_return + cloud.n_dropped_non_finite;
  if (filtered < cloud.n_read) return;
  throw io::IoError(options.cloud_paths.front(),
                    fmt::format("no point of {} is left: {} dropped by class, {} withheld, {} not "
                                "last returns, {} not finite; ask `ridgeline info` for its classes",
                                cloud.n_read, cloud.n_dropped_class, cloud.n_dropped_withheld,
                                cloud.n_dropped_return, cloud.n_dropped_non_finite));
}

Evaluation evaluation_of(const io::LineSet& set,
                         std::vector<evaluate::JudgedResult> results,
                         const LocalFrame& frame,
                         const JudgeFilesOptions& options) {
  Evaluation evaluation;
  evaluation.patch = options.patch_name;
  evaluation.method = stem_of(set.path);
  evaluation.origin_m = frame.origin_m;
  evaluation.options = options.summary;
  evaluation.lines.reserve(results.size());
  for (evaluate::JudgedResult& result : results) {
    evaluation.lines.push_back(std::move(result.evaluation));
  }
  return evaluate::with_summaries(std::move(evaluation));
}

}  // namespace

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

JudgedFiles judge_files(const JudgeFilesOptions& options, RunRecord& record) {
  JudgedFiles judged;
  judged.line_sets = read_line_files(options);
  io::CloudFiles cloud(options.cloud_paths, options.cloud);
  judged.frame = cloud.frame();
  if (options.patch && options.patch->crs.known()) {
    refuse_mismatch("patch", options.patch->path, options.patch->crs, cloud.crs(), judged.warnings);
  }
  LineSets lines;
  for (const io::LineSet& set : judged.line_sets) {
    refuse_mismatch("lines", set.path, set.crs, cloud.crs(), judged.warnings);
    lines.push_back(judged_lines_of(set, judged.frame, options.patch));
  }
  record.end_stage("read_lines");

  JudgedBatches batches =
      judge_in_batches(cloud, lines, options.judge, options.cloud_memory_mib << 20U);
  const io::PointCloud& facts = batches.readings.cloud;
  record.set("cloud", cloud_facts(batches.readings, cloud));
  record.end_stage("judge");

  refuse_empty(facts, options);
  judged.warnings.insert(judged.warnings.begin(), facts.warnings.begin(), facts.warnings.end());
  judged.unread_clouds = cloud.unread_paths();
  for (const io::LineSet& set : judged.line_sets) {
    for (const std::string& warning : set.warnings) {
      judged.warnings.push_back(set.path + ": " + warning);
    }
  }
  std::optional<std::vector<evaluate::ReferenceLine>> references;
  if (options.reference_lines) {
    const io::LineSet set = io::read_lines(*options.reference_lines, options.lines);
    refuse_mismatch("lines", set.path, set.crs, cloud.crs(), judged.warnings);
    references = reference_lines_of(set, judged.frame);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    judged.evaluations.push_back(
        evaluation_of(judged.line_sets[i], std::move(batches.results[i]), judged.frame, options));
    refuse_foreign_frame(judged.evaluations.back(), judged.line_sets[i], cloud, options);
    judged.truth.push_back(compare_with_truth(judged.evaluations.back(), lines[i], references));
  }
  record.end_stage("statistics");
  return judged;
}

}  // namespace ridgeline::apps
