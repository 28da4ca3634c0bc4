// SPDX-License-Identifier: BSD-3-Clause
#include "io/gdal/geopackage_writer.h"

#include "io/error.h"
#include "io/files/scratch_folder.h"
#include "io/gdal/ogr_support.h"
#include "io/text/utf8.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <memory>

namespace ridgeline::io {
namespace {

constexpr const char* kGeometryColumn = "geom";

OGRFieldType ogr_type(ColumnType type) {
  switch (type) {
    case ColumnType::kBoolean:
    case ColumnType::kInteger:
      return OFTInteger;
    case ColumnType::kInteger64:
      return OFTInteger64;
    case ColumnType::kReal:
      return OFTReal;
    case ColumnType::kDate:
      return OFTDate;
    case ColumnType::kTime:
      return OFTTime;
    case ColumnType::kDateTime:
      return OFTDateTime;
    case ColumnType::kBinary:
      return OFTBinary;
    default:
      return OFTString;
  }
}

void set_value(const Value& value, int field, ColumnType type, OGRFeature& feature) {
  if (const auto* const n = std::get_if<std::int64_t>(&value)) {
    feature.SetField(field, static_cast<GIntBig>(*n));
  } else if (const auto* const x = std::get_if<double>(&value)) {
    feature.SetField(field, *x);
  } else if (const auto* const text = std::get_if<std::string>(&value)) {
    if (type == ColumnType::kBinary) {
      feature.SetField(field, static_cast<int>(text->size()), text->data());
    } else {
      feature.SetField(field, as_utf8(*text).c_str());
    }
  }
}

void add_vertices(const std::vector<Eigen::Vector3d>& vertices, OGRSimpleCurve& curve) {
  for (const Eigen::Vector3d& x : vertices) curve.addPoint(x.x(), x.y(), x.z());
}

std::unique_ptr<OGRPolygon> polygon_of(const std::vector<std::vector<Eigen::Vector3d>>& rings) {
  auto polygon = std::make_unique<OGRPolygon>();
  for (const std::vector<Eigen::Vector3d>& vertices : rings) {
    auto ring = std::make_unique<OGRLinearRing>();
    add_vertices(vertices, *ring);
    ring->closeRings();
    polygon->addRingDirectly(ring.release());
  }
  return polygon;
}

std::unique_ptr<OGRGeometry> geometry_of(const MapFeature& feature, MapGeometry kind) {
  if (kind == MapGeometry::kMultiPolygon && !feature.polygons.empty()) {
    auto polygons = std::make_unique<OGRMultiPolygon>();
    for (const auto& rings : feature.polygons)
      polygons->addGeometryDirectly(polygon_of(rings).release());
    return polygons;
  }
  if (feature.vertices.empty()) return nullptr;
  if (kind == MapGeometry::kPoint) {
    const Eigen::Vector3d& x = feature.vertices.front();
    return std::make_unique<OGRPoint>(x.x(), x.y(), x.z());
  }
  if (kind == MapGeometry::kLine) {
    auto line = std::make_unique<OGRLineString>();
    add_vertices(feature.vertices, *line);
    return line;
  }
  return polygon_of({feature.vertices});
}

OGRwkbGeometryType ogr_type(MapGeometry geometry) {
  if (geometry == MapGeometry::kPoint) return wkbPoint25D;
  if (geometry == MapGeometry::kMultiPolygon) return wkbMultiPolygon25D;
  return geometry == MapGeometry::kLine ? wkbLineString25D : wkbPolygon25D;
}

class GeopackageWriter {
 public:
  GeopackageWriter(const std::string& path, const std::string& draft) : path_(path) {
    GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    if (driver != nullptr) {
      dataset_.reset(driver->Create(draft.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    }
    require(dataset_ != nullptr);
  }

  void write(const Crs& crs, const std::vector<MapLayer>& layers) {
    OGRSpatialReference reference = spatial_reference(crs).value_or(undefined_plane());
    // one transaction, because GDAL would otherwise sync the disk for each feature
    dataset_->StartTransaction();
    for (const MapLayer& layer : layers) write_layer(layer, reference);
    write_styles(layers);
    dataset_->CommitTransaction();
    dataset_.reset();  // writes what is still in memory
    require(CPLGetLastErrorType() != CE_Failure);
  }

 private:
  void require(bool success) const {
    if (!success) throw IoError(path_, "cannot be written: " + quiet_.complaints("GPKG"));
  }

  OGRLayer& create_layer(const std::string& name,
                         const std::string& description,
                         OGRSpatialReference* reference,
                         OGRwkbGeometryType type,
                         const std::vector<Column>& columns) {
    CPLStringList options;
    if (!description.empty()) options.SetNameValue("DESCRIPTION", description.c_str());
    OGRLayer* const layer = io::create_layer(*dataset_, name, reference, type, options.List());
    require(layer != nullptr);
    for (const Column& column : columns) {
      OGRFieldDefn field(as_utf8(column.name).c_str(), ogr_type(column.type));
      if (column.type == ColumnType::kBoolean) field.SetSubType(OFSTBoolean);
      require(layer->CreateField(&field) == OGRERR_NONE);
    }
    return *layer;
  }

  void write_layer(const MapLayer& layer, OGRSpatialReference& reference) {
    OGRLayer& target = create_layer(layer.name, layer.description, &reference,
                                    ogr_type(layer.geometry), layer.columns);
    for (const MapFeature& source : layer.features) {
      OGRFeature feature(target.GetLayerDefn());
      for (const auto& [column, value] : source.values) {
        set_value(value, static_cast<int>(column), layer.columns[column].type, feature);
      }
      if (auto geometry = geometry_of(source, layer.geometry)) {
        feature.SetGeometryDirectly(geometry.release());
      }
      require(target.CreateFeature(&feature) == OGRERR_NONE);
    }
  }

  /// The style table in the form that QGIS itself writes.
  void write_styles(const std::vector<MapLayer>& layers) {
    const std::vector<Column> columns{{"f_table_catalog", ColumnType::kText},
                                      {"f_table_schema", ColumnType::kText},
                                      {"f_table_name", ColumnType::kText},
                                      {"f_geometry_column", ColumnType::kText},
                                      {"styleName", ColumnType::kText},
                                      {"styleQML", ColumnType::kText},
                                      {"styleSLD", ColumnType::kText},
                                      {"useAsDefault", ColumnType::kBoolean},
                                      {"description", ColumnType::kText},
                                      {"owner", ColumnType::kText},
                                      {"ui", ColumnType::kText},
                                      {"update_time", ColumnType::kDateTime}};
    OGRLayer& styles = create_layer("layer_styles", "", nullptr, wkbNone, columns);
    for (const MapLayer& layer : layers) {
      if (layer.style.qml.empty()) continue;
      OGRFeature row(styles.GetLayerDefn());
      for (const char* const empty : {"f_table_catalog", "f_table_schema", "owner"}) {
        row.SetField(empty, "");
      }
      row.SetField("f_table_name", layer.name.c_str());
      row.SetField("f_geometry_column", kGeometryColumn);
      row.SetField("styleName", layer.style.name.c_str());
      row.SetField("styleQML", layer.style.qml.c_str());
      row.SetField("styleSLD", layer.style.sld.c_str());
      row.SetField("useAsDefault", 1);
      row.SetField("description", layer.description.c_str());
      row.SetField("update_time", FixedDate::kText);
      require(styles.CreateFeature(&row) == OGRERR_NONE);
    }
  }

  std::string path_;
  FixedDate fixed_date_;
  QuietGdal quiet_;
  GDALDatasetUniquePtr dataset_;
};

}  // namespace

void write_geopackage(const std::string& path,
                      const Crs& crs,
                      const std::vector<MapLayer>& layers) {
  register_gdal_drivers();
  CPLErrorReset();
  const ScratchFolder scratch(path);
  GeopackageWriter(path, scratch.draft()).write(crs, layers);
  scratch.publish();
}

}  // namespace ridgeline::io
