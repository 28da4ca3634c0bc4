// SPDX-License-Identifier: BSD-3-Clause
// Facts: Bentley, "BlocksExchange XML format", ContextCapture User Guide.
#include "io/error.h"
#include "io/orientation/camera_file.h"
#include "io/orientation/geocentric_poses.h"
#include "io/orientation/left_out.h"
#include "io/orientation/readers.h"
#include "io/orientation/unread_elements.h"
#include "io/orientation/xml_tree.h"
#include "io/text/text.h"
#include "reconstruct/geometry/degrees.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

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

/// The rotation from world to image axes (x right, y down, z forwards) given by heading, elevation
/// and roll of the optical axis: at zero it points north, at a pitch of -90 degrees it points down
/// and the rows of the image run from north to south. Angles of an aircraft, whose camera looks
/// down at zero, are refused.
Eigen::Matrix3d image_from_world(const XmlElement& rotation) {
  const double pitch_deg = rotation.number("Pitch");
  constexpr double kMaxPitch_deg = -20.0;
  if (!(pitch_deg <= kMaxPitch_deg)) {
    rotation.fail(fmt::format(
        "Pitch = {}; must be at most {} degrees, as of a camera that looks down; for angles of the "
        "aircraft, export omega, phi and kappa or matrices instead",
        pitch_deg, kMaxPitch_deg));
  }
  const auto turn = [&](double angle_deg, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(kRadPerDeg * angle_deg, axis);
  };
  const Eigen::Matrix3d ned_from_body = (turn(rotation.number("Yaw"), Eigen::Vector3d::UnitZ()) *
                                         turn(pitch_deg, Eigen::Vector3d::UnitY()) *
                                         turn(rotation.number("Roll"), Eigen::Vector3d::UnitX()))
                                            .toRotationMatrix();
  Eigen::Matrix3d enu_from_ned;
  enu_from_ned << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  Eigen::Matrix3d body_from_image;
  body_from_image << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  return (enu_from_ned * ned_from_body * body_from_image).transpose();
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
    read_photos(blocks[0]);
    orientation_.warnings = left_out_.sentences();
    if (!unread_.sentence().empty()) orientation_.warnings.push_back(unread_.sentence());
    place_on_earth(srs_of(blocks[0].child("SRSId").text()));
    orientation_.ground_height_m = ground_height_m();
    return std::move(orientation_);
  }

 private:
  void read_photos(const XmlElement& block) {
    std::vector<XmlElement> photogroups;
    for (const XmlElement& group : block.children("Photogroups")) {
      std::ranges::copy(group.children("Photogroup"), std::back_inserter(photogroups));
    }
    main_component_ = main_component_of(photogroups);
    for (const XmlElement& photogroup : photogroups) {
      std::optional<GroupCamera> camera;
      for (const XmlElement& photo : photogroup.children("Photo")) {
        if (!is_read(photo)) continue;
        if (!camera) camera = add_camera(photogroup);
        add_photo(photo, *camera);
      }
    }
  }

  static bool has_pose(const XmlElement& photo) {
    return photo.child("Pose/Rotation").exists() && photo.child("Pose/Center").exists();
  }

  /// The component with the most poses. Only its photos are tied to each other.
  static std::string main_component_of(const std::vector<XmlElement>& photogroups) {
    std::map<std::string, int> n_poses;
    for (const XmlElement& photogroup : photogroups) {
      for (const XmlElement& photo : photogroup.children("Photo")) {
        if (has_pose(photo)) ++n_poses[photo.child("Component").text()];
      }
    }
    const auto main = std::ranges::max_element(n_poses, {}, &decltype(n_poses)::value_type::second);
    return main == n_poses.end() ? "" : main->first;
  }

  bool is_read(const XmlElement& photo) {
    const std::string path = photo.child("ImagePath").text();
    const std::string shown =
        path.empty() ? "Id " + photo.child("Id").text() : path.substr(path.find_last_of("/\\") + 1);
    const auto leave_out = [&](const char* reason) {
      left_out_.add(reason, shown);
      return false;
    };
    if (!has_pose(photo)) return leave_out("photos without a pose");
    if (path.empty()) return leave_out("photos without a name");
    return photo.child("Component").text() == main_component_ ||
           leave_out("photos of other components");
  }

  /// The camera of a photogroup, which is read only if a photo needs it.
  struct GroupCamera {
    std::size_t number = 0;  ///< in Orientation::cameras
    Eigen::Matrix3d ours_from_axes;
  };

  GroupCamera add_camera(const XmlElement& photogroup) {
    const std::string name = photogroup.child("Name").text();
    const std::size_t number = orientation_.cameras.size();
    orientation_.cameras.push_back({name.empty() ? fmt::format("photogroup {}", number) : name,
                                    photogroup_interior(path_, photogroup)});
    unread_.note(photogroup,
                 {"Name", "ImageDimensions", "CameraModelType", "CameraModelBand", "FocalLength",
                  "FocalLengthPixels", "FocalLength35mmEq", "SensorSize", "CameraOrientation",
                  "PrincipalPoint", "Distortion", "AspectRatio", "Skew", "Photo"});
    unread_.note(photogroup.child("Distortion"), {"K1", "K2", "K3", "P1", "P2"});
    return {number, ours_from_axes(photogroup)};
  }

  void add_photo(const XmlElement& photo, const GroupCamera& camera) {
    const XmlElement rotation = photo.child("Pose/Rotation");
    unread_.note(photo, {"Id", "ImagePath", "Name", "Component", "Pose", "NearDepth", "MedianDepth",
                         "FarDepth", "ExifData", "ViewerInfo", "DepthPath"});
    OrientedImage image;
    image.name = photo.child("ImagePath").text();
    image.camera = camera.number;
    image.exterior.position_m = photo.child("Pose/Center").xyz();
    if (rotation.child("Yaw").exists()) {
      const Eigen::Vector3d down_and_forwards(1.0, -1.0, -1.0);
      image.exterior.world_from_camera_axes =
          image_from_world(rotation).transpose() * down_and_forwards.asDiagonal();
    } else {
      image.exterior.world_from_camera_axes =
          rotation_of(rotation).transpose() * camera.ours_from_axes.transpose();
    }
    depths_m_.push_back(photo.number_if_there("MedianDepth"));
    orientation_.images.push_back(std::move(image));
  }

  /// The mean height of the ground, which is assumed to lie at the median depth below the centre
  /// of a photo. The poses must be on the map.
  [[nodiscard]] std::optional<double> ground_height_m() const {
    double sum_m = 0.0;
    int n = 0;
    for (std::size_t i = 0; i < depths_m_.size(); ++i) {
      if (!depths_m_[i]) continue;
      const ExteriorOrientation& exterior = orientation_.images[i].exterior;
      sum_m += exterior.position_m.z() - *depths_m_[i] * exterior.world_from_camera_axes(2, 2);
      ++n;
    }
    return n > 0 ? std::optional(sum_m / n) : std::nullopt;
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
    if (states_geocentric(orientation_.crs)) {
      convert_to_map(path_, Eigen::Isometry3d::Identity(), options_.crs, orientation_);
    }
  }

  std::string path_;
  XmlDocument document_;
  XmlElement root_;
  const OrientationOptions& options_;
  Orientation orientation_;
  std::vector<std::optional<double>> depths_m_;  ///< median depth of each image
  std::string main_component_;
  LeftOut left_out_;
  UnreadElements unread_;
};

}  // namespace

Orientation read_blocks_exchange(const std::string& path, const OrientationOptions& options) {
  return ExchangeReader(path, options).read();
}

}  // namespace ridgeline::io
