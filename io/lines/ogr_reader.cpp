// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/files/input_file.h"
#include "io/gdal/ogr_support.h"
#include "io/kinds/recognise.h"
#include "io/lines/dxf_header.h"
#include "io/lines/feature_collector.h"
#include "io/lines/geopackage_check.h"
#include "io/lines/ogr_geometry.h"
#include "io/lines/readers.h"
#include "io/models/lod.h"
#include "io/text/text.h"
#include "io/text/utf8.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

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

/// Throws IoError for a Shapefile without z, which GDAL would open as lines at height 0.
void require_heights(const std::string& path) {
  const std::string bytes = beginning_of(path);
  if (bytes.size() < 100) throw IoError(path, "is not a Shapefile: shorter than its header");
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
      return as_utf8(feature.GetFieldAsString(field));
  }
}

ColumnType type_of(const OGRFieldDefn& field) {
  switch (field.GetType()) {
    case OFTInteger:
      return field.GetSubType() == OFSTBoolean ? ColumnType::kBoolean : ColumnType::kInteger;
    case OFTInteger64:
      return ColumnType::kInteger64;
    case OFTReal:
      return ColumnType::kReal;
    case OFTDate:
      return ColumnType::kDate;
    case OFTTime:
      return ColumnType::kTime;
    case OFTDateTime:
      return ColumnType::kDateTime;
    case OFTBinary:
      return ColumnType::kBinary;
    default:
      return ColumnType::kText;
  }
}

Value typed_value_of(OGRFeature& feature, int field) {
  switch (feature.GetFieldDefnRef(field)->GetType()) {
    case OFTInteger:
    case OFTInteger64:
      return static_cast<std::int64_t>(feature.GetFieldAsInteger64(field));
    case OFTReal:
      return feature.GetFieldAsDouble(field);
    case OFTBinary: {
      int n_bytes = 0;
      const GByte* const bytes = feature.GetFieldAsBinary(field, &n_bytes);
      return std::string(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(n_bytes));
    }
    default:
      return as_utf8(feature.GetFieldAsString(field));
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

/// The reference system of the layers that provide lines.
class LayersCrs {
 public:
  /// Adds the system of another layer. Throws IoError naming both layers if an earlier one states a
  /// different system.
  void take(const std::string& path, const std::string& layer, const Crs& crs) {
    if (!crs.known()) return;
    if (crs_.known() && crs.definition != crs_.definition) {
      throw IoError(
          path, fmt::format("layers in different CRS: {} in {}, {} in {}; use one file per layer",
                            layer_, describe(crs_).name, layer, describe(crs).name));
    }
    crs_ = crs;
    layer_ = layer;
  }
  [[nodiscard]] const Crs& crs() const { return crs_; }

 private:
  Crs crs_;
  std::string layer_;
};

class OgrReader {
 public:
  OgrReader(const std::string& path, const Driver& driver, const std::string& lod)
      : path_(path),
        lod_(lod),
        set_(lines_for_file(path, driver.format, std::filesystem::file_size(path))),
        features_(set_) {
    const bool is_geopackage = std::string_view(driver.name) == "GPKG";
    if (is_geopackage) unread_ = unread_layers(path);
    if (std::string_view(driver.name) == "DXF") dxf_ = dxf_header(read_input(path));
    const char* const drivers[] = {driver.name, nullptr};
    // Tables that are not layers are not opened, because they may be views, which can compute
    // anything.
    const char* const stated_layers[] = {"LIST_ALL_TABLES=NO", nullptr};
    const unsigned int flags = GDAL_OF_VECTOR | GDAL_OF_READONLY;
    dataset_.reset(
        GDALDataset::Open(path.c_str(), flags, drivers, is_geopackage ? stated_layers : nullptr));
    n_most_features_ = std::filesystem::file_size(path);  // each takes at least one byte
    if (!dataset_) {
      throw IoError(path,
                    fmt::format("is not a {}: {}", driver.format,
                                quiet_.complaints("the content is damaged or has another format")));
    }
  }

  LineSet read() {
    const std::vector<OGRLayer*> layers = feature_layers();
    ids_name_layer_ = layers.size() > 1;
    for (OGRLayer* layer : layers) read_layer(*layer);
    const Crs& of_lines = (features_.takes_polygons() ? surfaces_crs_ : lines_crs_).crs();
    if (of_lines.known()) set_.crs = of_lines;
    features_.finish();
    set_.stated_unit = dxf_.unit;
    return std::move(set_);
  }

 private:
  /// Whether a layer must not be read.
  [[nodiscard]] bool is_unread(OGRLayer& layer) const {
    const std::string name = lower_case(layer.GetName());
    return std::ranges::any_of(
        unread_, [&](const UnreadLayer& unread) { return lower_case(unread.name) == name; });
  }

  /// The layers with geometries. If there are several, only the one called `lines` is taken, as in
  /// our own maps, or, for 3DBAG, the one with the requested level of detail.
  std::vector<OGRLayer*> feature_layers() {
    std::vector<OGRLayer*> layers;
    for (OGRLayer* layer : dataset_->GetLayers()) {
      if (is_unread(*layer)) continue;
      if (layer->GetGeomType() == wkbNone) {
        n_rows_ += static_cast<std::size_t>(std::max<GIntBig>(layer->GetFeatureCount(), 0));
        continue;
      }
      layers.push_back(layer);
    }
    if (layers.empty()) require_layer();
    for (const UnreadLayer& unread : unread_) {
      set_.warnings.push_back(fmt::format("ignored: layer {} {}", unread.name, unread.why));
    }
    const auto chosen = std::ranges::find(layers, chosen_name(layers), name_of);
    if (chosen == layers.end() || layers.size() == 1) return layers;
    std::vector<std::string> others;
    for (OGRLayer* layer : layers)
      if (layer != *chosen) others.push_back(name_of(layer) + surplus_of(*layer, **chosen));
    set_.warnings.push_back(
        fmt::format("reading layer {}; ignored: {}", name_of(*chosen), fmt::join(others, ", ")));
    return {*chosen};
  }

  /// " (3 features more)" for a level of detail in which more buildings or parts have faces than in
  /// the one that is read.
  static std::string surplus_of(OGRLayer& layer, OGRLayer& chosen) {
    const GIntBig n_more = layer.GetFeatureCount() - chosen.GetFeatureCount();
    if (lod_of(layer.GetName()).empty() || n_more <= 0) return "";
    return fmt::format(" ({} feature{} more)", n_more, n_more == 1 ? "" : "s");
  }

  static std::string name_of(OGRLayer* layer) { return layer->GetName(); }

  /// "2.2" for lod22_3d; empty for other layer names.
  static std::string lod_of(const std::string& layer) {
    static const std::regex pattern("lod([0-9])([0-9]?)_3d");
    std::smatch match;
    if (!std::regex_match(layer, match, pattern)) return "";
    return match[1].str() + (match[2].length() > 0 ? "." + match[2].str() : "");
  }

  [[nodiscard]] std::string chosen_name(const std::vector<OGRLayer*>& layers) const {
    std::map<std::string, std::string> by_lod;
    std::set<std::string> lods;
    for (OGRLayer* layer : layers) {
      std::string name = name_of(layer);
      if (name == "lines") return name;
      if (lods.insert(lod_of(name)).second) by_lod[lod_of(name)] = name;
    }
    lods.erase("");
    if (lods.empty()) return "";
    const std::optional<std::string> chosen = chosen_lod(lods, lod_);
    if (!chosen)
      throw IoError(path_, fmt::format("has no layer of LoD {}; available: LoD {}", lod_,
                                       fmt::join(lods, ", ")));
    return by_lod[*chosen];
  }

  void require_layer() {
    if (!unread_.empty()) {
      throw IoError(path_, fmt::format("layer {} {}", unread_.front().name, unread_.front().why));
    }
    set_.left_out.add(kinds::kTableRow, n_rows_);
  }

  /// Adds the columns of a layer to the set's table and returns their indices there.
  std::vector<std::size_t> add_columns(OGRFeatureDefn& layer) {
    std::vector<Column>& columns = set_.features.columns;
    std::vector<std::size_t> numbers;
    for (int i = 0; i < layer.GetFieldCount(); ++i) {
      const OGRFieldDefn* const field = layer.GetFieldDefn(i);
      const auto same_name = [&](const Column& c) { return c.name == field->GetNameRef(); };
      const auto found = std::find_if(columns.begin(), columns.end(), same_name);
      numbers.push_back(static_cast<std::size_t>(found - columns.begin()));
      if (found == columns.end()) {
        columns.push_back({field->GetNameRef(), type_of(*field)});
      } else {
        found->type = common_type(found->type, type_of(*field));
      }
    }
    return numbers;
  }

  [[nodiscard]] SparseRow values_of(OGRFeature& feature) const {
    SparseRow row;
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
      if (!feature.IsFieldSetAndNotNull(i)) continue;
      row.emplace_back(columns_[static_cast<std::size_t>(i)], typed_value_of(feature, i));
    }
    return row;
  }

  void read_layer(OGRLayer& layer) {
    columns_ = add_columns(*layer.GetLayerDefn());
    set_.layers.emplace_back(layer.GetName());
    const Crs crs = crs_of(layer.GetSpatialRef());
    if (!set_.crs.known()) set_.crs = crs;  // kept for a file without lines
    for (const OGRFeatureUniquePtr& feature : layer) read_feature(*feature, crs);
    if (CPLGetLastErrorType() == CE_Failure) throw IoError(path_, quiet_.complaints("is damaged"));
  }

  /// Throws IoError for too many features, because records of a damaged file may refer to each
  /// other endlessly.
  void count_feature() {
    if (++number_ <= n_most_features_) return;
    throw IoError(path_, fmt::format("yields more than {} features, more than its size can hold",
                                     n_most_features_));
  }

  [[nodiscard]] bool is_hidden(OGRFeature& feature) const {
    if (dxf_.hidden_layers.empty()) return false;
    const int field = feature.GetFieldIndex("Layer");
    return field >= 0 && dxf_.hidden_layers.contains(lower_case(feature.GetFieldAsString(field)));
  }

  void read_feature(OGRFeature& feature, const Crs& crs) {
    const std::string where = fmt::format("{}: feature {}", path_, number_);
    count_feature();
    if (is_hidden(feature)) return set_.left_out.add(kinds::kHiddenEntity);
    Feature found;
    if (const OGRGeometry* geometry = feature.GetGeometryRef()) {
      collect_geometry(*geometry, found.geometry);
    }
    if (!found.geometry.may_be_line()) return features_.add(std::move(found));
    (found.geometry.polygons.empty() ? lines_crs_ : surfaces_crs_)
        .take(path_, set_.layers.back(), crs);
    found.properties = properties_of(feature);
    found.fid = feature.GetFID();
    found.layer = static_cast<int>(set_.layers.size()) - 1;
    if (ids_name_layer_) found.id = fmt::format("{}.{}", set_.layers.back(), feature.GetFID());
    found.where = where;
    found.values = [row = values_of(feature)] { return row; };
    features_.add(std::move(found));
  }

  std::string path_, lod_;
  QuietGdal quiet_;
  GDALDatasetUniquePtr dataset_;
  LineSet set_;
  FeatureCollector features_;
  std::vector<UnreadLayer> unread_;
  std::size_t n_rows_ = 0;  ///< rows of tables without geometry
  DxfHeader dxf_;
  LayersCrs lines_crs_, surfaces_crs_;
  /// For each column of the layer being read, its index in the set's table.
  std::vector<std::size_t> columns_;
  /// Whether ids begin with the name of the layer, because feature ids start anew in each layer.
  bool ids_name_layer_ = false;
  std::size_t number_ = 0;
  std::size_t n_most_features_ = 0;
};

}  // namespace

LineSet read_ogr(const std::string& path, std::string_view extension, const std::string& lod) {
  require_regular_file(path);
  if (std::filesystem::file_size(path) == 0) throw IoError(path, "is empty");
  require_kind(path, FileGroup::kLines);
  if (extension == ".shp") require_heights(path);
  register_gdal_drivers();
  CPLErrorReset();
  return OgrReader(path, driver_for(extension), lod).read();
}

}  // namespace ridgeline::io
