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
  FileGroup group;
  const char* what;
  const char* advice = "";
  std::size_t at = 0;  ///< byte of the file where the mark begins
  const char* ending = "";
};

constexpr const char* kNotRead = "which is not read";
constexpr const char* kUnpack = "unpack it";
constexpr const char* kAsGeoPackage = "save its lines as GeoPackage";
constexpr const char* kAsTiff = "save it as TIFF";
constexpr const char* kInUtf8 = "save it in UTF-8";

/// All marks. The first that fits decides, so special marks stand before general ones.
constexpr std::array kMarks{
    Mark{"copc", kCloud, "a COPC point cloud", "", 377},
    Mark{"LASF", kCloud, "a LAS point cloud"},
    Mark{"# .PCD", kCloud, "a PCD point cloud"},
    Mark{"VERSION .", kCloud, "a PCD point cloud"},
    Mark{"VERSION 0.", kCloud, "a PCD point cloud"},
    Mark{"ASTM-E57", kOther, "an E57 point cloud", "save it as LAS"},
    Mark{"GPKG", kLines, "a GeoPackage", "", 68, ".gpkg"},
    Mark{"GP10", kLines, "a GeoPackage", "", 68, ".gpkg"},
    Mark{"SQLite format 3\0"sv, kOther, "an SQLite database",
         "name it .gpkg if it is a GeoPackage"},
    Mark{"II*\0"sv, kImage, "a TIFF image"},
    Mark{"MM\0*"sv, kImage, "a TIFF image"},
    Mark{"II+\0"sv, kImage, "a TIFF image"},
    Mark{"MM\0+"sv, kImage, "a TIFF image"},
    Mark{"\x89PNG", kImage, "a PNG image"},
    Mark{"\xFF\xD8\xFF", kImage, "a JPEG image"},
    Mark{"GIF8", kOther, "a GIF image", kAsTiff},
    Mark{"jP  ", kImage, "a JPEG 2000 image", "", 4},
    Mark{"WEBP", kOther, "a WebP image", kAsTiff, 8},
    Mark{"\x89HDF", kOther, "HDF5", kNotRead},
    Mark{"PK\x03\x04", kOther, "a ZIP archive", kUnpack},
    Mark{"PK\x05\x06", kOther, "an empty ZIP archive"},
    Mark{"\x1F\x8B", kOther, "compressed by gzip", kUnpack},
    Mark{"BZh", kOther, "compressed by bzip2", kUnpack},
    Mark{"\xFD"
         "7zXZ",
         kOther, "compressed by xz", kUnpack},
    Mark{"\x28\xB5\x2F\xFD", kOther, "compressed by zstd", kUnpack},
    Mark{"7z\xBC\xAF", kOther, "a 7z archive", kUnpack},
    Mark{"Rar!", kOther, "a RAR archive", kUnpack},
    Mark{"ustar", kOther, "a tar archive", kUnpack, 257},
    Mark{"%PDF", kOther, "a PDF", kNotRead},
    Mark{"glTF", kOther, "glTF, a mesh for display", kNotRead},
    Mark{"AC10", kOther, "a DWG drawing", "save it as DXF"},
    Mark{"AutoCAD Binary DXF", kLines, "a DXF drawing", "", 0, ".dxf"},
    Mark{"fgb\x03", kOther, "FlatGeobuf", "save it as GeoPackage"},
    Mark{"PAR1", kOther, "Parquet", "save it as GeoPackage"},
    Mark{"\0\0\x27\x0A"sv, kLines, "a Shapefile", "", 0, ".shp"},
    Mark{"\xFF\xFE", kOther, "text in UTF-16", kInUtf8},
    Mark{"\xFE\xFF", kOther, "text in UTF-16", kInUtf8},
    Mark{"ISO-10303-21", kOther, "a building model (IFC or STEP)", kNotRead},
    Mark{"ncols", kOther, "an ASCII grid", "give its cells as x y z lines"},
    Mark{"NCOLS", kOther, "an ASCII grid", "give its cells as x y z lines"},
    Mark{"version https://git-lfs", kOther, "a Git LFS pointer",
         "fetch the file with git lfs pull"},
    Mark{"<!DOCTYPE html", kOther, "a web page", "perhaps of a failed download"},
    Mark{"<!doctype html", kOther, "a web page", "perhaps of a failed download"},
    Mark{"<html", kOther, "a web page", "perhaps of a failed download"}};

constexpr const char* kGml = "XML, as of GML";
constexpr const char* kGmlAdvice = "which is not read, save its lines as GeoPackage";
constexpr const char* kSequence = "a sequence of JSON texts";
constexpr const char* kOneCollection = "which is not read, save it as one FeatureCollection";

constexpr std::array kExtensions{
    Mark{".las", kCloud, "a LAS point cloud"},
    Mark{".laz", kCloud, "a LAZ point cloud"},
    Mark{".pcd", kCloud, "a PCD point cloud"},
    Mark{".xyz", kCloud, "a text point cloud"},
    Mark{".pts", kCloud, "a text point cloud"},
    Mark{".e57", kOther, "an E57 point cloud", "save it as LAS"},
    Mark{".ply", kPly, "a PLY"},
    Mark{".gpkg", kLines, "a GeoPackage"},
    Mark{".shp", kLines, "a Shapefile"},
    Mark{".dxf", kLines, "a DXF drawing"},
    Mark{".obj", kLines, "a mesh or lines (OBJ)"},
    Mark{".geojson", kLines, "GeoJSON"},
    Mark{".wkt", kLines, "lines as WKT"},
    Mark{".tif", kImage, "an image"},
    Mark{".tiff", kImage, "an image"},
    Mark{".png", kImage, "an image"},
    Mark{".jpg", kImage, "an image"},
    Mark{".jpeg", kImage, "an image"},
    Mark{".jp2", kImage, "an image"},
    Mark{".ecw", kOther, "an ECW image", kAsTiff},
    Mark{".bmp", kOther, "a BMP image", kAsTiff},
    Mark{".gml", kOther, kGml, kGmlAdvice},
    Mark{".citygml", kOther, kGml, kGmlAdvice},
    Mark{".xml", kOther, kGml, kGmlAdvice},
    Mark{".geojsonl", kOther, kSequence, kOneCollection},
    Mark{".geojsons", kOther, kSequence, kOneCollection},
    Mark{".ndjson", kOther, kSequence, kOneCollection},
    Mark{".jsonl", kOther, kSequence, kOneCollection},
    Mark{".ifc", kOther, "a city or building model", kNotRead},
    Mark{".kml", kOther, "KML, whose coordinates are degrees", "project it"},
    Mark{".kmz", kOther, "KML, whose coordinates are degrees", "project it"},
    Mark{".dwg", kOther, "a DWG drawing", "save it as DXF"},
    Mark{".dgn", kOther, "a DGN drawing", "save it as DXF"},
    Mark{".fgb", kOther, "FlatGeobuf", "save it as GeoPackage"},
    Mark{".zip", kOther, "a ZIP archive", kUnpack},
    Mark{".gz", kOther, "compressed by gzip", kUnpack},
    Mark{".dbf", kOther, "the table of a Shapefile", "give the .shp"},
    Mark{".shx", kOther, "the index of a Shapefile", "give the .shp"},
    Mark{".prj", kOther, "the reference system of a Shapefile", "give the .shp"},
    Mark{".qgz", kOther, "a project of QGIS", kAsGeoPackage},
    Mark{".glb", kOther, "glTF, a mesh for display", kNotRead},
    Mark{".gltf", kOther, "glTF, a mesh for display", kNotRead}};

FileKind kind_of_mark(const Mark& mark) {
  return {.group = mark.group,
          .what = mark.what,
          .advice = *mark.advice != '\0' ? mark.advice : advice_on(mark.group),
          .ending = mark.ending};
}

}  // namespace

FileKind kind_by_mark(std::string_view start) {
  const auto* const mark = std::ranges::find_if(kMarks, [&](const Mark& known) {
    return start.size() > known.at && start.substr(known.at).starts_with(known.text);
  });
  return mark == kMarks.end() ? FileKind() : kind_of_mark(*mark);
}

FileKind kind_by_extension(std::string_view extension) {
  const auto* const mark = std::ranges::find(kExtensions, extension, &Mark::text);
  if (mark == kExtensions.end()) return {};
  FileKind kind = kind_of_mark(*mark);
  kind.by_name = true;
  return kind;
}

}  // namespace ridgeline::io
