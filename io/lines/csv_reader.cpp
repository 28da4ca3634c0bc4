// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/gdal/ogr_support.h"
#include "io/lines/feature_collector.h"
#include "io/lines/ogr_geometry.h"
#include "io/lines/readers.h"
#include "io/text/table_row.h"
#include "io/text/text.h"
#include "io/text/wkt.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace ridgeline::io {
namespace {

constexpr std::array<std::string_view, 6> kCoordinates{"x1", "y1", "z1", "x2", "y2", "z2"};
constexpr std::array<std::string_view, 5> kWktNames{"wkt", "geometry", "geom", "the_geom",
                                                    "wkt_geom"};

/// Takes the place of the separator if the row is a single field.
constexpr char kOneField = '\0';

/// The separator of a row: the first of the list ; tab , | that occurs outside quotes, otherwise a
/// blank if there are several words.
char separator_of_lines(std::string_view row) {
  std::string unquoted;
  bool quoted = false;
  for (const char c : row) {
    if (c == '"') quoted = !quoted;
    if (!quoted && c != '"') unquoted += c;
  }
  for (const char separator : {';', '\t', ',', '|'}) {
    if (unquoted.find(separator) != std::string::npos) return separator;
  }
  return words_of(unquoted).size() > 1 ? ' ' : kOneField;
}

std::vector<std::string> row_fields(std::string_view row,
                                    char separator,
                                    const std::string& where) {
  if (separator == ' ') {
    const std::vector<std::string_view> words = words_of(row);
    return {words.begin(), words.end()};
  }
  if (separator == kOneField && !row.starts_with('"')) return {std::string(row)};
  return csv_fields_of(row, separator, where);
}

/// A number; its decimal mark may be a comma if commas do not separate the fields.
std::optional<double> coordinate_of(const std::string& word, char separator) {
  return separator == ',' ? to_double(word) : table_number(word);
}

/// Where a row holds a line's geometry.
struct Columns {
  std::vector<std::string> names;
  std::optional<std::size_t> wkt;
  std::array<std::size_t, 6> coordinates{};
};

std::optional<std::size_t> find(const std::vector<std::string>& names, std::string_view name) {
  const auto it = std::find(names.begin(), names.end(), name);
  if (it == names.end()) return std::nullopt;
  return static_cast<std::size_t>(it - names.begin());
}

bool has_coordinates(const std::vector<std::string>& names) {
  return std::ranges::all_of(kCoordinates,
                             [&](std::string_view name) { return find(names, name).has_value(); });
}

/// The WKT column, found by its name, otherwise by the contents of the first row.
std::optional<std::size_t> wkt_column(const std::vector<std::string>& names,
                                      const std::vector<std::string>& first_row) {
  for (const std::string_view name : kWktNames) {
    if (const auto column = find(names, name)) return column;
  }
  if (has_coordinates(names)) return std::nullopt;
  const auto found = std::ranges::find_if(first_row, begins_as_wkt);
  if (found == first_row.end()) return std::nullopt;
  return static_cast<std::size_t>(found - first_row.begin());
}

std::vector<std::string> lower_case_names(const std::vector<std::string>& header) {
  std::vector<std::string> names(header.size());
  std::ranges::transform(header, names.begin(), lower_case);
  return names;
}

Columns columns_of(const std::vector<std::string>& header,
                   const std::vector<std::string>& first_row,
                   const std::string& where) {
  Columns columns;
  columns.names = lower_case_names(header);
  columns.wkt = wkt_column(columns.names, first_row);
  if (columns.wkt) return columns;
  for (std::size_t i = 0; i < kCoordinates.size(); ++i) {
    const std::optional<std::size_t> column = find(columns.names, kCoordinates[i]);
    if (!column) {
      throw IoError(where,
                    fmt::format("no column {}; a header with x1,y1,z1,x2,y2,z2 or wkt, or rows of "
                                "six numbers are expected",
                                kCoordinates[i]));
    }
    columns.coordinates[i] = *column;
  }
  return columns;
}

bool is_bare(const std::vector<std::string>& fields, char separator) {
  return fields.size() == 6 && std::ranges::all_of(fields, [&](const std::string& field) {
           return coordinate_of(field, separator).has_value();
         });
}

Vertices coordinates_of(const std::vector<std::string>& fields,
                        const Columns& columns,
                        char separator,
                        const std::string& where) {
  std::array<double, 6> v{};
  for (std::size_t i = 0; i < v.size(); ++i) {
    const std::string& word = fields[columns.coordinates[i]];
    const std::optional<double> number = coordinate_of(word, separator);
    if (!number) throw IoError(where, "'" + word.substr(0, 40) + "' is not a number");
    v[i] = *number;
  }
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

/// How a file's rows are written, and which of them is the first with a line.
struct Layout {
  char separator = ',';
  bool bare = false;
  std::vector<std::string> header;
  std::size_t header_row = 0;
  std::size_t first_row = 0;
};

/// The separator that a first row such as "sep=;" states, as Excel reads and writes it.
std::optional<char> stated_separator(std::string_view row) {
  if (!lower_case(row.substr(0, 4)).starts_with("sep=") || row.size() > 5) return std::nullopt;
  return row.size() == 5 ? row[4] : '\t';  // a tab is trimmed off the row
}

/// The text of a comment; std::nullopt for a row that is not a comment.
std::optional<std::string_view> comment_of(std::string_view row) {
  if (!row.starts_with('#') && !row.starts_with("//")) return std::nullopt;
  return trimmed(row.substr(std::min(row.find_first_not_of("#/"), row.size())));
}

/// Whether a comment names columns. A sentence that contains the word "geometry" does not.
bool is_header(const std::vector<std::string>& fields, char separator) {
  const std::vector<std::string> names = lower_case_names(fields);
  if (has_coordinates(names)) return true;
  return separator != ' ' && separator != kOneField && wkt_column(names, {}).has_value();
}

/// The layout of a file. Comments before the first row are skipped; one that names the columns is
/// the header.
Layout layout_of(const std::string& path, const std::vector<TextRow>& rows) {
  Layout layout;
  std::size_t i = 0;
  const std::optional<char> stated = stated_separator(rows.front().text);
  if (stated) ++i;
  for (; i < rows.size(); ++i) {
    const std::optional<std::string_view> comment = comment_of(rows[i].text);
    const std::string_view text = comment.value_or(rows[i].text);
    layout.separator = stated.value_or(separator_of_lines(text));
    const std::string where = place(path, rows[i].number);
    layout.header = row_fields(text, layout.separator, where);
    layout.header_row = i;
    if (!comment) break;
    if (!is_header(layout.header, layout.separator)) continue;
    // NumPy writes any header before rows with its own separator
    if (!stated && i + 1 < rows.size()) layout.separator = separator_of_lines(rows[i + 1].text);
    break;
  }
  if (i == rows.size()) {
    throw IoError(path, "has only comments; a header or rows of six numbers are expected");
  }
  layout.bare = is_bare(layout.header, layout.separator);
  layout.first_row = layout.bare ? i : i + 1;
  if (layout.bare) layout.header.assign(kCoordinates.begin(), kCoordinates.end());
  return layout;
}

/// Indices of the columns that do not hold geometry.
std::vector<std::size_t> attribute_columns(const Columns& columns) {
  const auto& xyz = columns.coordinates;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < columns.names.size(); ++i) {
    const bool is_geometry =
        columns.wkt ? i == *columns.wkt : std::find(xyz.begin(), xyz.end(), i) != xyz.end();
    if (!is_geometry) numbers.push_back(i);
  }
  return numbers;
}

/// The values of a row as words; widens the types of the table's columns to fit them.
class RowValues {
 public:
  RowValues(const std::vector<std::string>& header, const Columns& columns, AttributeTable& table)
      : numbers_(attribute_columns(columns)), seen_(numbers_.size(), 0), table_(table) {
    for (const std::size_t i : numbers_) table.columns.push_back({header[i], ColumnType::kText});
  }

  SparseRow values_of(const std::vector<std::string>& fields) {
    SparseRow row;
    for (std::size_t k = 0; k < numbers_.size(); ++k) {
      const std::string& word = fields[numbers_[k]];
      if (word.empty()) continue;
      ColumnType& type = table_.columns[k].type;
      type = seen_[k] == 0 ? type_of_word(word) : common_type(type, type_of_word(word));
      seen_[k] = 1;
      row.emplace_back(k, word);
    }
    return row;
  }

 private:
  std::vector<std::size_t> numbers_;
  std::vector<char> seen_;
  AttributeTable& table_;
};

nlohmann::json properties_of(const std::vector<std::string>& fields, const Columns& columns) {
  nlohmann::json properties = nlohmann::json::object();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i != columns.wkt) properties[columns.names[i]] = fields[i];
  }
  return properties;
}

FeatureGeometry geometry_of_wkt(const std::string& text, const std::string& where) {
  FeatureGeometry found;
  if (text.empty()) return found;
  const QuietGdal quiet;
  OGRGeometry* raw = nullptr;
  const OGRErr error = OGRGeometryFactory::createFromWkt(standard_wkt(text).c_str(), nullptr, &raw);
  const std::unique_ptr<OGRGeometry> geometry(raw);
  if (error != OGRERR_NONE || !geometry) {
    throw IoError(where, "'" + text.substr(0, 60) + "' is not WKT");
  }
  collect_geometry(*geometry, found);
  return found;
}

/// Splits "SRID=25832;LINESTRING ..." (EWKT) and keeps the CRS.
std::string without_srid(std::string_view text, Crs& crs, const std::string& where) {
  const std::size_t end = text.find(';');
  if (!lower_case(text.substr(0, 5)).starts_with("srid=") || end == std::string_view::npos) {
    return std::string(text);
  }
  const std::string_view code = text.substr(5, end - 5);
  const std::optional<long> number = to_integer(code);
  if (!number || *number < 0) {
    throw IoError(where, fmt::format("SRID '{}'; must be an EPSG code", code.substr(0, 40)));
  }
  if (*number != 0) crs.definition = "EPSG:" + std::string(code);
  return std::string(text.substr(end + 1));
}

}  // namespace

LineSet read_csv(const std::string& path, std::string_view content) {
  LineSet set = lines_for_file(path, "CSV", content.size());
  const std::vector<TextRow> rows = rows_of(content);
  if (rows.empty()) throw IoError(path, "is empty; a header or rows of six numbers are expected");
  const Layout layout = layout_of(path, rows);
  const auto fields_at = [&](std::size_t i) {
    return row_fields(rows[i].text, layout.separator, place(path, rows[i].number));
  };
  const Columns columns = columns_of(
      layout.header,
      layout.first_row < rows.size() ? fields_at(layout.first_row) : std::vector<std::string>(),
      place(path, rows[layout.header_row].number));
  RowValues values(layout.header, columns, set.features);
  FeatureCollector features(set);
  if (columns.wkt) set.format = "CSV with WKT";
  for (std::size_t i = layout.first_row; i < rows.size(); ++i) {
    const std::string where = place(path, rows[i].number);
    const std::vector<std::string> fields = fields_at(i);
    if (fields.size() != columns.names.size()) {
      throw IoError(where, fmt::format("{} fields; the first row has {}", fields.size(),
                                       columns.names.size()));
    }
    Feature feature;
    if (columns.wkt) {
      feature.geometry = geometry_of_wkt(without_srid(fields[*columns.wkt], set.crs, where), where);
    } else {
      feature.geometry.lines = {coordinates_of(fields, columns, layout.separator, where)};
    }
    feature.properties = properties_of(fields, columns);
    feature.fid = static_cast<std::int64_t>(i - layout.first_row);
    feature.where = where;
    feature.values = [row = values.values_of(fields)] { return row; };
    features.add(std::move(feature));
  }
  features.finish();
  return set;
}

LineSet read_wkt(const std::string& path, std::string_view content) {
  LineSet set = lines_for_file(path, "WKT", content.size());
  FeatureCollector features(set);
  std::int64_t number = 0;
  for (const TextRow& row : rows_of(content)) {
    Feature feature;
    feature.where = place(path, row.number);
    feature.geometry =
        geometry_of_wkt(without_srid(row.text, set.crs, feature.where), feature.where);
    feature.fid = number++;
    features.add(std::move(feature));
  }
  features.finish();
  return set;
}

}  // namespace ridgeline::io
