// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/model_writers.h"
#include "io/text/json_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <variant>
#include <vector>

namespace ridgeline::io {
namespace {

using nlohmann::json;

/// The vertices of a file, each once, in whole thousandths relative to a corner.
class VertexList {
 public:
  explicit VertexList(const BuildingModel& model) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    Eigen::Vector3d low = Eigen::Vector3d::Constant(kNone);
    for (const Face& face : model.faces) {
      for (const Ring& ring : face.rings) {
        for (const Eigen::Vector3d& vertex : ring) low = low.cwiseMin(vertex);
      }
    }
    if (!model.faces.empty()) corner_ = low.array().floor();
  }

  std::size_t place_of(const Eigen::Vector3d& vertex) {
    std::array<long long, 3> key{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // each is rounded separately, because the difference of large numbers would depend on the
      // corner
      const auto i = static_cast<Eigen::Index>(axis);
      key[axis] = in_thousandths(vertex[i]) - in_thousandths(corner_[i]);
    }
    const auto [entry, is_new] = places_.try_emplace(key, vertices_.size());
    if (is_new) vertices_.push_back(key);
    return entry->second;
  }

  [[nodiscard]] const Eigen::Vector3d& corner() const { return corner_; }
  [[nodiscard]] const std::vector<std::array<long long, 3>>& vertices() const { return vertices_; }

 private:
  Eigen::Vector3d corner_ = Eigen::Vector3d::Zero();
  std::map<std::array<long long, 3>, std::size_t> places_;
  std::vector<std::array<long long, 3>> vertices_;
};

json rings_json(const Face& face, VertexList& vertices) {
  json rings = json::array();
  for (const Ring& ring : face.rings) {
    json indices = json::array();
    for (const Eigen::Vector3d& vertex : ring) indices.push_back(vertices.place_of(vertex));
    rings.push_back(std::move(indices));
  }
  return rings;
}

/// One semantic surface for each face with an id, and one per kind for all faces without an id.
json semantics_json(std::span<const Face> faces) {
  json surfaces = json::array();
  json values = json::array();
  std::map<std::pair<FaceKind, std::string>, std::size_t> places;
  for (const Face& face : faces) {
    const char* const type = surface_name(face.kind);
    if (type == nullptr) {
      values.push_back(nullptr);
      continue;
    }
    const auto [entry, is_new] = places.try_emplace({face.kind, face.id}, surfaces.size());
    if (is_new) {
      json surface = {{"type", type}};
      if (!face.id.empty()) surface["id"] = face.id;
      surfaces.push_back(std::move(surface));
    }
    values.push_back(entry->second);
  }
  return {{"surfaces", std::move(surfaces)}, {"values", std::move(values)}};
}

json geometry_json(const Building& building, std::span<const Face> faces, VertexList& vertices) {
  json boundaries = json::array();
  for (const Face& face : faces) boundaries.push_back(rings_json(face, vertices));
  json semantics = semantics_json(faces);
  const bool is_solid = are_closed(faces);
  if (is_solid) {  // with one shell
    boundaries = json::array({std::move(boundaries)});
    semantics["values"] = json::array({std::move(semantics["values"])});
  }
  json geometry = {{"type", is_solid ? "Solid" : "MultiSurface"},
                   {"lod", building.lod.empty() ? "2" : building.lod},
                   {"boundaries", std::move(boundaries)}};
  if (!semantics["surfaces"].empty()) geometry["semantics"] = std::move(semantics);
  return geometry;
}

json value_json(const Value& value, ColumnType type) {
  if (const auto* const n = std::get_if<std::int64_t>(&value))
    return type == ColumnType::kBoolean ? json(*n != 0) : json(*n);
  if (const auto* const x = std::get_if<double>(&value))
    return std::isfinite(*x) ? json(*x) : json();
  if (const auto* const text = std::get_if<std::string>(&value)) return *text;
  return {};
}

json attributes_json(const AttributeTable& table, std::size_t row) {
  json attributes = json::object();
  for (const auto& [column, value] : table.rows[row]) {
    attributes[table.columns[column].name] = value_json(value, table.columns[column].type);
  }
  return attributes;
}

std::string metadata_text(const Crs& crs) {
  const EpsgCodes codes = epsg_codes_of(crs);
  const std::optional<std::string> code = codes.whole ? codes.whole : codes.plane;
  if (!code) return "";
  return fmt::format(
      "\"metadata\":{{\"referenceSystem\":\"https://www.opengis.net/def/crs/EPSG/0/{}\"}},\n",
      *code);
}

}  // namespace

void write_cityjson(const BuildingModel& model, std::ostream& stream) {
  VertexList vertices(model);
  const Eigen::Vector3d& corner = vertices.corner();
  stream << "{\"type\":\"CityJSON\",\"version\":\"2.0\",\n"
         << fmt::format(
                "\"transform\":{{\"scale\":[0.001,0.001,0.001],\"translate\":[{:.0f},{:.0f},{:.0f}]"
                "}},\n",
                corner.x(), corner.y(), corner.z())
         << metadata_text(model.crs) << "\"CityObjects\":{";
  std::size_t first = 0;
  for (std::size_t i = 0; i < model.buildings.size(); ++i) {
    std::size_t end = first;
    while (end < model.faces.size() && model.faces[end].building == i) ++end;
    const std::span faces(model.faces.data() + first, end - first);
    json object = {{"type", "Building"}};
    if (!model.attributes.rows[i].empty())
      object["attributes"] = attributes_json(model.attributes, i);
    if (!faces.empty())
      object["geometry"] = json::array({geometry_json(model.buildings[i], faces, vertices)});
    stream << (i == 0 ? "\n" : ",\n") << json_text(model.buildings[i].id) << ":"
           << json_text(object);
    first = end;
  }
  stream << "\n},\n\"vertices\":[";
  for (std::size_t i = 0; i < vertices.vertices().size(); ++i) {
    const auto& [x, y, z] = vertices.vertices()[i];
    stream << fmt::format("{}[{},{},{}]", i == 0 ? "\n" : ",\n", x, y, z);
  }
  stream << "\n]}\n";
}

}  // namespace ridgeline::io
