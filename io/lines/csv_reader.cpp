// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/lines/attributes.h"
#include "io/lines/ogr_support.h"
#include "io/lines/readers.h"
#include "io/lines/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace ridgeline::io {
namespace {

constexpr std::array<std::string_view, 6> kCoordinates{"x1", "y1", "z1", "x2", "y2", "z2"};
constexpr std::array<std::string_view, 4> kWktNames{"wkt", "geometry", "geom", "the_geom"};

char separator_of(std::string_view first_row) {
  for (const char separator : {';', '\t'}) {
    if (first_row.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

/// Where a line's geometry stands in a row.
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

Columns columns_of(const std::vector<std::string>& header, const std::string& where) {
  Columns columns;
  for (const std::string& name : header) columns.names.push_back(lower_case(name));
  for (const std::string_view name : kWktNames) {
    if (!columns.wkt) columns.wkt = find(columns.names, name);
  }
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

bool is_bare(const std::vector<std::string>& fields) {
  return fields.size() == 6 && std::all_of(fields.begin(), fields.end(), [](const auto& field) {
           return to_double(field).has_value();
         });
}

std::vector<Vertices> parts_of_coordinates(const std::vector<std::string>& fields,
                                           const Columns& columns,
                                           const std::string& where) {
  std::vector<std::string_view> words;
  for (const std::size_t column : columns.coordinates) words.emplace_back(fields[column]);
  const std::vector<double> v = to_doubles(words, where);
  return {{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}}};
}

/// The numbers of the columns that hold no geometry.
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

/// What the columns of a row hold, as words; widens the types of the table's columns to take them.
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

std::vector<Vertices> parts_of_wkt(const std::string& text, const std::string& where) {
  if (text.empty()) return {};
  const QuietGdal quiet;
  OGRGeometry* raw = nullptr;
  const OGRErr error = OGRGeometryFactory::createFromWkt(text.c_str(), nullptr, &raw);
  const std::unique_ptr<OGRGeometry> geometry(raw);
  if (error != OGRERR_NONE || !geometry) {
    throw IoError(where, "'" + text.substr(0, 60) + "' is no WKT");
  }
  OgrLines lines = lines_of(*geometry);
  if (!lines.is_line) {
    throw IoError(where, fmt::format("{}; must be LINESTRING Z or MULTILINESTRING Z",
                                     geometry->getGeometryName()));
  }
  return std::move(lines.parts);
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
    throw IoError(where, fmt::format("SRID '{}'; must be a code of EPSG", code.substr(0, 40)));
  }
  if (*number != 0) crs.definition = "EPSG:" + std::string(code);
  return std::string(text.substr(end + 1));
}

}  // namespace

LineSet read_csv(const std::string& path, std::string_view content) {
  LineSet set = lines_for_file(path, "CSV", content.size());
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
  const std::vector<TextRow> rows = rows_of(content);
  if (rows.empty()) throw IoError(path, "is empty; a header or rows of six numbers are expected");
  const char separator = separator_of(rows.front().text);
  const std::string first_place = place(path, rows.front().number);
  const std::vector<std::string> first = csv_fields_of(rows.front().text, separator, first_place);
  const bool bare = is_bare(first);
  const std::vector<std::string> header =
      bare ? std::vector<std::string>(kCoordinates.begin(), kCoordinates.end()) : first;
  const Columns columns = columns_of(header, first_place);
  RowValues values(header, columns, set.features);
  if (columns.wkt) set.format = "CSV with WKT";
  for (std::size_t i = bare ? 0 : 1; i < rows.size(); ++i) {
    const std::string where = place(path, rows[i].number);
    const std::vector<std::string> fields = csv_fields_of(rows[i].text, separator, where);
    if (fields.size() != columns.names.size()) {
      throw IoError(where, fmt::format("{} fields; the first row has {}", fields.size(),
                                       columns.names.size()));
    }
    append_feature(line_from_properties(properties_of(fields, columns), where),
                   columns.wkt
                       ? parts_of_wkt(without_srid(fields[*columns.wkt], set.crs, where), where)
                       : parts_of_coordinates(fields, columns, where),
                   static_cast<std::int64_t>(bare ? i : i - 1), set, values.values_of(fields));
  }
  settle_types(set.features);
  return set;
}

LineSet read_wkt(const std::string& path, std::string_view content) {
  LineSet set = lines_for_file(path, "WKT", content.size());
  std::int64_t number = 0;
  for (const TextRow& row : rows_of(content)) {
    const std::string where = place(path, row.number);
    append_feature({}, parts_of_wkt(without_srid(row.text, set.crs, where), where), number++, set);
  }
  return set;
}

}  // namespace ridgeline::io
