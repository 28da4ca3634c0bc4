// SPDX-License-Identifier: BSD-3-Clause
// Facts: Bentley, "BlocksExchange XML format", ContextCapture User Guide.
#include "io/error.h"
#include "io/orientation/camera_file.h"
#include "io/orientation/geocentric_poses.h"
#include "io/orientation/readers.h"
#include "io/orientation/xml_tree.h"
#include "io/text/text.h"
#include "reconstruct/geometry/degrees.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ridgeline::io {
namespace {

/// The directions of the camera's x and y axes in the image; z completes a right-handed system, so
/// that it points forwards or backwards.
struct CameraAxes {
  std::string_view name;
  Eigen::Vector2i x, y;  ///< in the image: right and UP
};

const std::array kCameraAxes{
    CameraAxes{"XRightYDown", {1, 0}, {0, -1}}, CameraAxes{"XRightYUp", {1, 0}, {0, 1}},
    CameraAxes{"XLeftYDown", {-1, 0}, {0, -1}}, CameraAxes{"XLeftYUp", {-1, 0}, {0, 1}},
    CameraAxes{"XDownYRight", {0, -1}, {1, 0}}, CameraAxes{"XDownYLeft", {0, -1}, {-1, 0}},
    CameraAxes{"XUpYRight", {0, 1}, {1, 0}},    CameraAxes{"XUpYLeft", {0, 1}, {-1, 0}}};

/// The rotation from the file's camera axes to ours: x right, y up, looking along -z.
Eigen::Matrix3d ours_from_axes(const XmlElement& photogroup) {
  const std::string stated = photogroup.child("CameraOrientation").text();
  const std::string name = stated.empty() ? "XRightYDown" : stated;
  const auto* const axes = std::ranges::find(kCameraAxes, name, &CameraAxes::name);
  if (axes == kCameraAxes.end()) {
    photogroup.fail(
        fmt::format("CameraOrientation {}; must be one of the eight from XRightYDown to "
                    "XUpYLeft",
                    name));
  }
  Eigen::Matrix3d R;
  R.col(0) << axes->x.cast<double>(), 0.0;
  R.col(1) << axes->y.cast<double>(), 0.0;
  R.col(2) = R.col(0).cross(R.col(1));
  return R;
}

/// The coefficients map ideal to distorted coordinates; p1 and p2 are swapped relative to ours.
BrownDistortion distortion_of(const XmlElement& distortion) {
  const auto value = [&](const char* name) { return distortion.number_or(name, 0.0); };
  return {value("K1"), value("K2"), value("K3"), value("P2"), value("P1")};
}

Eigen::Vector2i size_of(const XmlElement& photogroup) {
  constexpr double kMaxSide_px = 1e6;
  const Eigen::Vector2d size(photogroup.number("ImageDimensions/Width"),
                             photogroup.number("ImageDimensions/Height"));
  if (size.minCoeff() < 1.0 || size.maxCoeff() > kMaxSide_px) {
    photogroup.fail(fmt::format("{} x {} px; must be positive", size.x(), size.y()));
  }
  return size.cast<int>();
}

double focal_px(const XmlElement& photogroup, double longer_side_px) {
  if (const auto focal = photogroup.number_if_there("FocalLengthPixels")) return *focal;
  if (const auto size_mm = photogroup.number_if_there("SensorSize")) {
    return photogroup.number("FocalLength") / *size_mm * longer_side_px;
  }
  return photogroup.number("FocalLength35mmEq") / 36.0 * longer_side_px;
}

/// Pixels are counted from the corner of the image.
InteriorOrientation photogroup_interior(const std::string& path, const XmlElement& photogroup) {
  const std::string model = photogroup.child("CameraModelType").text();
  if (!model.empty() && model != "Perspective") {
    photogroup.fail("CameraModelType " + model + "; only Perspective is supported");
  }
  InteriorOrientation interior;
  interior.size_px = size_of(photogroup);
  const Eigen::Vector2d size_px = interior.size_px->cast<double>();
  const double focal = focal_px(photogroup, size_px.maxCoeff());
  const double aspect = photogroup.number_or("AspectRatio", 1.0);
  interior.focal_length_px = {focal, focal * aspect};
  if (!(interior.focal_length_px.minCoeff() > 0.0)) {
    photogroup.fail(
        fmt::format("focal length {} px, AspectRatio {}; must be positive", focal, aspect));
  }
  interior.principal_point_px = {photogroup.number_or("PrincipalPoint/x", 0.5 * size_px.x()) - 0.5,
                                 photogroup.number_or("PrincipalPoint/y", 0.5 * size_px.y()) - 0.5};
  interior.distortion = distortion_of(photogroup.child("Distortion"));
  require_negligible(path, "Skew", photogroup.number_or("Skew", 0.0) * size_px.maxCoeff());
  return interior;
}

/// The rotation from world to the file's camera axes.
Eigen::Matrix3d rotation_of(const XmlElement& rotation) {
  if (rotation.child("Omega").exists()) {
    // the angles give the matrix that the file could contain instead, for the same camera axes
    return world_from_camera_axes(kRadPerDeg * rotation.number("Omega"),
                                  kRadPerDeg * rotation.number("Phi"),
                                  kRadPerDeg * rotation.number("Kappa"))
        .transpose();
  }
  Eigen::Matrix3d R;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      R(row, column) = rotation.number(fmt::format("M_{}{}", row, column));
    }
  }
  return R;
}

class ExchangeReader {
 public:
  ExchangeReader(const std::string& path, const OrientationOptions& options)
      : path_(path), document_(path), root_(document_.root("BlocksExchange")), options_(options) {}

  [[nodiscard]] Orientation read() {
    const std::vector<XmlElement> blocks = root_.children("Block");
    if (blocks.size() != 1) {
      throw IoError(path_, fmt::format("has {} blocks; must have one", blocks.size()));
    }
    orientation_.format = "BlocksExchange";
    for (const XmlElement& group : blocks[0].children("Photogroups")) {
      for (const XmlElement& photogroup : group.children("Photogroup")) add_group(photogroup);
    }
    if (n_unposed_ > 0) {
      orientation_.warnings.push_back(
          fmt::format("photos without a pose, ignored: {}", n_unposed_));
    }
    if (n_heights_ > 0) orientation_.ground_height_m = sum_of_heights_m_ / n_heights_;
    place_on_earth(srs_of(blocks[0].child("SRSId").text()));
    return std::move(orientation_);
  }

 private:
  void add_group(const XmlElement& photogroup) {
    const std::string name = photogroup.child("Name").text();
    orientation_.cameras.push_back(
        {name.empty() ? fmt::format("photogroup {}", orientation_.cameras.size()) : name,
         photogroup_interior(path_, photogroup)});
    const Eigen::Matrix3d ours = ours_from_axes(photogroup);
    for (const XmlElement& photo : photogroup.children("Photo")) add_photo(photo, ours);
  }

  void add_photo(const XmlElement& photo, const Eigen::Matrix3d& ours_from_file) {
    const XmlElement rotation = photo.child("Pose/Rotation");
    const XmlElement centre = photo.child("Pose/Center");
    if (!rotation.exists() || !centre.exists()) {
      ++n_unposed_;
      return;
    }
    OrientedImage image;
    image.name = photo.child("ImagePath").text();
    if (image.name.empty()) photo.fail("ImagePath is missing");
    image.camera = orientation_.cameras.size() - 1;
    image.exterior.position_m = centre.xyz();
    image.exterior.world_from_camera_axes =
        rotation_of(rotation).transpose() * ours_from_file.transpose();
    add_ground(photo, image.exterior);
    orientation_.images.push_back(std::move(image));
  }

  /// The ground is assumed to lie at the median depth below the centre of a photo.
  void add_ground(const XmlElement& photo, const ExteriorOrientation& exterior) {
    const auto depth = photo.number_if_there("MedianDepth");
    if (!depth) return;
    sum_of_heights_m_ += exterior.position_m.z() - *depth * exterior.world_from_camera_axes(2, 2);
    ++n_heights_;
  }

  [[nodiscard]] std::string srs_of(const std::string& id) const {
    for (const XmlElement& srs : root_.child("SpatialReferenceSystems").children("SRS")) {
      if (!id.empty() && srs.child("Id").text() == id) return srs.child("Definition").text();
    }
    return "";
  }

  void place_on_earth(const std::string& srs) {
    if (srs.starts_with("ENU:")) {
      const std::size_t comma = srs.find(',');
      const auto lat = to_double(trimmed(std::string_view(srs).substr(4, comma - 4)));
      const auto lon = comma == std::string::npos
                           ? std::nullopt
                           : to_double(trimmed(std::string_view(srs).substr(comma + 1)));
      if (!lat || !lon || std::abs(*lat) > 90.0 || std::abs(*lon) > 360.0) {
        throw IoError(path_, srs + "; ENU: must be followed by latitude and longitude in degrees");
      }
      return convert_to_map(path_, geocentric_from_enu({*lat, *lon, 0.0}), options_.crs,
                            orientation_);
    }
    orientation_.crs.definition = srs == "WGS84" ? "EPSG:4326" : srs;
  }

  std::string path_;
  XmlDocument document_;
  XmlElement root_;
  const OrientationOptions& options_;
  Orientation orientation_;
  double sum_of_heights_m_ = 0.0;
  int n_heights_ = 0;
  int n_unposed_ = 0;
};

}  // namespace

Orientation read_blocks_exchange(const std::string& path, const OrientationOptions& options) {
  return ExchangeReader(path, options).read();
}

}  // namespace ridgeline::io
