// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/files/scratch_folder.h"
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
  const char* angle_field;  ///< a Shapefile's column names have ten characters
  bool has_attributes;
  bool has_long_text;
};

OgrTarget target_of(LineFormat format) {
  if (format == LineFormat::kGeoPackage) return {"GPKG", "epipolar_angle_deg", true, true};
  if (format == LineFormat::kShapefile) return {"ESRI Shapefile", "epi_deg", true, false};
  return {"DXF", "", false, false};
}

class OgrWriter : public LineWriter {
 public:
  OgrWriter(const std::string& path, const Crs& crs, LineFormat format)
      : path_(path), target_(target_of(format)), scratch_(path) {
    require([&] { return create_dataset() && create_layer_in(crs) && create_fields(); });
    // All lines form one transaction, because a GeoPackage would otherwise sync the disk for each
    // line.
    dataset_->StartTransaction();
  }
  OgrWriter(const OgrWriter&) = delete;
  OgrWriter& operator=(const OgrWriter&) = delete;
  ~OgrWriter() override {
    const QuietGdal quiet;  // for a file that is abandoned
    dataset_.reset();
  }

  void add(const Line& line) override {
    require([&] { return create_feature(line); });
  }

  void commit() override {
    require([&] {
      dataset_->CommitTransaction();
      dataset_.reset();  // writes what is still in memory
      return CPLGetLastErrorType() != CE_Failure;
    });
    scratch_.publish();
  }

 private:
  /// Throws IoError with GDAL's message if the step fails.
  template <typename Step>
  void require(const Step& step) {
    const FixedDate fixed_date;
    const QuietGdal quiet;
    CPLErrorReset();
    if (!step()) throw IoError(path_, "cannot be written: " + quiet.complaints(target_.driver));
  }

  bool create_dataset() {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(target_.driver);
    if (driver == nullptr) return false;
    dataset_.reset(driver->Create(scratch_.draft().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    return dataset_ != nullptr;
  }

  bool create_layer_in(const Crs& crs) {
    std::optional<OGRSpatialReference> reference = spatial_reference(crs);
    if (!reference && target_.has_long_text) reference = undefined_plane();
    const std::string name = std::filesystem::path(path_).stem().string();
    layer_ =
        create_layer(*dataset_, name, reference ? &*reference : nullptr, wkbLineString25D, nullptr);
    return layer_ != nullptr;
  }

  bool create_field(std::string_view name, OGRFieldType type) {
    OGRFieldDefn field(std::string(name).c_str(), type);
    return layer_->CreateField(&field) == OGRERR_NONE;
  }

  bool create_fields() {
    if (!target_.has_attributes) return true;
    bool success = true;
    const auto create = [&](std::string_view name, OGRFieldType type) {
      success = create_field(name, type) && success;
    };
    for (const TextAttribute& attribute : text_attributes()) create(attribute.name, OFTString);
    create(target_.angle_field, OFTReal);
    create("n_points", OFTInteger);
    create("n_images", OFTInteger);
    create("plane_ids", OFTString);
    if (!target_.has_long_text) return success;
    for (const NumberAttribute& attribute : number_attributes()) create(attribute.name, OFTReal);
    for (const SegmentAttribute& attribute : segment_attributes())
      create(attribute.name, OFTString);
    create("observations", OFTString);
    create("covariance", OFTString);
    return success;
  }

  bool create_feature(const Line& line) {
    const Segment3& s = line.segment_in_world;
    OGRFeature feature(layer_->GetLayerDefn());
    if (target_.has_attributes) {
      set_attributes(line, feature);
    } else {
      const std::string& layer = line.line_class.empty() ? line.kind : line.line_class;
      feature.SetField("Layer", layer.empty() ? "0" : layer.c_str());
    }
    if (all_finite(s)) {
      OGRLineString geometry;
      geometry.addPoint(s.start.x(), s.start.y(), s.start.z());
      geometry.addPoint(s.end.x(), s.end.y(), s.end.z());
      feature.SetGeometry(&geometry);
    }
    return layer_->CreateFeature(&feature) == OGRERR_NONE;
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

  /// Sets the attributes whose value or name is too wide for a Shapefile column.
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
    if (!line.observations.empty())
      feature.SetField("observations", observations_text(line.observations).c_str());
    if (line.covariance_m2) {
      feature.SetField("covariance", covariance_text(*line.covariance_m2).c_str());
    }
  }

  std::string path_;
  OgrTarget target_;
  ScratchFolder scratch_;
  GDALDatasetUniquePtr dataset_;
  OGRLayer* layer_ = nullptr;
};

}  // namespace

std::unique_ptr<LineWriter> ogr_writer(const std::string& path, const Crs& crs, LineFormat format) {
  register_gdal_drivers();
  return std::make_unique<OgrWriter>(path, crs, format);
}

}  // namespace ridgeline::io
