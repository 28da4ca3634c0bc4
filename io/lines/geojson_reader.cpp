// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/gdal/json_columns.h"
#include "io/gdal/ogr_support.h"
#include "io/kinds/recognise.h"
#include "io/kinds/text_kind.h"
#include "io/lines/attributes.h"
#include "io/lines/feature_collector.h"
#include "io/lines/readers.h"
#include "io/text/json_text.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <utility>

namespace ridgeline::io {
namespace {

using nlohmann::json;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TopKeys keys_of(const json& document) {
  TopKeys keys;
  if (!document.is_object()) return keys;
  for (const auto& [name, value] : document.items()) {
    keys.names.push_back(name);
    if (name == "type" && value.is_string()) keys.type = value.get<std::string>();
  }
  return keys;
}

[[noreturn]] void refuse_no_json(const std::string& path, const json::exception& error) {
  std::string message = error.what();  // "[json.exception...] parse error at line 1, column 5: "
  message.erase(0, message.find("] ") + 2);
  if (message.find("expected end of input") != std::string::npos) {
    message += "; save a sequence of JSON texts as one FeatureCollection";
  }
  throw IoError(path, "is not GeoJSON: " + message);
}

json parse(const std::string& path, std::string_view content) {
  if (!is_shallow_json(content)) {
    throw IoError(path, "is not GeoJSON: its arrays and objects are nested too deeply");
  }
  try {
    return json::parse(content);
  } catch (const json::exception& error) {
    refuse_no_json(path, error);
  }
}

class GeoJsonReader {
 public:
  GeoJsonReader(const std::string& path, std::size_t n_bytes)
      : path_(path), set_(lines_for_file(path, "GeoJSON", n_bytes)), features_(set_) {}

  LineSet read(const json& document) {
    const FileKind kind = kind_of_document(keys_of(document));
    if (kind.group == FileGroup::kOther) throw IoError(path_, refusal(kind, FileGroup::kLines));
    const std::string type = type_of(document);
    read_crs(document);
    if (type == "FeatureCollection") {
      const json& features = member(document, "features", path_);
      if (!features.is_array()) throw IoError(path_, "\"features\" is not an array");
      for (const json& feature : features) read_feature(feature);
    } else if (type == "Feature") {
      read_feature(document);
    } else {
      lone_geometry_ = {{"type", "Feature"}, {"properties", nullptr}, {"geometry", document}};
      read_feature(lone_geometry_);
    }
    features_.finish();
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
      throw IoError(path_, "is not GeoJSON: an object with \"type\" is expected");
    }
    return document["type"].get<std::string>();
  }

  /// Reads `crs`, which belongs to GeoJSON 2008. RFC 7946 dropped it in favour of degrees, which
  /// cannot be judged.
  void read_crs(const json& document) {
    const auto crs = document.find("crs");
    if (crs == document.end()) {
      set_.warnings.push_back(
          "no crs member: assuming the reference system and units of the cloud");
      return;
    }
    if (crs->is_null()) return;
    const json name = crs->value(json::json_pointer("/properties/name"), json());
    if (!name.is_string()) throw IoError(path_, "\"crs\" has no properties.name");
    const auto definition = name.get<std::string>();
    if (definition.find(kUndefinedPlane) == std::string::npos) set_.crs.definition = definition;
  }

  void read_feature(const json& feature) {
    const std::string where = fmt::format("{}: feature {}", path_, number_);
    if (!feature.is_object()) throw IoError(where, "is not an object");
    Feature found;
    collect(member(feature, "geometry", where), where, found.geometry);
    found.properties = feature.value("properties", json());
    found.fid = number_++;
    found.where = where;
    if (const auto id = feature.find("id"); id != feature.end()) {
      found.id = text_of(*id);
      if (id->is_number_integer()) found.fid = id->get<std::int64_t>();
    }
    const auto properties = feature.find("properties");
    if (properties != feature.end()) {
      found.values = [this, &held = *properties] { return columns_.row_of(held, set_.features); };
    }
    features_.add(std::move(found));
  }

  void collect(const json& geometry, const std::string& where, FeatureGeometry& found) const {
    if (geometry.is_null()) return;
    const std::string type = type_of(geometry);
    const auto each_of = [&](const char* name, const auto& take) {
      const json& list = member(geometry, name, where);
      if (!list.is_array()) throw IoError(where, fmt::format("\"{}\" is not an array", name));
      for (const json& element : list) take(element);
    };
    const auto add_line = [&](const json& line) {
      found.lines.push_back(vertices_of(line, where));
    };
    const auto add_polygon = [&](const json& polygon) {
      found.add_polygon(rings_of(polygon, where));
    };
    if (type == "LineString") {
      add_line(member(geometry, "coordinates", where));
    } else if (type == "MultiLineString") {
      each_of("coordinates", add_line);
    } else if (type == "Polygon") {
      add_polygon(member(geometry, "coordinates", where));
    } else if (type == "MultiPolygon") {
      each_of("coordinates", add_polygon);
    } else if (type == "MultiPoint") {
      each_of("coordinates", [&](const json&) { found.others.add(kinds::kPoint); });
    } else if (type == "GeometryCollection") {
      each_of("geometries", [&](const json& element) { collect(element, where, found); });
    } else {
      found.others.add(type == "Point" ? kinds::kPoint : LeftOutKind{type, type});
    }
  }

  static std::vector<Vertices> rings_of(const json& polygon, const std::string& where) {
    if (!polygon.is_array()) throw IoError(where, "a polygon is not an array of rings");
    return transformed(polygon, [&](const json& ring) { return vertices_of(ring, where); });
  }

  static Vertices vertices_of(const json& positions, const std::string& where) {
    if (!positions.is_array()) throw IoError(where, "a line is not an array of positions");
    Vertices vertices;
    for (const json& position : positions) vertices.push_back(vertex_of(position, where));
    return vertices;
  }

  /// JSON has no NaN, so tools write null, which is read as NaN. A missing z is read as NaN as
  /// well.
  static Eigen::Vector3d vertex_of(const json& position, const std::string& where) {
    if (!position.is_array() || position.size() < 2) {
      throw IoError(where, "position " + excerpt(position) + "; must be [x, y, z]");
    }
    Eigen::Vector3d vertex(kNaN, kNaN, kNaN);
    for (int axis = 0; axis < 3 && axis < static_cast<int>(position.size()); ++axis) {
      const json& value = position[static_cast<std::size_t>(axis)];
      if (value.is_null()) continue;
      if (!value.is_number()) {
        throw IoError(where, "coordinate " + excerpt(value) + " is not a number");
      }
      vertex[axis] = value.get<double>();
    }
    return vertex;
  }

  std::string path_;
  LineSet set_;
  FeatureCollector features_;
  json lone_geometry_;  ///< a geometry that is not in a feature, wrapped in one
  std::int64_t number_ = 0;
  JsonColumns columns_;
};

}  // namespace

LineSet read_geojson(const std::string& path, std::string_view content) {
  return GeoJsonReader(path, content.size()).read(parse(path, content));
}

}  // namespace ridgeline::io
