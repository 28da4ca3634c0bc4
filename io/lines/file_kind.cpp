// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/file_kind.h"

#include "io/error.h"

#include <fmt/format.h>

#include <array>

namespace ridgeline::io {
namespace {

using namespace std::string_view_literals;

struct KnownKind {
  std::string_view mark;  ///< first bytes, or an extension
  const char* what;
};

constexpr const char* kCloud = "a point cloud, give it with --cloud";
constexpr const char* kImage = "an image";
constexpr const char* kGml =
    "XML, as of GML and CityGML, which is not read, save its lines as GeoPackage";
constexpr const char* kSequence =
    "a sequence of JSON texts, which is not read, save it as one FeatureCollection";
constexpr const char* kModel = "a city or building model, which is not read";

constexpr std::array kByFirstBytes{
    KnownKind{"LASF", kCloud},
    KnownKind{"# .PCD", kCloud},
    KnownKind{"SQLite format 3", "an SQLite database, name it .gpkg if it is a GeoPackage"},
    KnownKind{"II*\0"sv, kImage},
    KnownKind{"MM\0*"sv, kImage},
    KnownKind{"\x89PNG", kImage},
    KnownKind{"\xFF\xD8\xFF", kImage},
    KnownKind{"PK\x03\x04", "a ZIP archive, unpack it"},
    KnownKind{"\x1F\x8B", "compressed by gzip, unpack it"},
    KnownKind{"%PDF", "a PDF"},
    KnownKind{"glTF", "glTF, a mesh for display, which is not read"},
    KnownKind{"AC10", "a DWG drawing, save it as DXF"},
    KnownKind{"fgb\x03", "FlatGeobuf, save it as GeoPackage"},
    KnownKind{"PAR1", "Parquet, save it as GeoPackage"},
    KnownKind{"\xFF\xFE", "text in UTF-16, save it in UTF-8"},
    KnownKind{"\xFE\xFF", "text in UTF-16, save it in UTF-8"},
    KnownKind{"ISO-10303-21", kModel},
    KnownKind{"<", kGml}};

constexpr std::array kByExtension{
    KnownKind{".las", kCloud},
    KnownKind{".laz", kCloud},
    KnownKind{".pcd", kCloud},
    KnownKind{".xyz", kCloud},
    KnownKind{".pts", kCloud},
    KnownKind{".e57", kCloud},
    KnownKind{".gml", kGml},
    KnownKind{".citygml", kGml},
    KnownKind{".xml", kGml},
    KnownKind{".geojsonl", kSequence},
    KnownKind{".geojsons", kSequence},
    KnownKind{".ndjson", kSequence},
    KnownKind{".ifc", kModel},
    KnownKind{".jsonl", kSequence},
    KnownKind{".kml", "KML, whose coordinates are degrees; project it"},
    KnownKind{".kmz", "KML, whose coordinates are degrees; project it"},
    KnownKind{".dwg", "a DWG drawing, save it as DXF"},
    KnownKind{".dgn", "a DGN drawing, save it as DXF"},
    KnownKind{".fgb", "FlatGeobuf, save it as GeoPackage"},
    KnownKind{".zip", "a ZIP archive, unpack it"},
    KnownKind{".gz", "compressed by gzip, unpack it"},
    KnownKind{".dbf", "the table of a Shapefile, give the .shp"},
    KnownKind{".shx", "the index of a Shapefile, give the .shp"},
    KnownKind{".glb", "glTF, a mesh for display, which is not read"},
    KnownKind{".gltf", "glTF, a mesh for display, which is not read"}};

}  // namespace

void refuse_other_kind(const std::string& path, std::string_view content) {
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
  for (const KnownKind& kind : kByFirstBytes) {
    if (!content.starts_with(kind.mark)) continue;
    throw IoError(path, fmt::format("is {}; {}", kind.what, kWhatIsRead));
  }
}

std::string kind_by_extension(std::string_view extension) {
  for (const KnownKind& kind : kByExtension) {
    if (extension == kind.mark) return kind.what;
  }
  return "";
}

}  // namespace ridgeline::io
