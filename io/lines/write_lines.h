// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ridgeline::io {

enum class LineFormat : std::uint8_t {
  kGeoJson,
  kGeoPackage,
  kDxf,
  kShapefile,
  kWktCsv,
  kCsv,
  kObj,
  kPly,
};

/// A format's name on the command line ("geojson", "wkt_csv", ...) and its usual extension.
struct LineFormatInfo {
  LineFormat format;
  std::string_view name;
  std::string_view extension;
};
std::span<const LineFormatInfo> line_formats();

/// The format of this name; nothing for an unknown name.
std::optional<LineFormat> line_format(std::string_view name);

/// The format that files of this name usually have, upper and lower case being the same: `.json` is
/// GeoJSON; nothing for another ending.
std::optional<LineFormat> line_format_of_file(std::string_view file);

/// Throws std::invalid_argument if lines cannot be written in this format to any path, as GDAL
/// finds no data for it. It is to be called before the work is done.
void require_writable(LineFormat format);

struct WriteLinesOptions {
  /// Whether coordinates of OBJ and PLY are relative to an origin of whole hundreds of metres that
  /// the file states, for programs that hold them in 32 bits.
  bool local_origin = false;
};

/// Writes one feature a line, in the order of the set, coordinates to 0.1 mm or better at any size.
///   GeoJSON, GeoPackage, WKT CSV   all attributes and the covariance; CSV with WKT states no CRS
///   Shapefile   all but the covariance, image segments and visible shares (columns hold 254
///               characters), CRS in the .prj
///   CSV         x1,y1,z1,x2,y2,z2 and all attributes, no CRS
///   DXF         one 3D polyline a line, layer = class; no other attributes, no CRS
///   OBJ, PLY    geometry; CRS and origin in comments
/// A GeoJSON set without CRS gets that of a plane that is nowhere on Earth, which read_lines()
/// takes back as none; GDAL would take no `crs`, or null, for degrees. Lines with coordinates that
/// are not finite have the geometry null in GeoJSON and none in GeoPackage, Shapefile and WKT; CSV,
/// DXF, OBJ and PLY have no place for them and leave them out. The same set gives the same bytes.
/// Written whole or not at all; missing folders are made. Returns the number of lines left out.
/// Throws IoError if the file cannot be written.
std::size_t write_lines(const std::string& path,
                        const LineSet& set,
                        LineFormat format,
                        const WriteLinesOptions& options = {});

/// A file of lines that is written while they come, so that nobody has to hold them all.
class LineWriter {
 public:
  virtual ~LineWriter() = default;
  /// Throws IoError if the file cannot be written.
  virtual void add(const Line& line) = 0;
  /// Puts the file in place. Without it nothing is left and what stood there stays. Throws IoError.
  virtual void commit() = 0;
};

/// A writer of GeoJSON, GeoPackage, Shapefile or DXF; the file has the bytes of write_lines().
/// Lines of DXF must be finite. Throws IoError if the file cannot be written, std::invalid_argument
/// for other formats.
std::unique_ptr<LineWriter> line_writer(const std::string& path, const Crs& crs, LineFormat format);

}  // namespace ridgeline::io
