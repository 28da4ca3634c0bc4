// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/map_lines.h"

#include "io/error.h"
#include "io/files/input_file.h"
#include "io/gdal/ogr_support.h"
#include "reconstruct/geometry/segment.h"

#include <ogrsf_frmts.h>

#include <memory>

namespace ridgeline::io {
namespace {

/// The columns of a layer that a MapLine is read from; -1 for one that it does not have.
class MapColumns {
 public:
  explicit MapColumns(OGRFeatureDefn& layer)
      : id_(layer.GetFieldIndex("line_id") >= 0 ? layer.GetFieldIndex("line_id")
                                                : layer.GetFieldIndex("id")),
        class_(layer.GetFieldIndex("class")),
        kind_(layer.GetFieldIndex("kind")),
        length_(layer.GetFieldIndex("length_m")),
        mean_(layer.GetFieldIndex("mean_distance_m")),
        max_(layer.GetFieldIndex("max_distance_m")),
        images_(layer.GetFieldIndex("n_images")),
        // in a file of lines, the status states how a line was constructed
        status_(mean_ >= 0 ? layer.GetFieldIndex("status") : -1) {}

  [[nodiscard]] MapLine line_of(OGRFeature& feature) const {
    MapLine line;
    line.id = text(feature, id_);
    line.line_class = text(feature, class_);
    line.kind = text(feature, kind_);
    line.status = text(feature, status_);
    line.length_m = number(feature, length_);
    line.mean_distance_m = number(feature, mean_);
    line.max_distance_m = number(feature, max_);
    if (const auto n = number(feature, images_)) line.n_images = static_cast<int>(*n);
    return line;
  }

 private:
  static std::string text(OGRFeature& feature, int column) {
    return column < 0 ? "" : feature.GetFieldAsString(column);
  }
  static std::optional<double> number(OGRFeature& feature, int column) {
    if (column < 0 || !feature.IsFieldSetAndNotNull(column)) return std::nullopt;
    return feature.GetFieldAsDouble(column);
  }

  int id_, class_, kind_, length_, mean_, max_, images_, status_;
};

std::optional<Segment3> segment_of(const OGRFeature& feature) {
  const OGRGeometry* const geometry = feature.GetGeometryRef();
  if (geometry == nullptr || wkbFlatten(geometry->getGeometryType()) != wkbLineString)
    return std::nullopt;
  const OGRLineString* const curve = geometry->toLineString();
  if (curve->getNumPoints() != 2) return std::nullopt;
  return Segment3{{curve->getX(0), curve->getY(0), curve->getZ(0)},
                  {curve->getX(1), curve->getY(1), curve->getZ(1)}};
}

OGRLayer* lines_of(GDALDataset& map) {
  OGRLayer* const named = map.GetLayerByName("lines");
  return named != nullptr ? named : map.GetLayer(0);
}

}  // namespace

void for_each_map_line(const std::string& path, const std::function<void(const MapLine&)>& visit) {
  require_regular_file(path);
  const QuietGdal quiet;
  register_gdal_drivers();
  const char* const drivers[] = {"GPKG", nullptr};
  const std::unique_ptr<GDALDataset> map(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr));
  OGRLayer* const layer = map ? lines_of(*map) : nullptr;
  if (layer == nullptr)
    throw IoError(path, "is not a map of lines: " + quiet.complaints("it has no layer"));
  const MapColumns columns(*layer->GetLayerDefn());
  for (const auto& feature : *layer) {
    const std::optional<Segment3> segment = segment_of(*feature);
    if (!segment || !all_finite(*segment)) continue;
    MapLine line = columns.line_of(*feature);
    line.segment_in_map = *segment;
    visit(line);
  }
}

}  // namespace ridgeline::io
