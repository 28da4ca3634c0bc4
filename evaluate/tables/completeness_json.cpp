// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/completeness_json.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <array>
#include <stdexcept>
#include <string>

namespace ridgeline::evaluate {
namespace {

Json point_json(const Eigen::Vector3d& x) { return Json::array({x.x(), x.y(), x.z()}); }

Eigen::Vector3d parse_point(const Json& json) {
  const auto x = json.get<std::array<double, 3>>();
  return {x[0], x[1], x[2]};
}

Json row_json(const CompletenessRow& row) {
  return {{"kind", row.kind},
          {"length", row.length},
          {"n", row.n},
          {"n_found", row.n_found},
          {"recall", number_json(row.recall())},
          {"ci95", interval_json(row.ci95)},
          {"n_clusters", row.n_clusters},
          {"length_m", row.length_m},
          {"covered_m", row.covered_m},
          {"recall_length", number_json(row.recall_by_length())},
          {"n_not_in_images", row.n_not_shown}};
}

CompletenessRow parse_row(const Json& json) {
  CompletenessRow row{.kind = json.at("kind").get<std::string>(),
                      .length = json.at("length").get<std::string>(),
                      .n = json.at("n").get<std::size_t>(),
                      .n_found = json.at("n_found").get<std::size_t>(),
                      .n_not_shown = json.at("n_not_in_images").get<std::size_t>(),
                      .length_m = json.at("length_m").get<double>(),
                      .covered_m = json.at("covered_m").get<double>(),
                      .n_clusters = json.at("n_clusters").get<std::size_t>()};
  if (!json.at("ci95").is_null()) {
    const auto ends = json["ci95"].get<std::array<double, 2>>();
    row.ci95 = Interval{ends[0], ends[1]};
  }
  check(row.n_found <= row.n, "n_found: ", row.n_found, "; must be at most n, ", row.n);
  return row;
}

Json edge_json(const ExpectedEdge& edge, const Eigen::Vector3d& origin_m) {
  return {{"kind", edge.kind},
          {"start_m", point_json(edge.segment.start + origin_m)},
          {"end_m", point_json(edge.segment.end + origin_m)},
          {"length_m", edge.length_m},
          {"support", edge.support},
          {"covered_share", edge.covered},
          {"in_images", edge.is_shown},
          {"planes", edge.planes}};
}

ExpectedEdge parse_edge(const Json& json, const Eigen::Vector3d& origin_m) {
  return {.segment = {parse_point(json.at("start_m")) - origin_m,
                      parse_point(json.at("end_m")) - origin_m},
          .kind = json.at("kind").get<std::string>(),
          .length_m = json.at("length_m").get<double>(),
          .support = json.at("support").get<double>(),
          .covered = json.at("covered_share").get<double>(),
          .is_shown = json.at("in_images").get<bool>(),
          .planes = json.at("planes").get<std::vector<std::uint64_t>>()};
}

}  // namespace

Json completeness_json(const Completeness& completeness, const Eigen::Vector3d& origin_m) {
  Json json{{"area_from", completeness.area_from},
            {"area_m2", completeness.area_m2},
            {"n_lines", completeness.n_lines},
            {"n_lines_without_edge", completeness.n_without_edge},
            {"rows", transformed(completeness.rows, row_json)}};
  json["edges"] = transformed(completeness.edges,
                              [&](const ExpectedEdge& edge) { return edge_json(edge, origin_m); });
  return json;
}

Completeness parse_completeness(const Json& json, const Eigen::Vector3d& origin_m) {
  try {
    Completeness completeness{.area_from = json.at("area_from").get<std::string>(),
                              .area_m2 = json.at("area_m2").get<double>(),
                              .n_lines = json.at("n_lines").get<std::size_t>(),
                              .n_without_edge = json.at("n_lines_without_edge").get<std::size_t>()};
    completeness.rows = transformed(json.at("rows"), parse_row);
    completeness.edges =
        transformed(json.at("edges"), [&](const Json& edge) { return parse_edge(edge, origin_m); });
    return completeness;
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("completeness: ") + error.what());
  }
}

}  // namespace ridgeline::evaluate
