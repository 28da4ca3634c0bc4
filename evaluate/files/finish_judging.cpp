// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/finish_judging.h"

#include "evaluate/files/judge_decoys.h"
#include "evaluate/files/judged_lines.h"
#include "evaluate/files/judged_map.h"
#include "evaluate/files/line_shift.h"
#include "evaluate/files/value_warnings.h"
#include "evaluate/statistics/frame_check.h"
#include "evaluate/tables/shift_text.h"
#include "io/error.h"

#include <Eigen/Geometry>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::Evaluation;

/// "[CRS] x 1..2, y 3..4, z 5..6 (unit 0.3048 m)" for a box in metres, printed in the units of the
/// file.
std::string bounds_text(const io::Crs& crs,
                        const Eigen::AlignedBox3d& box_m,
                        const Eigen::Vector3d& unit_m) {
  const std::string name = io::describe(crs).name;
  if (box_m.isEmpty()) return fmt::format("[{}] empty", name);
  const Eigen::Vector3d low = box_m.min().cwiseQuotient(unit_m);
  const Eigen::Vector3d high = box_m.max().cwiseQuotient(unit_m);
  const std::string unit =
      unit_m == Eigen::Vector3d::Ones() ? "" : fmt::format(" (unit {:.6g} m)", unit_m.x());
  return fmt::format("[{}] x {:.2f}..{:.2f}, y {:.2f}..{:.2f}, z {:.2f}..{:.2f}{}", name, low.x(),
                     high.x(), low.y(), high.y(), low.z(), high.z(), unit);
}

/// A hint at another unit with which the lines would lie in the cloud's plan extent; "" if there is
/// none.
std::string unit_hint(const Eigen::AlignedBox3d& lines_m, const Eigen::AlignedBox3d& cloud_m) {
  struct MisreadUnit {
    const char* name;
    double m;
    const char* factor;
  };
  constexpr std::array kUnits{
      MisreadUnit{"feet", 0.3048, "0.3048"},    MisreadUnit{"millimetres", 0.001, "0.001"},
      MisreadUnit{"centimetres", 0.01, "0.01"}, MisreadUnit{"inches", 0.0254, "0.0254"},
      MisreadUnit{"yards", 0.9144, "0.9144"},   MisreadUnit{"decimetres", 0.1, "0.1"},
      MisreadUnit{"kilometres", 1000.0, "1000"}};
  const auto overlaps = [&](double factor) {
    const Eigen::AlignedBox2d scaled(factor * lines_m.min().head<2>(),
                                     factor * lines_m.max().head<2>());
    return scaled.intersects(Eigen::AlignedBox2d(cloud_m.min().head<2>(), cloud_m.max().head<2>()));
  };
  if (lines_m.isEmpty() || overlaps(1.0)) return "";
  for (const MisreadUnit& unit : kUnits) {
    if (!overlaps(unit.m)) continue;
    return fmt::format(
        "; scaled by {} the lines would lie in the cloud: are they in {} and the cloud in metres? "
        "Define the reference system of both",
        unit.factor, unit.name);
  }
  if (overlaps(1.0 / 0.3048)) {
    return "; scaled by 3.2808 the lines would lie in the cloud: are they in metres and the cloud "
           "in feet? Define the reference system of both";
  }
  return "";
}

/// A hint at swapped or negated axes with which the lines would lie in the cloud's plan extent; ""
/// if there is none.
std::string axis_hint(const Eigen::AlignedBox3d& lines_m, const Eigen::AlignedBox3d& cloud_m) {
  struct Axes {
    const char* change;
    Eigen::Matrix2d plan;
  };
  const Eigen::Matrix2d exchanged{{0.0, 1.0}, {1.0, 0.0}};
  const Eigen::Matrix2d x_turned{{-1.0, 0.0}, {0.0, 1.0}};
  const std::array all{Axes{"x and y exchanged", exchanged}, Axes{"x negated", x_turned},
                       Axes{"y negated", -x_turned}};
  const auto overlaps = [&](const Eigen::Matrix2d& plan) {
    const Eigen::Vector2d a = plan * lines_m.min().head<2>();
    const Eigen::Vector2d b = plan * lines_m.max().head<2>();
    return Eigen::AlignedBox2d(a.cwiseMin(b), a.cwiseMax(b))
        .intersects(Eigen::AlignedBox2d(cloud_m.min().head<2>(), cloud_m.max().head<2>()));
  };
  if (lines_m.isEmpty() || overlaps(Eigen::Matrix2d::Identity())) return "";
  const auto right =
      std::ranges::find_if(all, [&](const Axes& axes) { return overlaps(axes.plan); });
  if (right == all.end()) return "";
  return fmt::format(
      "; with {} the lines would lie in the cloud: are their axes in another order or direction?",
      right->change);
}

/// Whether lines lie in a cloud: with most of their height, and with half of the shorter side in
/// plan.
bool lie_in(const Eigen::AlignedBox3d& lines_m, const Eigen::AlignedBox3d& cloud_m) {
  constexpr double kMinInPlan = 0.5, kMinInHeight = 0.8;
  const Eigen::AlignedBox3d common = lines_m.intersection(cloud_m);
  if (common.isEmpty()) return false;
  const Eigen::Vector3d needed = lines_m.sizes().cwiseMin(cloud_m.sizes()) * kMinInPlan;
  return common.sizes().z() >= kMinInHeight * lines_m.sizes().z() &&
         (common.sizes().array() >= needed.array()).all();
}

/// A hint at lines whose y axis points up, as most programs for 3D graphics write them; "" if they
/// would not lie in the cloud with z up.
std::string height_hint(const Eigen::AlignedBox3d& lines_m, const Eigen::AlignedBox3d& cloud_m) {
  if (lines_m.isEmpty() || lie_in(lines_m, cloud_m)) return "";
  for (const double y_from_z : {-1.0, 1.0}) {
    const auto turned = [&](const Eigen::Vector3d& x) {
      return Eigen::Vector3d(x.x(), y_from_z * x.z(), x.y());
    };
    Eigen::AlignedBox3d z_up(turned(lines_m.min()));
    z_up.extend(turned(lines_m.max()));
    if (!lie_in(z_up, cloud_m)) continue;
    return fmt::format(
        "y and z look exchanged: with {}z as y and y as height the lines would lie in the cloud; "
        "export them with z up",
        y_from_z < 0.0 ? "-" : "");
  }
  return "";
}

/// A clause about a common shift of all lines; "" if there is none.
std::string shift_hint(const std::optional<evaluate::ConstantShift>& shift) {
  if (!shift || !shift->is_significant()) return "";
  return fmt::format("; all lie beside it by the same shift, {}{}{} (`apply_shift` takes it away)",
                     evaluate::shift_text(*shift),
                     shift->cause.empty() ? "" : ", likely cause: ", shift->cause);
}

Eigen::AlignedBox3d bounds_m_of(const io::LineSet& set) {
  const Eigen::Vector3d unit_m = unit_m_of(set);
  Eigen::AlignedBox3d box;
  for (const io::Line& line : set.lines) {
    if (!all_finite(line.segment_in_world)) continue;
    box.extend(line.segment_in_world.start.cwiseProduct(unit_m));
    box.extend(line.segment_in_world.end.cwiseProduct(unit_m));
  }
  return box;
}

/// Throws IoError if the lines do not lie in the cloud. Adds a warning if they do but probably
/// should be turned.
void require_frame_of_cloud(const Evaluation& evaluation,
                            const io::LineSet& set,
                            io::CloudFiles& cloud,
                            std::vector<std::string>& warnings) {
  constexpr double kMaxUsual_m = 1.0;  // below it, the extent of the cloud need not be read
  const evaluate::FrameCheck check = evaluate::check_frame(evaluation.lines, kFrameTolerance_m);
  if (check.same_frame && check.median_distance_m.value_or(0.0) <= kMaxUsual_m) return;
  const Eigen::AlignedBox3d lines_box = bounds_m_of(set);
  const Eigen::AlignedBox3d cloud_box = cloud.extent_in_world();
  const std::string turned = height_hint(lines_box, cloud_box);
  if (check.same_frame) {
    if (!turned.empty()) warnings.push_back(set.path + ": " + turned);
    return;
  }
  if (cloud_box.isEmpty()) {
    throw io::IoError(cloud.path(), no_point_in_bounds(cloud));
  }
  throw io::IoError(
      set.path,
      fmt::format("lines and cloud are not in the same frame: {}; lines {}; cloud {}{}{}",
                  check.reason + shift_hint(evaluation.shift),
                  bounds_text(set.crs, lines_box, unit_m_of(set)),
                  bounds_text(cloud.crs(), cloud_box, cloud.unit_m()),
                  turned.empty() ? unit_hint(lines_box, cloud_box) + axis_hint(lines_box, cloud_box)
                                 : "; " + turned,
                  set.stated_unit.empty()
                      ? ""
                      : fmt::format("; the unit of the line file is {}", set.stated_unit)));
}

nlohmann::ordered_json cloud_facts(const CloudReadings& readings, const io::CloudFiles& files) {
  const io::PointCloud& cloud = readings.cloud;
  nlohmann::ordered_json json;
  json["crs"] = io::describe(cloud.crs).name;
  json["horizontal_unit_m"] = cloud.horizontal_unit_m;
  json["vertical_unit_m"] = cloud.vertical_unit_m;
  if (const Eigen::Vector2d& scale = files.plan_scale(); scale != Eigen::Vector2d::Ones()) {
    json["plan_scale"] = {scale.x(), scale.y()};
  }
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

Evaluation evaluation_of(const io::LineSet& set,
                         std::vector<evaluate::JudgedResult> results,
                         const std::optional<evaluate::ConstantShift>& shift,
                         const LocalFrame& frame,
                         const JudgeFilesOptions& options) {
  Evaluation evaluation;
  evaluation.patch = options.patch_name;
  evaluation.method = stem_of(set.path);
  evaluation.origin_m = frame.origin_m;
  evaluation.options = options.summary;
  evaluation.shift = shift;
  evaluation.lines.reserve(results.size());
  for (evaluate::JudgedResult& result : results) {
    if (!options.area) {
      for (evaluate::JudgingPlane& plane : result.evaluation.planes) plane.points = {};
    }
    evaluation.lines.push_back(std::move(result.evaluation));
  }
  return evaluate::with_summaries(std::move(evaluation));
}

/// Adds the warnings of the cloud before those about cloud and lines together, and the warnings of
/// the lines after them.
void add_warnings(const io::PointCloud& cloud, JudgedFiles& judged) {
  judged.warnings.insert(judged.warnings.begin(), cloud.warnings.begin(), cloud.warnings.end());
  for (const io::LineSet& set : judged.line_sets) {
    std::ranges::move(own_warnings(set), std::back_inserter(judged.warnings));
    if (const std::string warning = left_out_of_map(set); !warning.empty()) {
      judged.warnings.push_back(fmt::format("{}: {}", set.path, warning));
    }
  }
}

}  // namespace

JudgedFiles finish_judging(PreparedLines prepared,
                           JudgedBatches batches,
                           io::CloudFiles& cloud,
                           const JudgeFilesOptions& options,
                           RunRecord& record) {
  JudgedFiles judged = std::move(prepared.judged);
  LineSets& lines = prepared.lines;
  LineShifts shifts = shifts_of(batches, lines, judged.line_sets, options, cloud);
  if (options.apply_shift && apply_shifts(shifts, lines)) {
    batches = batches.decoys.empty()
                  ? judge_in_batches(cloud, lines, options.judge, options.cloud_memory_mib << 20U)
                  : judge_with_decoys(cloud, lines, options);
  }
  const io::PointCloud& facts = batches.readings.cloud;
  record.set("cloud", cloud_facts(batches.readings, cloud));
  record.end_stage("judge");

  if (!options.area) require_points(facts, cloud.path());
  add_warnings(facts, judged);
  judged.unread_clouds = cloud.unread_paths();
  std::ranges::move(prepared.reference_warnings, std::back_inserter(judged.warnings));
  judged.cloud_crs = cloud.crs();
  judged.cloud_unit_m = cloud.unit_m();
  if (options.judge.keep_points) {
    judged.points = evaluate::plane_points(batches.results.front());  // there is only one line file
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    judged.planes.push_back(evaluate::judged_planes(batches.results[i]));
    judged.evaluations.push_back(evaluation_of(judged.line_sets[i], std::move(batches.results[i]),
                                               shifts[i], judged.frame, options));
    if (options.area) judged.evaluations.back().area = std::move(judged.areas[i]);
    if (!options.area)
      require_frame_of_cloud(judged.evaluations.back(), judged.line_sets[i], cloud,
                             judged.warnings);
    if (!batches.decoys.empty()) {
      add_decoys(batches.decoys[i], lines[i], judged.evaluations.back());
      check_follows_cloud(judged.evaluations.back(), judged.line_sets[i].path, options,
                          judged.warnings);
    }
    add_value_warnings(judged.line_sets[i], judged.evaluations.back(), options.cloud.strict,
                       judged.warnings);
    judged.truth.push_back(
        compare_with_truth(judged.evaluations.back(), lines[i], prepared.references));
    if (shifts[i] && shifts[i]->applied) {
      judged.line_sets[i] = moved(std::move(judged.line_sets[i]), -shifts[i]->shift_m);
    }
  }
  record.end_stage("statistics");
  return judged;
}

}  // namespace ridgeline::results
