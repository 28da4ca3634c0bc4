// SPDX-License-Identifier: BSD-3-Clause
// Facts: Agisoft, "Metashape Professional Edition" user manual, appendix on camera models.
#include "io/error.h"
#include "io/orientation/camera_file.h"
#include "io/orientation/geocentric_poses.h"
#include "io/orientation/readers.h"
#include "io/orientation/xml_tree.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace ridgeline::io {
namespace {

using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

/// A similarity: x_in_world = scale * rotation * x + translation.
struct Similarity {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  double scale = 1.0;
};

Similarity similarity_of(const XmlElement& transform) {
  Similarity similarity;
  if (!transform.child("rotation").exists()) return similarity;
  const std::vector<double> rotation = transform.child("rotation").numbers(9);
  similarity.rotation =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation.data());
  const std::vector<double> translation = transform.child("translation").numbers(3);
  similarity.translation = Eigen::Map<const Eigen::Vector3d>(translation.data());
  similarity.scale = transform.number("scale");
  if (!(similarity.scale > 0.0)) transform.fail("scale must be positive");
  return similarity;
}

/// The calibration from the bundle adjustment if there is one, otherwise the first one.
XmlElement calibration_of(const XmlElement& sensor) {
  const std::vector<XmlElement> all = sensor.children("calibration");
  for (const XmlElement& one : all) {
    if (one.attribute("class") == "adjusted") return one;
  }
  if (all.empty()) sensor.fail("has no calibration");
  return all.front();
}

/// Refuses unsupported coefficients whose effect on a pixel at the largest radius is too large to
/// be ignored.
void require_known_coefficients(const std::string& path,
                                const XmlElement& calibration,
                                const InteriorOrientation& interior) {
  const double r = largest_radius(interior);
  const double focal_px = interior.focal_length_px.y();
  require_negligible(path, "k4", calibration.number_or("k4", 0.0) * std::pow(r, 9) * focal_px);
  require_negligible(path, "b2", calibration.number_or("b2", 0.0) * r);
  const double tangential_px = 3.0 * interior.distortion.p1 * interior.distortion.p1 +
                               3.0 * interior.distortion.p2 * interior.distortion.p2;
  const double p = std::sqrt(tangential_px) * r * r * focal_px;
  require_negligible(path, "p3", calibration.number_or("p3", 0.0) * r * r * p);
  require_negligible(path, "p4", calibration.number_or("p4", 0.0) * std::pow(r, 4) * p);
}

/// Pixels are counted from the corner of the image, cx and cy from its centre. p1 and p2 are
/// swapped relative to ours.
InteriorOrientation sensor_interior(const std::string& path, const XmlElement& sensor) {
  const XmlElement calibration = calibration_of(sensor);
  for (const std::string& type : {sensor.attribute("type"), calibration.attribute("type")}) {
    if (!type.empty() && type != "frame") sensor.fail("type " + type + "; only frame is supported");
  }
  const XmlElement resolution = calibration.child("resolution");
  const Eigen::Vector2d size_px(resolution.attribute_number("width"),
                                resolution.attribute_number("height"));
  constexpr double kMaxSide_px = 1e6;
  if (size_px.minCoeff() < 1.0 || size_px.maxCoeff() > kMaxSide_px)
    sensor.fail("its size must be positive");
  const auto value = [&](const char* name) { return calibration.number_or(name, 0.0); };
  InteriorOrientation interior;
  interior.size_px = size_px.cast<int>();
  const double focal_px = calibration.number("f");
  interior.focal_length_px = {focal_px + value("b1"), focal_px};
  if (!(interior.focal_length_px.minCoeff() > 0.0)) sensor.fail("f must be positive");
  interior.principal_point_px = {0.5 * size_px.x() + value("cx") - 0.5,
                                 0.5 * size_px.y() + value("cy") - 0.5};
  interior.distortion = {value("k1"), value("k2"), value("k3"), value("p2"), value("p1")};
  require_known_coefficients(path, calibration, interior);
  return interior;
}

class ChunkReader {
 public:
  ChunkReader(const std::string& path, const OrientationOptions& options)
      : path_(path), document_(path), options_(options), chunk_(only_chunk()) {}

  [[nodiscard]] Orientation read() {
    orientation_.format = "Metashape cameras";
    for (const XmlElement& sensor : chunk_.child("sensors").children("sensor")) {
      sensors_.emplace(sensor.attribute("id"), sensor);
    }
    for (const XmlElement& component : chunk_.child("components").children("component")) {
      block_from_component_.emplace(component.attribute("id"),
                                    similarity_of(component.child("transform")));
    }
    chunk_from_all_ = similarity_of(chunk_.child("transform"));
    add_cameras(chunk_.child("cameras"));
    if (n_unposed_ > 0) {
      orientation_.warnings.push_back(
          fmt::format("cameras without a pose, ignored: {}", n_unposed_));
    }
    place_on_earth();
    return std::move(orientation_);
  }

 private:
  [[nodiscard]] XmlElement only_chunk() const {
    const std::vector<XmlElement> chunks = document_.root("document").children("chunk");
    if (chunks.size() != 1) {
      throw IoError(path_, fmt::format("has {} chunks; must have one", chunks.size()));
    }
    return chunks.front();
  }

  /// Cameras may be in groups.
  void add_cameras(const XmlElement& parent) {
    for (const XmlElement& camera : parent.children("camera")) add_camera(camera);
    for (const XmlElement& group : parent.children("group")) {
      for (const XmlElement& camera : group.children("camera")) add_camera(camera);
    }
  }

  void add_camera(const XmlElement& camera) {
    if (!camera.child("transform").exists()) {
      ++n_unposed_;
      return;
    }
    const std::vector<double> values = camera.child("transform").numbers(16);
    const Matrix4 chunk_from_cam = Eigen::Map<const Matrix4>(values.data());
    const Similarity& world_from_chunk = similarity_at(camera.attribute("component_id"));
    OrientedImage image;
    image.name = camera.attribute("label");
    image.camera = camera_number(camera);
    image.exterior.position_m =
        world_from_chunk.scale * world_from_chunk.rotation * chunk_from_cam.topRightCorner<3, 1>() +
        world_from_chunk.translation;
    const Eigen::Vector3d flip(1.0, -1.0, -1.0);
    image.exterior.world_from_camera_axes =
        world_from_chunk.rotation * chunk_from_cam.topLeftCorner<3, 3>() * flip.asDiagonal();
    orientation_.images.push_back(std::move(image));
  }

  [[nodiscard]] const Similarity& similarity_at(const std::string& component) const {
    const auto found = block_from_component_.find(component);
    return found == block_from_component_.end() ? chunk_from_all_ : found->second;
  }

  /// The camera of a sensor is created when its first image needs it, so that sensors without
  /// images are not checked.
  [[nodiscard]] std::size_t camera_number(const XmlElement& camera) {
    const std::string id = camera.attribute("sensor_id");
    if (const auto known = camera_of_sensor_.find(id); known != camera_of_sensor_.end()) {
      return known->second;
    }
    const auto sensor = sensors_.find(id);
    if (sensor == sensors_.end()) camera.fail(fmt::format("sensor {} is not in the file", id));
    const std::string label = sensor->second.attribute("label");
    orientation_.cameras.push_back(
        {label.empty() ? "sensor " + id : label, sensor_interior(path_, sensor->second)});
    return camera_of_sensor_[id] = orientation_.cameras.size() - 1;
  }

  /// A block with any reference system other than a local one has geocentric coordinates.
  void place_on_earth() {
    const std::string reference = chunk_.child("reference").text();
    if (reference.empty() || reference.starts_with("LOCAL_CS")) {
      orientation_.warnings.emplace_back("has local coordinates without a reference system");
      return;
    }
    const bool is_projected = reference.find("PROJCS") != std::string::npos ||
                              reference.find("PROJCRS") != std::string::npos;
    const Crs map = options_.crs.known() ? options_.crs : is_projected ? Crs{reference} : Crs{};
    convert_to_map(path_, Eigen::Isometry3d::Identity(), map, orientation_);
  }

  std::string path_;
  XmlDocument document_;
  const OrientationOptions& options_;
  XmlElement chunk_;
  std::map<std::string, XmlElement> sensors_;
  std::map<std::string, Similarity> block_from_component_;
  Similarity chunk_from_all_;
  std::map<std::string, std::size_t> camera_of_sensor_;
  Orientation orientation_;
  int n_unposed_ = 0;
};

}  // namespace

Orientation read_metashape(const std::string& path, const OrientationOptions& options) {
  return ChunkReader(path, options).read();
}

}  // namespace ridgeline::io
