// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/text_kind.h"

#include "io/kinds/orientation_kind.h"
#include "io/text/text.h"
#include "io/text/wkt.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {
namespace {

using enum FileGroup;

FileKind ours(FileGroup group, const char* what, const char* ending = "") {
  return {.group = group, .what = what, .advice = advice_on(group), .ending = ending};
}

FileKind not_read(const char* what, const char* advice = "which is not read") {
  return {.group = kOther, .what = what, .advice = advice};
}

FileKind city_json() { return ours(kModel, "a model of buildings (CityJSON)", ".city.json"); }

bool mentions(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

constexpr std::array kGeoJsonTypes{"FeatureCollection", "Feature",      "Point",
                                   "MultiPoint",        "LineString",   "MultiLineString",
                                   "Polygon",           "MultiPolygon", "GeometryCollection"};

/// The kind of a document in a format of exchange between programs; kUnknown for any other.
FileKind kind_of_interchange(const TopKeys& keys) {
  if (std::ranges::find(kGeoJsonTypes, keys.type) != kGeoJsonTypes.end()) {
    return ours(kLines, "GeoJSON", ".geojson");
  }
  if (keys.type == "CityJSONFeature") {
    return not_read("a feature of CityJSON", "give the whole file, which begins with \"CityJSON\"");
  }
  if (keys.type.starts_with("CityJSON") || keys.has("CityObjects")) {
    return city_json();
  }
  if (keys.type == "Topology") return not_read("TopoJSON", "save it as GeoJSON");
  if (keys.has("asset") && (keys.has("meshes") || keys.has("scenes"))) {
    return not_read("glTF, a mesh for display");
  }
  if (keys.has("geometryType") || keys.has("spatialReference")) {
    return not_read("JSON of Esri", "save it as GeoJSON");
  }
  // The type may stand behind the features, where it is not read.
  return keys.has("features") ? ours(kLines, "GeoJSON", ".geojson") : FileKind();
}

FileKind kind_of_result(const TopKeys& keys) {
  if (keys.has("patch") && keys.has("method") && keys.has("origin_m")) {
    return ours(kEvaluation, "an evaluation of lines (evaluation.METHOD.json)");
  }
  if (keys.has("command") && keys.has("versions")) {
    return ours(kResult, "the record of a run (run.json)");
  }
  if (keys.has("passed") && keys.has("gates")) return not_read("a report of gates");
  if (keys.has("comparisons")) return not_read("a comparison of results");
  if (!keys.names.empty() && keys.names.front() == "rows") {
    return ours(kResult, "a table of results");
  }
  return {};
}

/// The kind of a file that users write: the one of which it has the most keys, as single keys may
/// be wrong.
FileKind kind_of_settings(const TopKeys& keys) {
  if (keys.has("lines") && keys.has("lidar"))
    return not_read("a list of lines to judge", "judge them by evaluate --area and pool");
  if (keys.has("block")) return ours(kBlock, "a block file");
  const auto count = [&](std::initializer_list<const char*> known) {
    return std::ranges::count_if(known, [&](const char* name) { return keys.has(name); });
  };
  const std::array counts{count({"images", "colmap", "height_range", "lidar", "reference_matches",
                                 "reference_tracks", "reference_lines"}),
                          count({"gates"}),
                          count({"extract", "match", "chio", "reconstruct", "judge"})};
  const std::array kinds{ours(kPatch, "a patch file"), ours(kGates, "a gates file"),
                         ours(kConfig, "a config file")};
  const auto* const most = std::ranges::max_element(counts);
  if (*most == 0 || std::ranges::count(counts, *most) > 1) return {};
  return kinds[static_cast<std::size_t>(most - counts.begin())];
}

FileKind kind_of_xml(std::string_view start) {
  const auto holds = [&](std::string_view part) {
    return start.find(part) != std::string_view::npos;
  };
  if (holds("<kml")) return not_read("KML, whose coordinates are degrees", "project it");
  if (holds("<VRTDataset")) return not_read("XML of a VRT", "give the images that it names");
  if (holds("<html")) return not_read("a web page", "perhaps of a failed download");
  constexpr const char* kAdvice = "which is not read, save its lines as GeoPackage";
  if (holds("CityModel")) return ours(kModel, "a model of buildings (CityGML)", ".gml");
  return not_read("XML, as of GML", kAdvice);
}

/// The fields of a row in lower case, without quotes, whatever divides them.
std::vector<std::string> fields_of_any(std::string_view row) {
  std::vector<std::string> fields(1);
  for (const char c : lower_case(row)) {
    const bool divides = std::string_view(",;\t |").find(c) != std::string_view::npos;
    if (divides && !fields.back().empty()) fields.emplace_back();
    if (!divides && c != '"') fields.back() += c;
  }
  if (fields.back().empty()) fields.pop_back();
  return fields;
}

/// The kind of a table by the names of its columns.
FileKind kind_of_table(const std::vector<std::string>& names) {
  const auto has = [&](std::initializer_list<const char*> wanted) {
    return std::ranges::all_of(
        wanted, [&](const char* name) { return std::ranges::find(names, name) != names.end(); });
  };
  if (has({"x1", "y1", "z1", "x2", "y2", "z2"})) return ours(kLines, "a CSV of 3D lines", ".csv");
  if (has({"wkt"})) return ours(kLines, "lines as WKT", ".wkt");
  if (has({"left_id", "right_id"})) return ours(kMatches, "a table of matches");
  if (has({"left_x1_px", "right_x1_px"})) {
    return ours(kReferenceMatches, "a table of reference matches");
  }
  if (has({"edge", "image", "x1_px", "y1_px", "x2_px", "y2_px"})) {
    return ours(kReferenceTracks, "a table of reference tracks");
  }
  if (has({"track", "image", "segment"})) return ours(kResult, "a table of tracks");
  if (has({"x1_px", "y1_px", "x2_px", "y2_px"})) return ours(kSegments, "a table of segments");
  if (has({"left_id", "reason"})) return ours(kResult, "a table of unmatched segments");
  if (has({"patch", "class", "status", "start_distance_m"})) {
    return ours(kResult, "a table of judged lines");
  }
  const bool is_by_patch = names.size() > 2 && names[0] == "patch";
  if (is_by_patch && (names[1] == "method" || names[1] == "matcher")) {
    return ours(kResult, "a table of results");
  }
  return {};
}

bool is_numbers(const std::vector<std::string>& fields) {
  constexpr std::size_t kMinFields = 3;  // x, y and z
  return fields.size() >= kMinFields && std::ranges::all_of(fields, [](const std::string& field) {
           return to_double(field).has_value();
         });
}

/// Whether a row is WKT or holds it in a column.
bool holds_wkt(const TextRow& row) {
  return begins_as_wkt(row.text) || lower_case(row.text).find("linestring") != std::string::npos;
}

/// The kind of a text by its rows that are no comments.
FileKind kind_of_rows(std::span<const TextRow> rows) {
  if (std::ranges::any_of(rows.first(std::min<std::size_t>(rows.size(), 2)), holds_wkt)) {
    return ours(kLines, "lines as WKT", ".wkt");
  }
  if (rows.size() > 1 && rows[0].text == "0" && rows[1].text == "SECTION") {
    return ours(kLines, "a DXF drawing", ".dxf");
  }
  const std::vector<std::string> first = fields_of_any(rows[0].text);
  if (FileKind kind = kind_of_table(first); kind.is_known()) return kind;
  if (rows[0].text.starts_with("v ") || rows[0].text.starts_with("mtllib ")) {
    return ours(kLines, "a mesh or lines (OBJ)", ".obj");
  }
  // the first row may name the columns or count the points
  if (is_numbers(rows.size() > 1 ? fields_of_any(rows[1].text) : first)) {
    return ours(kNumbers, "text of numbers, as of a point cloud or lines");
  }
  return {};
}

FileKind kind_of_orientation(OrientationFormat format) {
  if (format == OrientationFormat::kRollPitchYaw) {
    return not_read(what_is(format), "give omega, phi and kappa");
  }
  return ours(kOrientation, what_is(format));
}

bool is_aside(const TextRow& row) {
  return row.text.starts_with('#') || row.text.starts_with("//") || row.text.starts_with("sep=");
}

}  // namespace

FileKind kind_of_document(const TopKeys& keys) {
  for (const auto kind_of : {kind_of_interchange, kind_of_result, kind_of_settings}) {
    if (FileKind kind = kind_of(keys); kind.is_known()) return kind;
  }
  return {};
}

FileKind kind_of_text(std::string_view start, bool is_whole) {
  std::vector<TextRow> rows = rows_of(start);
  if (const auto format = orientation_format(start)) return kind_of_orientation(*format);
  if (!rows.empty() && rows.front().text.starts_with('<')) return kind_of_xml(start);
  // The keys of a sequence would be those of its last document.
  if (mentions(start, "\"CityJSON\"") && mentions(start, "\"CityJSONFeature\"")) return city_json();
  if (FileKind kind = kind_of_document(top_keys(start)); kind.is_known()) return kind;
  const bool is_json =
      !rows.empty() && (rows.front().text.starts_with('{') || rows.front().text.starts_with('['));
  if (is_json) return {};  // the rows of JSON say nothing
  if (!is_whole && rows.size() > 1) rows.pop_back();
  std::erase_if(rows, is_aside);
  return rows.empty() ? FileKind() : kind_of_rows(rows);
}

}  // namespace ridgeline::io
