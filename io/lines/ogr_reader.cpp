// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/input_file.h"
#include "io/lines/attributes.h"
#include "io/lines/geopackage_check.h"
#include "io/lines/ogr_support.h"
#include "io/lines/polyline.h"
#include "io/lines/readers.h"
#include "io/lines/text.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cstring>
#include <filesystem>
#include <map>

namespace ridgeline::io {
namespace {

struct Driver {
  const char* name;
  const char* format;
};

Driver driver_for(std::string_view extension) {
  if (extension == ".gpkg") return {"GPKG", "GeoPackage"};
  if (extension == ".shp") return {"ESRI Shapefile", "Shapefile"};
  return {"DXF", "DXF"};
}

/// GDAL would open a Shapefile without z as lines at height 0.
void refuse_flat_shapefile(const std::string& path) {
  const std::string bytes = read_input(path);
  if (bytes.size() < 100) throw IoError(path, "is no Shapefile: shorter than its header");
  std::int32_t type = 0;
  std::memcpy(&type, bytes.data() + 32, sizeof type);
  if (type == 3 || type == 23) {
    throw IoError(
        path, fmt::format("shape type {} ({}) has no z; 3D lines need type 13 (PolyLineZ)", type,
                          type == 3 ? "PolyLine" : "PolyLineM"));
  }
}

nlohmann::json value_of(OGRFeature& feature, int field) {
  if (!feature.IsFieldSetAndNotNull(field)) return nullptr;
  switch (feature.GetFieldDefnRef(field)->GetType()) {
    case OFTInteger:
    case OFTInteger64:
      return feature.GetFieldAsInteger64(field);
    case OFTReal:
      return feature.GetFieldAsDouble(field);
    default:
      return feature.GetFieldAsString(field);
  }
}

nlohmann::json properties_of(OGRFeature& feature) {
  nlohmann::json properties = nlohmann::json::object();
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    properties[feature.GetFieldDefnRef(i)->GetNameRef()] = value_of(feature, i);
  }
  // DXF has no attributes of its own: the layer is the class.
  if (properties.contains("Layer") && properties.contains("EntityHandle")) {
    properties["class"] = properties["Layer"];
  }
  return properties;
}

class OgrReader {
 public:
  OgrReader(const std::string& path, const Driver& driver) : path_(path) {
    set_ = lines_for_file(path, driver.format, std::filesystem::file_size(path));
    const char* const drivers[] = {driver.name, nullptr};
    // tables that are no layers may be views, whatever they compute
    const char* const stated_layers[] = {"LIST_ALL_TABLES=NO", nullptr};
    const bool is_geopackage = std::string_view(driver.name) == "GPKG";
    const unsigned int flags = GDAL_OF_VECTOR | GDAL_OF_READONLY;
    dataset_.reset(
        GDALDataset::Open(path.c_str(), flags, drivers, is_geopackage ? stated_layers : nullptr));
    n_most_features_ = std::filesystem::file_size(path);  // each takes a byte at least
    if (!dataset_) {
      throw IoError(
          path, fmt::format("is no {}: {}", driver.format, quiet_.complaints("cannot be opened")));
    }
  }

  LineSet read() {
    for (OGRLayer* layer : dataset_->GetLayers()) read_layer(*layer);
    for (const auto& [type, count] : n_other_types_) {
      set_.warnings.push_back(fmt::format("{} features are no lines: {}", count, type));
    }
    return std::move(set_);
  }

 private:
  void read_layer(OGRLayer& layer) {
    const Crs crs = crs_of(layer.GetSpatialRef());
    if (set_.crs.known() && crs.known() && crs.definition != set_.crs.definition) {
      throw IoError(path_, "layers in different CRS; give one layer a file");
    }
    if (crs.known()) set_.crs = crs;
    for (const OGRFeatureUniquePtr& feature : layer) read_feature(*feature);
    if (CPLGetLastErrorType() == CE_Failure) throw IoError(path_, quiet_.complaints("is damaged"));
  }

  /// Records of a damaged file may lead to each other without end.
  void count_feature() {
    if (++number_ <= n_most_features_) return;
    throw IoError(path_, fmt::format("gives more than {} features; its size cannot hold them",
                                     n_most_features_));
  }

  void read_feature(OGRFeature& feature) {
    const std::string where = fmt::format("{}: feature {}", path_, number_);
    const OGRGeometry* geometry = feature.GetGeometryRef();
    OgrLines lines;
    if (geometry != nullptr) lines = lines_of(*geometry);
    if (geometry != nullptr && !lines.is_line) {
      ++n_other_types_[geometry->getGeometryName()];
    } else {
      append_feature(line_from_properties(properties_of(feature), where), lines.parts, number_,
                     set_);
    }
    count_feature();
  }

  std::string path_;
  QuietGdal quiet_;
  GDALDatasetUniquePtr dataset_;
  LineSet set_;
  std::size_t number_ = 0;
  std::size_t n_most_features_ = 0;
  std::map<std::string, int> n_other_types_;
};

}  // namespace

LineSet read_ogr(const std::string& path, std::string_view extension) {
  require_regular_file(path);
  if (std::filesystem::file_size(path) == 0) throw IoError(path, "is empty");
  if (extension == ".shp") refuse_flat_shapefile(path);
  if (extension == ".gpkg") refuse_computed_layers(path);
  GDALAllRegister();
  CPLErrorReset();
  return OgrReader(path, driver_for(extension)).read();
}

}  // namespace ridgeline::io
