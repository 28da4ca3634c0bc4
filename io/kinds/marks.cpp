// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/marks.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace ridgeline::io {
namespace {

using namespace std::string_view_literals;
using enum FileGroup;

struct Mark {
  std::string_view text;
  std::size_t at = 0;  ///< byte offset in the file at which the mark begins
};

struct Format {
  const char* what;
  FileGroup group;
  std::array<Mark, 4> marks = {};  ///< any one of these identifies the format
  const char* extensions = "";     ///< as words; for lines, the first one selects the reader
  const char* advice = "";
};

constexpr const char* kNotRead = "which is not supported";
constexpr const char* kUnpack = "unpack it";
constexpr const char* kAsTiff = "save it as TIFF";
constexpr const char* kAsDxf = "save it as DXF";
constexpr const char* kGiveShp = "give the .shp";

/// All formats. The first match decides, so specific marks come before general ones.
constexpr std::array kKnownFormats{
    Format{"a COPC point cloud", kCloud, {{{"copc", 377}}}},
    Format{"a LAS point cloud", kCloud, {{{"LASF"}}}, ".las"},
    Format{"a LAZ point cloud", kCloud, {}, ".laz"},
    Format{"a PCD point cloud", kCloud, {{{"# .PCD"}, {"VERSION ."}, {"VERSION 0."}}}, ".pcd"},
    Format{"a text point cloud", kCloud, {}, ".xyz .pts"},
    Format{"an E57 point cloud", kOther, {{{"ASTM-E57"}}}, ".e57", "save it as LAS"},
    Format{"a PLY", kPly, {}, ".ply"},
    Format{"a GeoPackage", kLines, {{{"GPKG", 68}, {"GP10", 68}}}, ".gpkg"},
    Format{"a Shapefile", kLines, {{{"\0\0\x27\x0A"sv}}}, ".shp"},
    Format{"a DXF drawing", kLines, {{{"AutoCAD Binary DXF"}}}, ".dxf"},
    Format{"a mesh or lines (OBJ)", kLines, {}, ".obj"},
    Format{"GeoJSON", kLines, {}, ".geojson"},
    Format{"lines as WKT", kLines, {}, ".wkt"},
    Format{"an SQLite database",
           kOther,
           {{{"SQLite format 3\0"sv}}},
           "",
           "name it .gpkg if it is a GeoPackage"},
    Format{"a TIFF image",
           kImage,
           {{{"II*\0"sv}, {"MM\0*"sv}, {"II+\0"sv}, {"MM\0+"sv}}},
           ".tif .tiff"},
    Format{"a PNG image", kImage, {{{"\x89PNG"}}}, ".png"},
    Format{"a JPEG image", kImage, {{{"\xFF\xD8\xFF"}}}, ".jpg .jpeg"},
    Format{"a JPEG 2000 image", kImage, {{{"jP  ", 4}}}, ".jp2"},
    Format{"a GIF image", kOther, {{{"GIF8"}}}, ".gif", kAsTiff},
    Format{"a WebP image", kOther, {{{"WEBP", 8}}}, ".webp", kAsTiff},
    Format{"an ECW image", kOther, {}, ".ecw", kAsTiff},
    Format{"a BMP image", kOther, {}, ".bmp", kAsTiff},
    Format{"HDF5", kOther, {{{"\x89HDF"}}}, "", kNotRead},
    Format{"a ZIP archive", kOther, {{{"PK\x03\x04"}, {"PK\x05\x06"}}}, ".zip", kUnpack},
    Format{"compressed with gzip", kOther, {{{"\x1F\x8B"}}}, ".gz", kUnpack},
    Format{"compressed with bzip2", kOther, {{{"BZh"}}}, "", kUnpack},
    Format{"compressed with xz",
           kOther,
           {{{"\xFD"
              "7zXZ"}}},
           "",
           kUnpack},
    Format{"compressed with zstd", kOther, {{{"\x28\xB5\x2F\xFD"}}}, "", kUnpack},
    Format{"a 7z archive", kOther, {{{"7z\xBC\xAF"}}}, "", kUnpack},
    Format{"a RAR archive", kOther, {{{"Rar!"}}}, "", kUnpack},
    Format{"a tar archive", kOther, {{{"ustar", 257}}}, "", kUnpack},
    Format{"a PDF", kOther, {{{"%PDF"}}}, "", kNotRead},
    Format{"glTF, a mesh for display", kOther, {{{"glTF"}}}, ".glb .gltf", kNotRead},
    Format{"a DWG drawing", kOther, {{{"AC10"}}}, ".dwg", kAsDxf},
    Format{"a DGN drawing", kOther, {}, ".dgn", kAsDxf},
    Format{"FlatGeobuf", kOther, {{{"fgb\x03"}}}, ".fgb", "save it as GeoPackage"},
    Format{"Parquet", kOther, {{{"PAR1"}}}, "", "save it as GeoPackage"},
    Format{"text in UTF-16", kOther, {{{"\xFF\xFE"}, {"\xFE\xFF"}}}, "", "save it in UTF-8"},
    Format{"a building model (IFC or STEP)", kOther, {{{"ISO-10303-21"}}}, ".ifc", kNotRead},
    Format{"an ASCII grid", kOther, {{{"ncols"}, {"NCOLS"}}}, "", "give its cells as x y z lines"},
    Format{"a Git LFS pointer",
           kOther,
           {{{"version https://git-lfs"}}},
           "",
           "fetch the file with git lfs pull"},
    Format{"a web page",
           kOther,
           {{{"<!DOCTYPE html"}, {"<!doctype html"}, {"<html"}}},
           ".html",
           "perhaps from a failed download"},
    Format{"KML, whose coordinates are degrees", kOther, {}, ".kml .kmz", "project it"},
    Format{"a VRT (XML)", kOther, {}, ".vrt", "give the images named in it"},
    Format{"XML, such as GML",
           kOther,
           {},
           ".xml .gml .citygml",
           "which is not supported, save its lines as GeoPackage"},
    Format{"a sequence of JSON texts",
           kOther,
           {},
           ".geojsonl .geojsons .ndjson .jsonl",
           "which is not supported, save it as one FeatureCollection"},
    Format{"the attribute table of a Shapefile", kOther, {}, ".dbf", kGiveShp},
    Format{"the index of a Shapefile", kOther, {}, ".shx", kGiveShp},
    Format{"the reference system of a Shapefile", kOther, {}, ".prj", kGiveShp},
    Format{"a QGIS project", kOther, {}, ".qgz", "save its lines as GeoPackage"}};

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at < words.size(); at = words.find(word, at + 1)) {
    const std::string_view rest = words.substr(at + word.size());
    if (rest.empty() || rest.front() == ' ') return !word.empty();
  }
  return false;
}

FileKind kind_of_format(const Format& format) {
  return {.group = format.group,
          .what = format.what,
          .advice = *format.advice != '\0' ? format.advice : info_of(format.group).advice,
          .ending = format.group == kLines ? format.extensions : ""};
}

}  // namespace

FileKind kind_by_mark(std::string_view start) {
  const auto fits = [&](const Mark& mark) {
    return !mark.text.empty() && start.size() > mark.at &&
           start.substr(mark.at).starts_with(mark.text);
  };
  const auto* const format = std::ranges::find_if(
      kKnownFormats, [&](const Format& known) { return std::ranges::any_of(known.marks, fits); });
  return format == kKnownFormats.end() ? FileKind() : kind_of_format(*format);
}

FileKind format_with_extension(std::string_view extension) {
  const auto* const format = std::ranges::find_if(
      kKnownFormats, [&](const Format& known) { return has_word(known.extensions, extension); });
  return format == kKnownFormats.end() ? FileKind() : kind_of_format(*format);
}

FileKind kind_by_extension(std::string_view extension) {
  FileKind kind = format_with_extension(extension);
  kind.by_name = kind.is_known();
  return kind;
}

}  // namespace ridgeline::io
