// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/evaluation_json.h"
#include "evaluate/tables/format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <functional>

namespace ridgeline::evaluate {
namespace {

constexpr int kLineDecimals = 4;

std::string figure_text(std::optional<double> value) { return fixed(value, kLineDecimals, ""); }

/// One figure of each plane, "0.0312;0.0287".
std::string per_plane(const LineEvaluation& line,
                      const std::function<std::string(const JudgingPlane&)>& figure) {
  std::vector<std::string> figures;
  for (const JudgingPlane& p : line.planes) figures.push_back(figure(p));
  return fmt::format("{}", fmt::join(figures, ";"));
}

std::string plane_columns(const LineEvaluation& line) {
  const auto column = [&](auto figure) {
    return per_plane(line, [figure](const JudgingPlane& p) { return figure_text(figure(p)); });
  };
  return fmt::format(
      "{},{},{},{},{},{}",
      per_plane(line, [](const JudgingPlane& p) { return std::to_string(p.n_inliers); }),
      column([](const JudgingPlane& p) { return p.rms_m; }),
      column([](const JudgingPlane& p) { return p.coverage; }),
      column([](const JudgingPlane& p) { return p.extrapolation_m; }),
      column([](const JudgingPlane& p) { return p.distance.start; }),
      column([](const JudgingPlane& p) { return p.distance.end; }));
}

std::string displacement_columns(const LineEvaluation& line) {
  if (!line.displacement) return fmt::format(",,,,{}", figure_text(line.height_if_vertical_m));
  const RidgeDisplacement& d = *line.displacement;
  return fmt::format("{},{},{},{},", figure_text(d.horizontal_m), figure_text(d.vertical_m),
                     figure_text(std::sqrt(d.covariance_m2(0, 0))),
                     figure_text(std::sqrt(d.covariance_m2(1, 1))));
}

std::string surface_columns(const LineEvaluation& line) {
  return fmt::format("{},{},{},{}", name(line.surface), name(line.surface_other),
                     figure_text(line.surface_probability), name(line.decided_by));
}

/// The additional columns for lines that were moved before they were judged.
std::string moved_columns(const Evaluation& evaluation) {
  if (!evaluation.shift || !evaluation.shift->applied) return "";
  const Eigen::Vector3d by_m = -evaluation.shift->shift_m;
  return fmt::format(",{},{},{}", figure_text(by_m.x()), figure_text(by_m.y()),
                     figure_text(by_m.z()));
}

std::string row(const LineEvaluation& line, const Evaluation& evaluation) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}{}\n", escape_csv(line.id),
                     escape_csv(evaluation.patch), escape_csv(line.line_class),
                     figure_text(line.epipolar_angle_deg), name(line.kind),
                     escape_csv(evaluation.method), figure_text(line.length_m), plane_columns(line),
                     figure_text(line.mean_distance_m), figure_text(line.signed_mean_m),
                     figure_text(line.sigma_line_m), figure_text(line.sigma_plane_m),
                     figure_text(line.z), name(line.status),
                     escape_csv(fmt::format("{}", fmt::join(line.flags, ";"))),
                     displacement_columns(line), surface_columns(line), moved_columns(evaluation));
}

}  // namespace

std::string to_line_csv(const Evaluation& evaluation) {
  std::string text =
      "id,patch,class,epipolar_angle_deg,kind,method,length_m,n_inliers,plane_rms_m,hull_coverage,"
      "extrapolation_m,start_distance_m,end_distance_m,mean_distance_m,signed_mean_m,sigma_line_m,"
      "sigma_plane_m,z,status,flags,horizontal_m,vertical_m,sigma_horizontal_m,sigma_vertical_m,"
      "height_if_vertical_m,surface,surface_other,surface_probability,decided_by";
  if (!moved_columns(evaluation).empty()) text += ",moved_x_m,moved_y_m,moved_z_m";
  text += "\n";
  for (const LineEvaluation& line : evaluation.lines) text += row(line, evaluation);
  return text;
}

}  // namespace ridgeline::evaluate
