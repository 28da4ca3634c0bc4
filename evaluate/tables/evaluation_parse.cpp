// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/area_json.h"
#include "evaluate/tables/completeness_json.h"
#include "evaluate/tables/decoy_json.h"
#include "evaluate/tables/evaluation_json.h"
#include "evaluate/tables/shift_json.h"
#include "evaluate/tables/summary_json.h"
#include "reconstruct/geometry/check.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

const Json& member(const Json& object, const char* key) {
  check(object.is_object(), "evaluation: ", object.type_name(), "; must be an object with the key ",
        key);
  const auto found = object.find(key);
  check(found != object.end(), "evaluation: no key ", key, "; it is required");
  return *found;
}

std::string text(const Json& object, const char* key) {
  const Json& value = member(object, key);
  check(value.is_string(), key, ": ", value.dump(), "; must be a string");
  return value.get<std::string>();
}

std::string text_if_any(const Json& object, const char* key) {
  return object.contains(key) ? text(object, key) : std::string();
}

std::optional<double> number_if_any(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return std::nullopt;
  check(found->is_number(), key, ": ", found->dump(), "; must be a number or null");
  return found->get<double>();
}

double number(const Json& object, const char* key) {
  const std::optional<double> value = number_if_any(object, key);
  check(value.has_value(), key, ": missing; must be a number");
  return *value;
}

/// A non-negative integer of type T.
template <typename T>
T count(const Json& object, const char* key) {
  const Json& value = member(object, key);
  const bool fits =
      value.is_number_unsigned() &&
      value.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<T>::max());
  check(fits, key, ": ", value.dump(), "; must be a whole number >= 0");
  return value.get<T>();
}

Eigen::Vector3d vector(const Json& object, const char* key) {
  const Json& value = member(object, key);
  const bool is_vector = value.is_array() && value.size() == 3 && value[0].is_number() &&
                         value[1].is_number() && value[2].is_number();
  check(is_vector, key, ": ", value.dump(), "; must be three numbers");
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

const Json& array(const Json& object, const char* key) {
  const Json& value = member(object, key);
  check(value.is_array(), key, ": ", value.type_name(), "; must be a list");
  return value;
}

Status parse_status(const std::string& text) {
  for (int i = 0; i < kNumStatuses; ++i) {
    const auto status = static_cast<Status>(i);
    if (text == name(status)) return status;
  }
  throw std::invalid_argument("status: " + text + "; must be evaluated or a reason");
}

Kind parse_kind(const Json& line) {
  const auto found = line.find("kind");
  if (found == line.end() || found->is_null()) return Kind::kNone;
  const std::string kind = text(line, "kind");
  check(kind == "step" || kind == "ridge", "kind: ", kind, "; must be step, ridge or null");
  return kind == "step" ? Kind::kStep : Kind::kRidge;
}

/// The enumerator of T, one of `n_values`, with the given name; std::nullopt for null or a missing
/// key.
template <typename T>
std::optional<T> named_if_any(const Json& object, const char* key, int n_values) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return std::nullopt;
  const std::string written = text(object, key);
  for (int i = 0; i < n_values; ++i) {
    if (written == name(static_cast<T>(i))) return static_cast<T>(i);
  }
  throw std::invalid_argument(std::string(key) + ": " + written +
                              "; must be a name that docs/outputs.md lists, or null");
}

JudgingPlane parse_plane(const Json& json, const Eigen::Vector3d& origin_m) {
  constexpr double kUnitTolerance = 1e-6;  // a normal with too few digits is rejected, not rescaled
  const Eigen::Vector3d normal = vector(json, "normal");
  check(std::abs(normal.norm() - 1.0) < kUnitTolerance, "normal: length ", normal.norm(),
        "; must be 1");
  JudgingPlane p;
  p.plane = Plane3(normal, number(json, "d") + normal.dot(origin_m));
  p.n_inliers = count<int>(json, "n_inliers");
  p.rms_m = number(json, "rms_m");
  p.coverage = number(json, "coverage");
  p.extrapolation_m = number_if_any(json, "extrapolation_m").value_or(0.0);
  p.sigma_m = number_if_any(json, "sigma_m").value_or(0.0);
  p.sigma_random_m = number_if_any(json, "sigma_random_m").value_or(p.sigma_m);
  p.id = count<std::uint64_t>(json, "id");
  p.distance.start = number(json, "start_distance_m");
  p.distance.end = number(json, "end_distance_m");
  p.distance.mean_abs = number(json, "mean_distance_m");
  p.distance.mean = number(json, "signed_mean_m");
  p.distance.rms = number(json, "rms_distance_m");
  p.distance.max_abs = number(json, "max_distance_m");
  if (json.contains("points")) p.points = parse_points(text(json, "points"));
  return p;
}

std::optional<RidgeDisplacement> parse_displacement(const Json& line) {
  const auto found = line.find("displacement");
  if (found == line.end() || found->is_null()) return std::nullopt;
  RidgeDisplacement d;
  d.horizontal_m = number(*found, "horizontal_m");
  d.vertical_m = number(*found, "vertical_m");
  const Json& rows = array(*found, "covariance_m2");
  const auto is_pair = [](const Json& row) {
    return row.is_array() && row.size() == 2 && row[0].is_number() && row[1].is_number();
  };
  check(rows.size() == 2 && is_pair(rows[0]) && is_pair(rows[1]), "covariance_m2: ", rows.dump(),
        "; must be 2 x 2 numbers");
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 2; ++k) {
      d.covariance_m2(i, k) =
          rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)].get<double>();
    }
  }
  return d;
}

void parse_distances(const Json& json, LineEvaluation& line) {
  line.mean_distance_m = number(json, "mean_distance_m");
  line.max_distance_m = number(json, "max_distance_m");
  line.signed_mean_m = number(json, "signed_mean_m");
  check(*line.mean_distance_m >= 0.0, "mean_distance_m: ", *line.mean_distance_m, "; must be >= 0");
  line.sigma_plane_m = number_if_any(json, "sigma_plane_m").value_or(0.0);
  line.sigma_line_m = number_if_any(json, "sigma_line_m");
  line.z = number_if_any(json, "z");
  line.intersection_distance_m = number_if_any(json, "intersection_distance_m");
  line.intersection_angle_deg = number_if_any(json, "intersection_angle_deg");
  line.displacement = parse_displacement(json);
  line.height_if_vertical_m = number_if_any(json, "height_if_vertical_m");
}

LineEvaluation parse_line(const Json& json, const Eigen::Vector3d& origin_m) {
  LineEvaluation line;
  line.id = text(json, "id");
  line.line_class = text(json, "class");
  line.status = parse_status(text(json, "status"));
  line.kind = parse_kind(json);
  line.reason = text_if_any(json, "reason");
  line.building = text_if_any(json, "building");
  for (const Json& flag : array(json, "flags")) {
    check(flag.is_string(), "flags: ", flag.dump(), "; must be a string");
    line.flags.push_back(flag.get<std::string>());
  }
  line.surface = named_if_any<JudgingSurface>(json, "surface", kNumSurfaces);
  line.surface_other = named_if_any<JudgingSurface>(json, "surface_other", kNumSurfaces);
  line.surface_probability = number_if_any(json, "surface_probability");
  line.decided_by = named_if_any<DecidedBy>(json, "decided_by", kNumDecidedBy);
  // the length is null for a line with non-finite coordinates
  line.length_m = number_if_any(json, "length_m").value_or(0.0);
  line.epipolar_angle_deg = number_if_any(json, "epipolar_angle_deg");
  if (json.contains("n_images")) line.n_images = count<int>(json, "n_images");
  line.class_base = text_if_any(json, "class_base");
  if (json.contains("start_m")) {
    line.segment = Segment3{vector(json, "start_m") - origin_m, vector(json, "end_m") - origin_m};
  }
  for (const Json& plane : array(json, "planes")) {
    line.planes.push_back(parse_plane(plane, origin_m));
  }
  if (line.status == Status::kEvaluated) parse_distances(json, line);
  return line;
}

SummaryOptions parse_options(const Json& json) {
  SummaryOptions options;
  options.bootstrap.seed = count<std::uint64_t>(json, "seed");
  options.bootstrap.replicates = count<int>(json, "bootstrap_replicates");
  options.bootstrap.bca = text(json, "interval") == "bca";
  options.bootstrap.level = number(json, "level");
  options.gross_m = number(json, "gross_m");
  options.outlier_limit_m = number_if_any(json, "outlier_limit_m");
  options.sigma_sys_m = number(json, "sigma_sys_m");
  return options;
}

Json parse_text(std::string_view text) {
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("not JSON: ") + error.what());
  }
}

}  // namespace

Evaluation parse_evaluation(std::string_view json) {
  const Json root = parse_text(json);
  Evaluation evaluation;
  evaluation.patch = text(root, "patch");
  evaluation.method = text(root, "method");
  evaluation.origin_m = vector(root, "origin_m");
  evaluation.options = parse_options(member(root, "options"));
  if (root.contains("shift")) evaluation.shift = parse_shift(root["shift"]);
  if (root.contains("decoys")) evaluation.decoys = parse_decoys(root["decoys"]);
  if (root.contains("elsewhere")) evaluation.elsewhere = parse_following(root["elsewhere"]);
  if (root.contains("area")) evaluation.area = parse_area(root["area"]);
  if (root.contains("completeness")) {
    evaluation.completeness = parse_completeness(root["completeness"], evaluation.origin_m);
  }
  const Json& lines = array(root, "lines");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    try {
      evaluation.lines.push_back(parse_line(lines[i], evaluation.origin_m));
      if (evaluation.area) {
        evaluation.area->numbers.push_back(count<std::size_t>(lines[i], "number"));
      }
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("line " + std::to_string(i) + ": " + error.what());
    }
  }
  return with_summaries(std::move(evaluation));
}

}  // namespace ridgeline::evaluate
