// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/evaluation_json.h"

#include "evaluate/statistics/accuracy.h"
#include "evaluate/statistics/standards.h"
#include "evaluate/statistics/strata.h"
#include "evaluate/tables/area_json.h"
#include "evaluate/tables/completeness_json.h"
#include "evaluate/tables/decoy_json.h"
#include "evaluate/tables/shift_json.h"
#include "evaluate/tables/summary_json.h"
#include "evaluate/tables/table2.h"

#include <numeric>

namespace ridgeline::evaluate {
namespace {

Json vector_json(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json plane_json(const JudgingPlane& p, const Eigen::Vector3d& origin_m) {
  const Eigen::Vector3d normal = p.plane.normal();
  Json json{{"normal", vector_json(normal)},
            {"d", p.plane.offset() - normal.dot(origin_m)},
            {"n_inliers", p.n_inliers},
            {"rms_m", number_json(p.rms_m)},
            {"coverage", number_json(p.coverage)},
            {"extrapolation_m", number_json(p.extrapolation_m)},
            {"sigma_m", number_json(p.sigma_m)},
            {"sigma_random_m", number_json(p.sigma_random_m)},
            {"id", p.id},
            {"start_distance_m", number_json(p.distance.start)},
            {"end_distance_m", number_json(p.distance.end)},
            {"mean_distance_m", number_json(p.distance.mean_abs)},
            {"signed_mean_m", number_json(p.distance.mean)},
            {"rms_distance_m", number_json(p.distance.rms)},
            {"max_distance_m", number_json(p.distance.max_abs)}};
  if (p.points.n > 0) json["points"] = points_text(p.points);
  return json;
}

/// The displacement of a ridge; null if the line is not a ridge, or if its planes are too parallel
/// or too uncertain.
Json displacement_json(const std::optional<RidgeDisplacement>& d) {
  if (!d) return nullptr;
  return {{"horizontal_m", number_json(d->horizontal_m)},
          {"vertical_m", number_json(d->vertical_m)},
          {"covariance_m2",
           {{number_json(d->covariance_m2(0, 0)), number_json(d->covariance_m2(0, 1))},
            {number_json(d->covariance_m2(1, 0)), number_json(d->covariance_m2(1, 1))}}}};
}

template <typename Named>
Json named_json(const std::optional<Named>& value) {
  return value ? Json(name(*value)) : Json(nullptr);
}

Json line_json(const LineEvaluation& line, const Eigen::Vector3d& origin_m) {
  Json json{{"id", line.id},
            {"class", line.line_class},
            {"status", name(line.status)},
            {"kind", line.kind == Kind::kNone ? Json(nullptr) : Json(name(line.kind))}};
  if (!line.reason.empty()) json["reason"] = line.reason;
  if (!line.building.empty()) json["building"] = line.building;
  json["flags"] = line.flags;
  json["surface"] = named_json(line.surface);
  json["surface_other"] = named_json(line.surface_other);
  json["surface_probability"] = number_json(line.surface_probability);
  json["decided_by"] = named_json(line.decided_by);
  json["length_m"] = number_json(line.length_m);
  json["epipolar_angle_deg"] = number_json(line.epipolar_angle_deg);
  if (line.n_images) json["n_images"] = *line.n_images;
  if (!line.class_base.empty()) json["class_base"] = line.class_base;
  if (line.segment) {
    json["start_m"] = vector_json(line.segment->start + origin_m);
    json["end_m"] = vector_json(line.segment->end + origin_m);
  }
  json["planes"] = Json::array();
  for (const JudgingPlane& p : line.planes) json["planes"].push_back(plane_json(p, origin_m));
  json["mean_distance_m"] = number_json(line.mean_distance_m);
  json["max_distance_m"] = number_json(line.max_distance_m);
  json["signed_mean_m"] = number_json(line.signed_mean_m);
  json["sigma_plane_m"] = number_json(line.sigma_plane_m);
  json["sigma_line_m"] = number_json(line.sigma_line_m);
  json["z"] = number_json(line.z);
  json["intersection_distance_m"] = number_json(line.intersection_distance_m);
  json["intersection_angle_deg"] = number_json(line.intersection_angle_deg);
  json["displacement"] = displacement_json(line.displacement);
  json["height_if_vertical_m"] = number_json(line.height_if_vertical_m);
  return json;
}

Json options_json(const SummaryOptions& options) {
  return {{"seed", options.bootstrap.seed},
          {"bootstrap_replicates", options.bootstrap.replicates},
          {"interval", options.bootstrap.bca ? "bca" : "percentile"},
          {"level", options.bootstrap.level},
          {"gross_m", options.gross_m},
          {"outlier_rms_factor", kOutlierRmsFactor},
          {"outlier_limit_m", number_json(options.outlier_limit_m)},
          {"sigma_sys_m", options.sigma_sys_m}};
}

Json accuracy_json(const Evaluation& evaluation) {
  Json json = Json::object();
  for (const AccuracyStatement& a : accuracy_statements(evaluation)) {
    json[a.line_class] = {{"n", a.n},
                          {"observed_m", number_json(a.numbers.observed_m)},
                          {"product_m", number_json(a.numbers.product_m)},
                          {"method_only_m", number_json(a.numbers.method_only_m)},
                          {"sigma_ref_m", number_json(a.numbers.sigma_ref_m)},
                          {"extrapolated_share", number_json(a.extrapolated_share)},
                          {"flags", a.flags()}};
  }
  return json;
}

Json measures_json(const StandardsBlock& block) {
  Json measures = Json::array();
  for (const IsoMeasure& m : block.iso19157) {
    measures.push_back({{"id", m.id},
                        {"name", m.name},
                        {"value", number_json(m.value)},
                        {"unit", m.unit},
                        {"n", m.n}});
  }
  return measures;
}

Json standards_json(const Evaluation& evaluation) {
  Json json = Json::object();
  for (const StandardsBlock& b : standards_blocks(evaluation)) {
    json[b.line_class] = {{"asprs",
                           {{"n", b.asprs.n},
                            {"rmse_horizontal_m", number_json(b.asprs.rmse_horizontal_m)},
                            {"rmse_vertical_m", number_json(b.asprs.rmse_vertical_m)},
                            {"rmse_3d_m", number_json(b.asprs.rmse_3d_m)},
                            {"best_class_m", number_json(b.asprs.best_class_m)},
                            {"few_checkpoints", b.asprs.few_checkpoints},
                            {"biased", b.asprs.biased}}},
                          {"nssda",
                           {{"horizontal_m", number_json(b.nssda.horizontal_m)},
                            {"vertical_m", number_json(b.nssda.vertical_m)}}},
                          {"uncertainty",
                           {{"laser_random_m", number_json(b.budget.laser_random_m)},
                            {"laser_systematic_m", number_json(b.budget.laser_systematic_m)},
                            {"plane_fit_m", number_json(b.budget.plane_fit_m)},
                            {"combined_m", number_json(b.budget.combined_m())},
                            {"expanded_m", number_json(b.budget.expanded_m())},
                            {"k", 2},
                            {"sampling_m", number_json(b.budget.sampling_m)}}},
                          {"iso19157", measures_json(b)}};
  }
  return json;
}

Json calibration_json(const Calibration& c) {
  return {{"n", c.n},
          {"nees_per_dof", number_json(c.nees_per_dof)},
          {"bounds95", interval_json(c.bounds95)},
          {"median_z2", number_json(c.median_z2)},
          {"coverage_1_96", number_json(c.coverage_1_96)},
          {"share_beyond_99_9", number_json(c.share_beyond_99_9)},
          {"median_sigma_m", number_json(c.median_sigma_m)}};
}

Json strata_json(const Evaluation& evaluation) {
  Json json = Json::object();
  for (const Stratification& s : stratify(evaluation)) {
    Json rows = Json::array();
    for (const Stratum& stratum : s.strata) {
      Json row{{"stratum", stratum.summary.line_class}};
      row.update(summary_json(stratum.summary));
      row["calibration"] = calibration_json(stratum.calibration);
      rows.push_back(std::move(row));
    }
    json[s.by] = std::move(rows);
  }
  return json;
}

Json total_calibration_json(const Evaluation& evaluation) {
  std::vector<std::size_t> all(evaluation.lines.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return calibration_json(
      calibrate(evaluation.lines, all, std::string(kTotal), evaluation.options.sigma_sys_m));
}

}  // namespace

Json evaluation_json(const Evaluation& evaluation) {
  Json summary = Json::object();
  for (const Summary& s : evaluation.classes) summary[s.line_class] = class_json(s);
  Json lines = Json::array();
  for (std::size_t i = 0; i < evaluation.lines.size(); ++i) {
    lines.push_back(line_json(evaluation.lines[i], evaluation.origin_m));
    if (evaluation.area) lines.back()["number"] = evaluation.area->numbers[i];
  }
  Json json{{"patch", evaluation.patch},
            {"method", evaluation.method},
            {"note", kFixedSentence},
            {"origin_m", vector_json(evaluation.origin_m)},
            {"options", options_json(evaluation.options)},
            {"shift", shift_json(evaluation.shift)},
            {"decoys", decoys_json(evaluation.decoys)},
            {"elsewhere", following_json(evaluation.elsewhere)},
            {"summary", std::move(summary)},
            {"accuracy", accuracy_json(evaluation)},
            {"standards", standards_json(evaluation)},
            {"calibration", total_calibration_json(evaluation)},
            {"strata", strata_json(evaluation)}};
  if (evaluation.area) json["area"] = area_json(*evaluation.area);
  if (evaluation.completeness) {
    json["completeness"] = completeness_json(*evaluation.completeness, evaluation.origin_m);
  }
  json["lines"] = std::move(lines);
  return json;
}

std::string to_json(const Evaluation& evaluation) { return dump(evaluation_json(evaluation)); }

}  // namespace ridgeline::evaluate
