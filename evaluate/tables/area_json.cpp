// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/area_json.h"

#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace ridgeline::evaluate {
namespace {

constexpr std::array kAllKinds{DecoyKind::kHeight, DecoyKind::kAcross, DecoyKind::kMatch,
                               DecoyKind::kElsewhere};

std::string vector_text(const Eigen::Vector3d& x) {
  return fmt::format(" {:.6g} {:.6g} {:.6g}", x.x(), x.y(), x.z());
}

/// "7 12 height 0.5 0.4871": the decoy's number, line, kind and displacement, and its mean distance
/// from its planes, or "-" if it was not evaluated. For a line moved elsewhere, its ends and planes
/// follow.
std::string decoy_text(const JudgedDecoy& judged) {
  const auto& [parent, kind, distance_m, line, number] = judged.decoy;
  std::string text = fmt::format("{} {} {} {}", number, parent, name(kind), distance_m);
  if (judged.evaluation.status != Status::kEvaluated) return text + " -";
  text += fmt::format(" {:.6g}", *judged.evaluation.mean_distance_m);
  if (kind != DecoyKind::kElsewhere) return text;
  text += vector_text(line.segment.start) + vector_text(line.segment.end);
  for (const JudgingPlane& p : judged.evaluation.planes) {
    const Eigen::Vector3d n = p.plane.normal();
    text += fmt::format(" {:.9g} {:.9g} {:.9g} {:.9g}", n.x(), n.y(), n.z(), p.plane.offset());
  }
  return text;
}

DecoyKind kind_named(std::string_view text) {
  for (const DecoyKind kind : kAllKinds) {
    if (text == name(kind)) return kind;
  }
  throw std::invalid_argument(fmt::format("decoy: {}; must be a kind of decoy", text));
}

JudgedDecoy parse_decoy(const std::string& text) {
  std::istringstream words(text);
  JudgedDecoy judged;
  std::string kind, mean_m;
  words >> judged.decoy.number >> judged.decoy.parent >> kind >> judged.decoy.distance_m >> mean_m;
  check(!words.fail(), "decoy: ", text, "; must be a number, a line, a kind and two distances");
  judged.decoy.kind = kind_named(kind);
  judged.evaluation.status = Status::kNoPlane;
  if (mean_m == "-") return judged;
  judged.evaluation.status = Status::kEvaluated;
  judged.evaluation.mean_distance_m = std::stod(mean_m);
  auto& [start, end] = judged.decoy.line.segment;
  words >> start.x() >> start.y() >> start.z() >> end.x() >> end.y() >> end.z();
  for (Eigen::Vector4d p; words >> p[0] >> p[1] >> p[2] >> p[3];) {
    const double size = p.head<3>().norm();
    judged.evaluation.planes.emplace_back().plane = Plane3(p.head<3>() / size, p[3] / size);
  }
  return judged;
}

}  // namespace

Json area_json(const AreaPart& area) {
  Json decoys = Json::array();
  for (const JudgedDecoy& decoy : area.decoys) decoys.push_back(decoy_text(decoy));
  Json json{{"bounds", area.bounds}, {"n_lines", area.n_lines}, {"decoys", std::move(decoys)}};
  for (const AreaBuilding& building : area.buildings) {
    json["buildings"].push_back({{"number", building.number}, {"by", building.by}});
  }
  return json;
}

AreaPart parse_area(const Json& json) {
  try {
    AreaPart area;
    area.bounds = json.at("bounds").get<std::array<double, 4>>();
    area.n_lines = json.at("n_lines").get<std::size_t>();
    for (const Json& decoy : json.at("decoys")) {
      area.decoys.push_back(parse_decoy(decoy.get<std::string>()));
    }
    for (const Json& building : json.value("buildings", Json::array())) {
      area.buildings.push_back({building.at("number").get<std::size_t>(),
                                building.at("by").get<std::vector<std::string>>()});
    }
    return area;
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("area: ") + error.what());
  }
}

std::string points_text(const PlanePoints& points) {
  std::string text = fmt::format("{}", points.n);
  for (const SharedPoints& shared : points.shared) {
    text += fmt::format(" {} {} {}", shared.line, shared.plane, shared.n);
  }
  return text;
}

PlanePoints parse_points(const std::string& text) {
  std::istringstream words(text);
  PlanePoints points;
  words >> points.n;
  check(!words.fail(), "points: ", text, "; must be numbers");
  for (SharedPoints s; words >> s.line >> s.plane >> s.n;) points.shared.push_back(s);
  return points;
}

}  // namespace ridgeline::evaluate
