// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/lines/attributes.h"
#include "io/lines/json_text.h"
#include "io/lines/polyline.h"
#include "io/lines/readers.h"

#include <fmt/format.h>

#include <limits>
#include <map>

namespace ridgeline::io {
namespace {

using nlohmann::json;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

json parse(const std::string& path, std::string_view content) {
  if (!is_shallow_json(content)) {
    throw IoError(path, "is no GeoJSON: its arrays and objects lie too deep within each other");
  }
  try {
    return json::parse(content);
  } catch (const json::exception& error) {
    std::string message = error.what();  // "[json.exception...] parse error at line 1, column 5: "
    message.erase(0, message.find("] ") + 2);
    throw IoError(path, "is no GeoJSON: " + message);
  }
}

class GeoJsonReader {
 public:
  GeoJsonReader(const std::string& path, std::size_t n_bytes)
      : path_(path), set_(lines_for_file(path, "GeoJSON", n_bytes)) {}

  LineSet read(const json& document) {
    read_crs(document);
    const std::string type = type_of(document);
    if (type == "FeatureCollection") {
      const json& features = member(document, "features", path_);
      if (!features.is_array()) throw IoError(path_, "\"features\" is no array");
      for (const json& feature : features) read_feature(feature);
    } else if (type == "Feature") {
      read_feature(document);
    } else {
      read_feature({{"type", "Feature"}, {"properties", nullptr}, {"geometry", document}});
    }
    warn_of_other_types();
    return std::move(set_);
  }

 private:
  static const json& member(const json& object, const char* name, const std::string& where) {
    const auto it = object.find(name);
    if (it == object.end()) throw IoError(where, fmt::format("\"{}\" is missing", name));
    return *it;
  }

  [[nodiscard]] std::string type_of(const json& document) const {
    if (!document.is_object() || !document.contains("type") || !document["type"].is_string()) {
      throw IoError(path_, "is no GeoJSON: an object with \"type\" is expected");
    }
    return document["type"].get<std::string>();
  }

  /// `crs` is of GeoJSON 2008; RFC 7946 dropped it in favour of degrees, which cannot be judged.
  void read_crs(const json& document) {
    const auto crs = document.find("crs");
    if (crs == document.end()) {
      set_.warnings.push_back("no crs member: the coordinates are taken as metres");
      return;
    }
    if (crs->is_null()) return;
    const json name = crs->value(json::json_pointer("/properties/name"), json());
    if (!name.is_string()) throw IoError(path_, "\"crs\" has no properties.name");
    set_.crs.definition = name.get<std::string>();
  }

  void read_feature(const json& feature) {
    const std::string where = fmt::format("{}: feature {}", path_, number_);
    if (!feature.is_object()) throw IoError(where, "is no object");
    const json& geometry = member(feature, "geometry", where);
    const std::string type = geometry.is_null() ? "LineString" : type_of(geometry);
    if (type != "LineString" && type != "MultiLineString") {
      ++n_other_types_[type];
    } else {
      Line line = line_from_properties(feature.value("properties", json()), where);
      if (line.id.empty() && feature.contains("id")) line.id = text_of(feature["id"]);
      append_feature(line, parts_of(geometry, type, where), number_, set_);
    }
    ++number_;
  }

  static std::vector<Vertices> parts_of(const json& geometry,
                                        const std::string& type,
                                        const std::string& where) {
    if (geometry.is_null()) return {};
    const json& coordinates = member(geometry, "coordinates", where);
    if (!coordinates.is_array()) throw IoError(where, "\"coordinates\" is no array");
    if (type == "LineString") return {vertices_of(coordinates, where)};
    std::vector<Vertices> parts;
    for (const json& part : coordinates) parts.push_back(vertices_of(part, where));
    return parts;
  }

  static Vertices vertices_of(const json& positions, const std::string& where) {
    if (!positions.is_array()) throw IoError(where, "a line is no array of positions");
    Vertices vertices;
    for (const json& position : positions) vertices.push_back(vertex_of(position, where));
    return vertices;
  }

  /// JSON has no NaN: tools write null, which is kept as one. A missing z is one as well.
  static Eigen::Vector3d vertex_of(const json& position, const std::string& where) {
    if (!position.is_array() || position.size() < 2) {
      throw IoError(where, "position " + excerpt(position) + "; must be [x, y, z]");
    }
    Eigen::Vector3d vertex(kNaN, kNaN, kNaN);
    for (int axis = 0; axis < 3 && axis < static_cast<int>(position.size()); ++axis) {
      const json& value = position[static_cast<std::size_t>(axis)];
      if (value.is_null()) continue;
      if (!value.is_number()) {
        throw IoError(where, "coordinate " + excerpt(value) + " is no number");
      }
      vertex[axis] = value.get<double>();
    }
    return vertex;
  }

  void warn_of_other_types() {
    for (const auto& [type, count] : n_other_types_) {
      set_.warnings.push_back(fmt::format("{} features are no lines: {}", count, type));
    }
  }

  std::string path_;
  LineSet set_;
  std::size_t number_ = 0;
  std::map<std::string, int> n_other_types_;
};

}  // namespace

LineSet read_geojson(const std::string& path, std::string_view content) {
  return GeoJsonReader(path, content.size()).read(parse(path, content));
}

}  // namespace ridgeline::io
