// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/write_lines.h"

#include "io/atomic_file.h"
#include "io/lines/scratch_folder.h"
#include "io/lines/writers.h"

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

std::string file_text(const LineSet& set, LineFormat format) {
  switch (format) {
    case LineFormat::kCsv:
      return csv_text(set);
    case LineFormat::kWktCsv:
      return wkt_csv_text(set);
    case LineFormat::kObj:
      return obj_text(set);
    case LineFormat::kPly:
      return ply_text(set);
    default:
      return geojson_text(set);
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

void require_writable(LineFormat format) {
  if (format != LineFormat::kDxf || CPLFindFile("gdal", "header.dxf") != nullptr) return;
  const char* const folder = CPLGetConfigOption("GDAL_DATA", "");
  throw std::invalid_argument(
      fmt::format("format dxf: GDAL finds no header.dxf, which DXF files begin with; GDAL_DATA is "
                  "\"{}\", unset it or name the folder of header.dxf (package gdal-data)",
                  folder));
}

void write_lines(const std::string& path, const LineSet& set, LineFormat format) {
  if (!is_ogr(format)) return write_file(path, file_text(set, format));
  const ScratchFolder scratch(path);
  write_ogr(path, scratch.draft(), set, format);
  scratch.publish();
}

}  // namespace ridgeline::io
