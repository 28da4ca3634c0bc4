// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/text_kind.h"

#include "io/kinds/marks.h"
#include "io/kinds/orientation_kind.h"
#include "io/text/text.h"
#include "io/text/wkt.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {
namespace {

using enum FileGroup;

constexpr const char* kGeoJson = "GeoJSON";
constexpr const char* kWkt = "lines as WKT";
constexpr const char* kCityJson = "a building model (CityJSON)";
constexpr const char* kUnread = "which is not supported";
constexpr const char* kAsGeoJson = "save it as GeoJSON";
constexpr const char* kGeoJsonTypes =
    "FeatureCollection Feature Point MultiPoint LineString MultiLineString Polygon MultiPolygon "
    "GeometryCollection";

/// A kind of document or table, identified by the names in it.
struct KnownMember {
  const char* what;
  FileGroup group;
  const char* names;        ///< of keys or columns, as words, all of which must be present
  const char* advice = "";  ///< if it differs from the advice for the group
  const char* ending = "";
};

/// Documents identified by their outermost key `type`, whose value is one of the names.
constexpr std::array kDocumentTypes{
    KnownMember{kGeoJson, kLines, kGeoJsonTypes, "", ".geojson"},
    KnownMember{"a CityJSON feature", kOther, "CityJSONFeature",
                "give the whole file, which begins with \"CityJSON\""},
    KnownMember{kCityJson, kModel, "CityJSON CityJSONExtension", "", ".city.json"},
    KnownMember{"TopoJSON", kOther, "Topology", kAsGeoJson}};

/// Documents identified by their outermost keys; the first entry with all of them counts.
constexpr std::array kDocuments{
    KnownMember{kCityJson, kModel, "CityObjects", "", ".city.json"},
    KnownMember{"glTF, a mesh for display", kOther, "asset meshes", kUnread},
    KnownMember{"glTF, a mesh for display", kOther, "asset scenes", kUnread},
    KnownMember{"Esri JSON", kOther, "geometryType", kAsGeoJson},
    KnownMember{"Esri JSON", kOther, "spatialReference", kAsGeoJson},
    // the type may follow the features, beyond the part that is read
    KnownMember{kGeoJson, kLines, "features", "", ".geojson"},
    KnownMember{"an evaluation of lines (evaluation.METHOD.json)", kEvaluation,
                "patch method origin_m"},
    KnownMember{"the record of a run (run.json)", kResult, "command versions"},
    KnownMember{"a gate report", kOther, "passed gates", kUnread},
    KnownMember{"a comparison of results", kOther, "comparisons", kUnread},
    KnownMember{"a table of results", kResult, "rows"},
    KnownMember{"a list of lines to judge", kOther, "lines lidar",
                "judge them by evaluate with `area`, and pool the results"},
    KnownMember{"a block file", kBlock, "block"}};

/// Files that users write, identified by the largest number of matching keys, because individual
/// keys may be wrong.
constexpr std::array kSettings{
    KnownMember{
        "a patch file", kPatch,
        "images colmap height_range lidar reference_matches reference_tracks reference_lines"},
    KnownMember{"a gates file", kGates, "gates"},
    KnownMember{"a config file", kConfig, "extract match chio reconstruct judge"}};

/// Tables identified by their column names; the first entry with all of them counts.
constexpr std::array kTables{
    KnownMember{"a CSV of 3D lines", kLines, "x1 y1 z1 x2 y2 z2", "", ".csv"},
    KnownMember{kWkt, kLines, "wkt", "", ".wkt"},
    KnownMember{"a table of matches", kMatches, "left_id right_id"},
    KnownMember{"a table of reference matches", kReferenceMatches, "left_x1_px right_x1_px"},
    KnownMember{"a table of reference tracks", kReferenceTracks,
                "edge image x1_px y1_px x2_px y2_px"},
    KnownMember{"a table of tracks", kResult, "track image segment"},
    KnownMember{"a table of segments", kSegments, "x1_px y1_px x2_px y2_px"},
    KnownMember{"a table of unmatched segments", kResult, "left_id reason"},
    KnownMember{"a table of judged lines", kResult, "patch class status start_distance_m"},
    KnownMember{"a table of results", kResult, "patch method"},
    KnownMember{"a table of results", kResult, "patch matcher"}};

FileKind kind_of(const KnownMember& known) {
  return {.group = known.group,
          .what = known.what,
          .advice = *known.advice != '\0' ? known.advice : info_of(known.group).advice,
          .ending = known.ending};
}

/// The first kind whose names are all present; kUnknown if there is none.
FileKind first_of(std::span<const KnownMember> table, std::span<const std::string> names) {
  const auto fits = [&](const KnownMember& known) {
    return std::ranges::all_of(words_of(known.names), [&](std::string_view name) {
      return std::ranges::find(names, name) != names.end();
    });
  };
  const auto found = std::ranges::find_if(table, fits);
  return found == table.end() ? FileKind() : kind_of(*found);
}

FileKind kind_of_settings(const TopKeys& keys) {
  std::array<std::ptrdiff_t, kSettings.size()> counts{};
  std::ranges::transform(kSettings, counts.begin(), [&](const KnownMember& known) {
    return std::ranges::count_if(words_of(known.names),
                                 [&](std::string_view name) { return keys.has(name); });
  });
  const auto* const most = std::ranges::max_element(counts);
  if (*most == 0 || std::ranges::count(counts, *most) > 1) return {};
  return kind_of(kSettings.at(static_cast<std::size_t>(most - counts.begin())));
}

bool mentions(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

FileKind kind_of_xml(std::string_view start) {
  if (mentions(start, "<kml")) return format_with_extension(".kml");
  if (mentions(start, "<VRTDataset")) return format_with_extension(".vrt");
  if (mentions(start, "<html")) return format_with_extension(".html");
  if (!mentions(start, "CityModel")) return format_with_extension(".xml");
  return kind_of({"a building model (CityGML)", kModel, "", "", ".gml"});
}

/// The fields of a row in lower case, without quotes, whatever the separator.
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

bool is_numbers(const std::vector<std::string>& fields) {
  constexpr std::size_t kMinFields = 3;  // x, y and z
  return fields.size() >= kMinFields && std::ranges::all_of(fields, [](const std::string& field) {
           return to_double(field).has_value();
         });
}

/// Whether a row is WKT or contains it in a column.
bool holds_wkt(const TextRow& row) {
  return begins_as_wkt(row.text) || lower_case(row.text).find("linestring") != std::string::npos;
}

/// Identifies a text by its rows without comments.
FileKind kind_of_rows(std::span<const TextRow> rows) {
  if (std::ranges::any_of(rows.first(std::min<std::size_t>(rows.size(), 2)), holds_wkt)) {
    return kind_of({kWkt, kLines, "", "", ".wkt"});
  }
  if (rows.size() > 1 && rows[0].text == "0" && rows[1].text == "SECTION") {
    return format_with_extension(".dxf");
  }
  const std::vector<std::string> first = fields_of_any(rows[0].text);
  if (FileKind kind = first_of(kTables, first); kind.is_known()) return kind;
  if (const auto word = words_of(rows[0].text).front(); word == "v" || word == "mtllib") {
    return format_with_extension(".obj");
  }
  // the first row may name the columns or count the points
  if (is_numbers(rows.size() > 1 ? fields_of_any(rows[1].text) : first)) {
    return kind_of({"text with numbers, such as a point cloud or lines", kNumbers, ""});
  }
  return {};
}

FileKind kind_of_orientation(OrientationFormat format) {
  const bool is_refused = format == OrientationFormat::kRollPitchYaw;
  return is_refused ? kind_of({what_is(format), kOther, "", "give omega, phi and kappa"})
                    : kind_of({what_is(format), kOrientation, ""});
}

bool is_aside(const TextRow& row) {
  return row.text.starts_with('#') || row.text.starts_with("//") || row.text.starts_with("sep=");
}

}  // namespace

FileKind kind_of_document(const TopKeys& keys) {
  const auto of_type = std::ranges::find_if(kDocumentTypes, [&](const KnownMember& known) {
    return std::ranges::count(words_of(known.names), keys.type) > 0;
  });
  if (of_type != kDocumentTypes.end()) return kind_of(*of_type);
  const FileKind kind = first_of(kDocuments, keys.names);
  return kind.is_known() ? kind : kind_of_settings(keys);
}

FileKind kind_of_text(std::string_view start, bool is_whole) {
  std::vector<TextRow> rows = rows_of(start);
  if (const auto format = orientation_format(start)) return kind_of_orientation(*format);
  if (!rows.empty() && rows.front().text.starts_with('<')) return kind_of_xml(start);
  // The keys of a sequence would be those of its last document.
  if (mentions(start, "\"CityJSON\"") && mentions(start, "\"CityJSONFeature\""))
    return kind_of(kDocuments.front());
  if (FileKind kind = kind_of_document(top_keys(start)); kind.is_known()) return kind;
  const bool is_json =
      !rows.empty() && (rows.front().text.starts_with('{') || rows.front().text.starts_with('['));
  if (is_json) return {};  // the rows of JSON are not conclusive
  if (!is_whole && rows.size() > 1) rows.pop_back();
  std::erase_if(rows, is_aside);
  return rows.empty() ? FileKind() : kind_of_rows(rows);
}

}  // namespace ridgeline::io
