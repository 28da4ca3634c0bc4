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

/// The format with this name; std::nullopt for an unknown name.
std::optional<LineFormat> line_format(std::string_view name);

/// The usual format of files with this name, ignoring case: `.json` is GeoJSON; std::nullopt for an
/// unknown extension.
std::optional<LineFormat> line_format_of_file(std::string_view file);

/// Throws std::invalid_argument if lines cannot be written in this format to any path because GDAL
/// does not find its data file. To be called before any work is done.
void require_writable(LineFormat format);

struct WriteLinesOptions {
  /// Whether OBJ and PLY coordinates are relative to an origin in whole hundreds of metres, stated
  /// in the file, for programs that store coordinates in 32 bits.
  bool local_origin = false;
};

/// Writes one feature per line, in the order of the set, with coordinates to 0.1 mm or better at
/// any magnitude.
///   GeoJSON, GeoPackage, WKT CSV   all attributes and the covariance; CSV with WKT states no CRS
///   Shapefile   all but the covariance, image segments, visible shares, `support` and
///               `moved_out_m` (columns hold 254 characters), CRS in the .prj
///   CSV         x1,y1,z1,x2,y2,z2 and all attributes, no CRS
///   DXF         one 3D polyline per line, layer = class, else kind; no other attributes, no CRS
///   OBJ, PLY    geometry; CRS and origin in comments
/// In GeoJSON, a set without a CRS gets that of a plane that is nowhere on Earth, which
/// read_lines() reads back as no CRS; GDAL would interpret a missing or null `crs` as degrees.
/// Lines with coordinates that are not finite have a null geometry in GeoJSON and none in
/// GeoPackage, Shapefile and WKT; CSV, DXF, OBJ and PLY cannot represent them and leave them out.
/// The same set gives the same bytes. The file is written completely or not at all; missing folders
/// are created. Returns the number of lines left out. Throws IoError if the file cannot be written.
std::size_t write_lines(const std::string& path,
                        const LineSet& set,
                        LineFormat format,
                        const WriteLinesOptions& options = {});

/// Writes the lines of a file one by one, so that they need not all be held in memory.
class LineWriter {
 public:
  virtual ~LineWriter() = default;
  /// Throws IoError if the file cannot be written.
  virtual void add(const Line& line) = 0;
  /// Moves the file into place. Without this call, no file is left and an existing one is kept.
  /// Throws IoError.
  virtual void commit() = 0;
};

/// A writer of GeoJSON, GeoPackage, Shapefile or DXF; the file is identical to that of
/// write_lines(). Lines written to DXF must be finite. Throws IoError if the file cannot be
/// written, std::invalid_argument for other formats.
std::unique_ptr<LineWriter> line_writer(const std::string& path, const Crs& crs, LineFormat format);

}  // namespace ridgeline::io
