// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/gdal/ogr_support.h"
#include "io/lines/attributes.h"
#include "io/lines/writers.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <filesystem>

namespace ridgeline::io {
namespace {

struct OgrTarget {
  const char* driver;
  const char* angle_field;  ///< a Shapefile's columns have ten characters
  bool has_attributes;
  bool has_long_text;
};

OgrTarget target_of(LineFormat format) {
  if (format == LineFormat::kGeoPackage) return {"GPKG", "epipolar_angle_deg", true, true};
  if (format == LineFormat::kShapefile) return {"ESRI Shapefile", "epi_deg", true, false};
  return {"DXF", "", false, false};
}

class OgrWriter {
 public:
  OgrWriter(const std::string& path, const std::string& draft, LineFormat format)
      : path_(path), target_(target_of(format)) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(target_.driver);
    if (driver != nullptr) {
      dataset_.reset(driver->Create(draft.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    }
    require(dataset_ != nullptr);
  }

  void write(const LineSet& set) {
    std::optional<OGRSpatialReference> reference = spatial_reference(set.crs);
    if (!reference && target_.has_long_text) reference = undefined_plane();
    const std::string name = std::filesystem::path(path_).stem().string();
    layer_ =
        create_layer(*dataset_, name, reference ? &*reference : nullptr, wkbLineString25D, nullptr);
    require(layer_ != nullptr);
    create_fields();
    // All lines are one transaction, as a GeoPackage would otherwise sync the disk for each line.
    dataset_->StartTransaction();
    for (const Line& line : set.lines) write_line(line);
    dataset_->CommitTransaction();
    dataset_.reset();  // writes what is still in memory
    require(CPLGetLastErrorType() != CE_Failure);
  }

 private:
  void require(bool success) const {
    if (!success) throw IoError(path_, "cannot be written: " + quiet_.complaints(target_.driver));
  }

  void create_field(std::string_view name, OGRFieldType type) {
    OGRFieldDefn field(std::string(name).c_str(), type);
    require(layer_->CreateField(&field) == OGRERR_NONE);
  }

  void create_fields() {
    if (!target_.has_attributes) return;
    for (const TextAttribute& attribute : text_attributes())
      create_field(attribute.name, OFTString);
    create_field(target_.angle_field, OFTReal);
    create_field("n_points", OFTInteger);
    create_field("n_images", OFTInteger);
    create_field("plane_ids", OFTString);
    if (!target_.has_long_text) return;
    for (const NumberAttribute& attribute : number_attributes()) {
      create_field(attribute.name, OFTReal);
    }
    for (const SegmentAttribute& attribute : segment_attributes()) {
      create_field(attribute.name, OFTString);
    }
    create_field("sightings", OFTString);
    create_field("covariance", OFTString);
  }

  void set_attributes(const Line& line, OGRFeature& feature) const {
    for (const TextAttribute& attribute : text_attributes()) {
      const std::string& value = line.*attribute.member;
      if (!value.empty()) feature.SetField(std::string(attribute.name).c_str(), value.c_str());
    }
    if (line.epipolar_angle_deg) feature.SetField(target_.angle_field, *line.epipolar_angle_deg);
    if (line.n_points) feature.SetField("n_points", *line.n_points);
    if (line.n_images) feature.SetField("n_images", *line.n_images);
    if (!line.plane_ids.empty()) {
      feature.SetField("plane_ids", fmt::format("[{}]", fmt::join(line.plane_ids, ",")).c_str());
    }
    if (target_.has_long_text) set_wide_attributes(line, feature);
  }

  /// Sets what does not fit into a Shapefile's columns, by the width of the value or of the name.
  static void set_wide_attributes(const Line& line, OGRFeature& feature) {
    for (const NumberAttribute& attribute : number_attributes()) {
      const std::optional<double>& value = line.*attribute.member;
      if (value) feature.SetField(std::string(attribute.name).c_str(), *value);
    }
    for (const SegmentAttribute& attribute : segment_attributes()) {
      const std::optional<Segment2>& segment = line.*attribute.member;
      if (!segment) continue;
      feature.SetField(std::string(attribute.name).c_str(), segment_text(*segment).c_str());
    }
    if (!line.sightings.empty())
      feature.SetField("sightings", sightings_text(line.sightings).c_str());
    if (line.covariance_m2) {
      feature.SetField("covariance", covariance_text(*line.covariance_m2).c_str());
    }
  }

  void write_line(const Line& line) {
    const Segment3& s = line.segment_in_world;
    OGRFeature feature(layer_->GetLayerDefn());
    if (target_.has_attributes) {
      set_attributes(line, feature);
    } else {
      feature.SetField("Layer", line.line_class.empty() ? "0" : line.line_class.c_str());
    }
    if (all_finite(s)) {
      OGRLineString geometry;
      geometry.addPoint(s.start.x(), s.start.y(), s.start.z());
      geometry.addPoint(s.end.x(), s.end.y(), s.end.z());
      feature.SetGeometry(&geometry);
    }
    require(layer_->CreateFeature(&feature) == OGRERR_NONE);
  }

  std::string path_;
  OgrTarget target_;
  FixedDate fixed_date_;
  QuietGdal quiet_;
  GDALDatasetUniquePtr dataset_;
  OGRLayer* layer_ = nullptr;
};

}  // namespace

void write_ogr(const std::string& path,
               const std::string& draft,
               const LineSet& set,
               LineFormat format) {
  register_gdal_drivers();
  CPLErrorReset();
  OgrWriter(path, draft, format).write(set);
}

}  // namespace ridgeline::io
