// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/atomic_file.h"
#include "io/gdal/ogr_support.h"
#include "io/lines/attributes.h"
#include "io/lines/writers.h"
#include "io/text/json_text.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace ridgeline::io {
namespace {

/// A coordinate as JSON, which has no NaN: read_geojson() reads null as NaN.
std::string coordinate(double value) {
  return std::isfinite(value) ? fmt::format("{:.4f}", value) : "null";
}

std::string position(const Eigen::Vector3d& x) {
  return fmt::format("[{},{},{}]", coordinate(x.x()), coordinate(x.y()), coordinate(x.z()));
}

std::string sigmas_text(const Eigen::Matrix<double, 6, 6>& covariance_m2, int first) {
  const Eigen::Vector3d sigma_m = covariance_m2.diagonal().segment<3>(first).cwiseSqrt();
  return fmt::format("[{:.5g},{:.5g},{:.5g}]", sigma_m.x(), sigma_m.y(), sigma_m.z());
}

std::string properties_text(const Line& line) {
  std::string text;
  const auto add = [&text](std::string_view name, const std::string& value) {
    text += fmt::format("{}\"{}\":{}", text.empty() ? "" : ",", name, value);
  };
  for (const TextAttribute& attribute : text_attributes()) {
    const std::string& value = line.*attribute.member;
    if (!value.empty()) add(attribute.name, json_text(value));
  }
  for (const SegmentAttribute& attribute : segment_attributes()) {
    const std::optional<Segment2>& segment = line.*attribute.member;
    if (segment) add(attribute.name, segment_text(*segment));
  }
  if (!line.observations.empty()) add("observations", observations_text(line.observations));
  for (const NumberAttribute& attribute : number_attributes()) {
    const std::optional<double>& value = line.*attribute.member;
    if (value) add(attribute.name, fmt::format("{:.4f}", *value));
  }
  if (line.epipolar_angle_deg) {
    add("epipolar_angle_deg", fmt::format("{:.4f}", *line.epipolar_angle_deg));
  }
  if (line.n_points) add("n_points", fmt::format("{}", *line.n_points));
  if (line.n_images) add("n_images", fmt::format("{}", *line.n_images));
  if (!line.plane_ids.empty()) {
    add("plane_ids", fmt::format("[{}]", fmt::join(line.plane_ids, ",")));
  }
  if (line.covariance_m2 && line.covariance_m2->allFinite()) {
    add("sigma_start_m", sigmas_text(*line.covariance_m2, 0));
    add("sigma_end_m", sigmas_text(*line.covariance_m2, 3));
    add("covariance", covariance_text(*line.covariance_m2));
  }
  return text;
}

/// RFC 7946: a feature without a location has a null geometry.
std::string geometry_text(const Segment3& segment) {
  if (!all_finite(segment)) return "null";
  return fmt::format("{{\"type\":\"LineString\",\"coordinates\":[{},{}]}}", position(segment.start),
                     position(segment.end));
}

std::string feature_text(const Line& line) {
  return fmt::format("{{\"type\":\"Feature\",\"properties\":{{{}}},\"geometry\":{}}}",
                     properties_text(line), geometry_text(line.segment_in_world));
}

/// The name of a CRS: "urn:ogc:def:crs:EPSG::25832" if all parts have EPSG codes, otherwise the
/// definition as it is.
std::string crs_name(const Crs& crs) {
  const std::optional<OGRSpatialReference> reference = spatial_reference(crs);
  if (!reference) return crs.definition;
  const auto code_of = [&](const char* part) -> std::optional<std::string> {
    const char* authority = reference->GetAuthorityName(part);
    const char* code = reference->GetAuthorityCode(part);
    if (authority == nullptr || code == nullptr || std::string_view(authority) != "EPSG") {
      return std::nullopt;
    }
    return code;
  };
  if (const auto code = code_of(nullptr)) return "urn:ogc:def:crs:EPSG::" + *code;
  const auto horizontal = code_of("PROJCS");
  const auto vertical = code_of("VERT_CS");
  if (!reference->IsCompound() || !horizontal || !vertical) return crs.definition;
  return fmt::format("urn:ogc:def:crs,crs:EPSG::{},crs:EPSG::{}", *horizontal, *vertical);
}

/// The CRS, or the undefined plane for an unknown one. GDAL, and so QGIS, assumes WGS 84 degrees
/// for a file without `crs` or with null.
Crs stated(const Crs& crs) {
  if (crs.known()) return crs;
  char* text = nullptr;
  undefined_plane().exportToWkt(&text);
  const std::unique_ptr<char, decltype(&VSIFree)> owner(text, VSIFree);
  return {text};
}

std::string crs_text(const Crs& crs) {
  return fmt::format("{{\"type\":\"name\",\"properties\":{{\"name\":{}}}}}",
                     json_text(crs_name(stated(crs))));
}

class GeoJsonWriter : public LineWriter {
 public:
  GeoJsonWriter(const std::string& path, const Crs& crs) : file_(path) {
    file_.stream() << "{\"type\":\"FeatureCollection\",\n\"crs\":" << crs_text(crs)
                   << ",\n\"features\":[";
  }

  void add(const Line& line) override {
    file_.stream() << (is_first_ ? "\n" : ",\n") << feature_text(line);
    is_first_ = false;
  }

  void commit() override {
    file_.stream() << "\n]}\n";
    file_.commit();
  }

 private:
  AtomicFile file_;
  bool is_first_ = true;
};

}  // namespace

std::unique_ptr<LineWriter> geojson_writer(const std::string& path, const Crs& crs) {
  return std::make_unique<GeoJsonWriter>(path, crs);
}

}  // namespace ridgeline::io
