// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/shift_json.h"

#include "reconstruct/geometry/check.h"

#include <array>
#include <stdexcept>
#include <string>

namespace ridgeline::evaluate {
namespace {

constexpr std::array kAxisKeys{"x", "y", "z"};

Json triple_json(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

Eigen::Vector3d triple_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json covariance_json(const Eigen::Matrix3d& covariance) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) {
    Json row = Json::array();
    for (int k = 0; k < 3; ++k) row.push_back(number_json(covariance(i, k)));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json axes_json(const ConstantShift& shift) {
  Json json = Json::object();
  for (std::size_t i = 0; i < kAxisKeys.size(); ++i) {
    const ShiftAxis& axis = shift.axes[i];
    json[kAxisKeys[i]] = axis.shift_m ? Json{{"shift_m", number_json(axis.shift_m)},
                                             {"ci95_m", interval_json(axis.ci95_m)}}
                                      : Json(nullptr);
  }
  return json;
}

Json directions_json(const ConstantShift& shift) {
  Json rows = Json::array();
  for (const PlaneDirection& d : shift.directions) {
    rows.push_back({{"direction", d.name},
                    {"n_lines", d.n_lines},
                    {"n_planes", d.n_planes},
                    {"mean_m", number_json(d.mean_m)},
                    {"median_m", number_json(d.median_m)}});
  }
  return rows;
}

ConstantShift read_shift(const Json& json) {
  ConstantShift shift;
  shift.n_lines = json.at("n_lines").get<std::size_t>();
  shift.n_planes = json.at("n_planes").get<std::size_t>();
  shift.n_clusters = json.at("n_clusters").get<std::size_t>();
  for (std::size_t i = 0; i < kAxisKeys.size(); ++i) {
    const Json& axis = json.at("axes").at(kAxisKeys[i]);
    if (axis.is_null()) continue;
    shift.axes[i].shift_m = axis.at("shift_m").get<double>();
    const Json& interval = axis.at("ci95_m");
    shift.axes[i].ci95_m = Interval{interval.at(0).get<double>(), interval.at(1).get<double>()};
  }
  shift.shift_m = triple_of(json.at("told_m"));
  for (int i = 0; i < 3; ++i) {
    shift.covariance_m2.row(i) =
        triple_of(json.at("covariance_m2").at(static_cast<std::size_t>(i)));
  }
  for (const Json& direction : json.at("unobservable_directions")) {
    shift.unobservable.push_back(triple_of(direction));
  }
  shift.least_m = json.at("least_m").get<double>();
  shift.accuracy_m = json.at("accuracy_m").get<double>();
  shift.applied = json.at("applied").get<bool>();
  if (!json.at("likely_cause").is_null()) shift.cause = json["likely_cause"].get<std::string>();
  for (const Json& row : json.at("by_plane_direction")) {
    shift.directions.push_back({.name = row.at("direction").get<std::string>(),
                                .n_lines = row.at("n_lines").get<std::size_t>(),
                                .n_planes = row.at("n_planes").get<std::size_t>(),
                                .mean_m = row.at("mean_m").get<double>(),
                                .median_m = row.at("median_m").get<double>()});
  }
  return shift;
}

}  // namespace

Json shift_json(const std::optional<ConstantShift>& shift) {
  if (!shift) return nullptr;
  Json unobservable = Json::array();
  for (const Eigen::Vector3d& direction : shift->unobservable)
    unobservable.push_back(triple_json(direction));
  return {{"significant", shift->is_significant()},
          {"applied", shift->applied},
          {"likely_cause", shift->cause.empty() ? Json(nullptr) : Json(shift->cause)},
          {"axes", axes_json(*shift)},
          {"unobservable_directions", std::move(unobservable)},
          {"told_m", triple_json(shift->shift_m)},
          {"covariance_m2", covariance_json(shift->covariance_m2)},
          {"least_m", number_json(shift->least_m)},
          {"accuracy_m", number_json(shift->accuracy_m)},
          {"n_lines", shift->n_lines},
          {"n_planes", shift->n_planes},
          {"n_clusters", shift->n_clusters},
          {"by_plane_direction", directions_json(*shift)}};
}

std::optional<ConstantShift> parse_shift(const Json& json) {
  if (json.is_null()) return std::nullopt;
  try {
    return read_shift(json);
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("shift: ") + error.what() +
                                "; must be as this program writes it");
  }
}

}  // namespace ridgeline::evaluate
