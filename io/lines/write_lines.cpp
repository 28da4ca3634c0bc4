// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/write_lines.h"

#include "io/files/atomic_file.h"
#include "io/lines/writers.h"
#include "io/text/text.h"

#include <Eigen/Geometry>
#include <cpl_conv.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace ridgeline::io {
namespace {

constexpr std::array kFormats{LineFormatInfo{LineFormat::kGeoJson, "geojson", ".geojson"},
                              LineFormatInfo{LineFormat::kGeoPackage, "gpkg", ".gpkg"},
                              LineFormatInfo{LineFormat::kDxf, "dxf", ".dxf"},
                              LineFormatInfo{LineFormat::kShapefile, "shapefile", ".shp"},
                              LineFormatInfo{LineFormat::kWktCsv, "wkt_csv", ".wkt.csv"},
                              LineFormatInfo{LineFormat::kCsv, "csv", ".csv"},
                              LineFormatInfo{LineFormat::kObj, "obj", ".obj"},
                              LineFormatInfo{LineFormat::kPly, "ply", ".ply"}};

/// Whether the format can represent a line without geometry.
bool holds_lines_of_nowhere(LineFormat format) {
  return format != LineFormat::kCsv && format != LineFormat::kDxf && format != LineFormat::kObj &&
         format != LineFormat::kPly;
}

/// The minimum corner of the box of the lines, rounded down to whole hundreds.
Eigen::Vector3d low_corner(const LineSet& set) {
  constexpr double kStep = 100.0;
  Eigen::AlignedBox3d box;
  for (const Line& line : set.lines) {
    if (!all_finite(line.segment_in_world)) continue;
    box.extend(line.segment_in_world.start);
    box.extend(line.segment_in_world.end);
  }
  if (box.isEmpty()) return Eigen::Vector3d::Zero();
  return (box.min() / kStep).array().floor().matrix() * kStep;
}

std::string file_text(const LineSet& set, LineFormat format, const WriteLinesOptions& options) {
  const auto origin = [&] {
    return options.local_origin ? low_corner(set) : Eigen::Vector3d::Zero().eval();
  };
  switch (format) {
    case LineFormat::kCsv:
      return csv_text(set);
    case LineFormat::kWktCsv:
      return wkt_csv_text(set);
    case LineFormat::kObj:
      return obj_text(set, origin());
    default:
      return ply_text(set, origin());
  }
}

bool is_ogr(LineFormat format) {
  return format == LineFormat::kGeoPackage || format == LineFormat::kShapefile ||
         format == LineFormat::kDxf;
}

}  // namespace

std::span<const LineFormatInfo> line_formats() { return kFormats; }

std::optional<LineFormat> line_format(std::string_view name) {
  const auto* const it =
      std::find_if(kFormats.begin(), kFormats.end(),
                   [&](const LineFormatInfo& info) { return info.name == name; });
  if (it == kFormats.end()) return std::nullopt;
  return it->format;
}

std::optional<LineFormat> line_format_of_file(std::string_view file) {
  const std::string name = lower_case(file);
  if (name.ends_with(".json")) return LineFormat::kGeoJson;
  // .wkt.csv, which also ends in .csv, comes first
  const auto* const it = std::ranges::find_if(
      kFormats, [&](const auto& info) { return name.ends_with(info.extension); });
  if (it == kFormats.end()) return std::nullopt;
  return it->format;
}

void require_writable(LineFormat format) {
  if (format != LineFormat::kDxf || CPLFindFile("gdal", "header.dxf") != nullptr) return;
  const char* const folder = CPLGetConfigOption("GDAL_DATA", "");
  throw std::invalid_argument(
      fmt::format("format dxf: GDAL cannot find header.dxf, which it needs to write DXF; GDAL_DATA "
                  "is \"{}\", unset it or set it to the folder of header.dxf (package gdal-data)",
                  folder));
}

std::size_t write_lines(const std::string& path,
                        const LineSet& set,
                        LineFormat format,
                        const WriteLinesOptions& options) {
  const auto is_nowhere = [](const Line& line) { return !all_finite(line.segment_in_world); };
  if (!holds_lines_of_nowhere(format) && std::ranges::any_of(set.lines, is_nowhere)) {
    LineSet kept = set;
    const std::size_t n_left_out = std::erase_if(kept.lines, is_nowhere);
    write_lines(path, kept, format, options);
    return n_left_out;
  }
  if (!is_ogr(format) && format != LineFormat::kGeoJson) {
    write_file(path, file_text(set, format, options));
    return 0;
  }
  const std::unique_ptr<LineWriter> writer = line_writer(path, set.crs, format);
  for (const Line& line : set.lines) writer->add(line);
  writer->commit();
  return 0;
}

std::unique_ptr<LineWriter> line_writer(const std::string& path,
                                        const Crs& crs,
                                        LineFormat format) {
  if (format == LineFormat::kGeoJson) return geojson_writer(path, crs);
  if (!is_ogr(format))
    throw std::invalid_argument("lines of this format must be written all at once");
  return ogr_writer(path, crs, format);
}

}  // namespace ridgeline::io
