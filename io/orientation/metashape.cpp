// SPDX-License-Identifier: BSD-3-Clause
// Facts: Agisoft, "Metashape Professional Edition" user manual, appendix on camera models.
#include "io/error.h"
#include "io/orientation/camera_file.h"
#include "io/orientation/geocentric_poses.h"
#include "io/orientation/left_out.h"
#include "io/orientation/readers.h"
#include "io/orientation/unread_elements.h"
#include "io/orientation/xml_tree.h"
#include "io/text/text.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace ridgeline::io {
namespace {

using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

/// A similarity: x_in_world = scale * rotation * x + translation.
struct Similarity {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  double scale = 1.0;
};

/// std::nullopt if the element does not exist or is empty.
std::optional<Similarity> similarity_of(const XmlElement& transform) {
  if (!transform.child("rotation").exists()) return std::nullopt;
  Similarity similarity;
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
    for (const XmlElement& chunk : document_.root("document").children("chunk")) {
      if (is_disabled(chunk) && !is_disabled(chunk_))
        left_out_.add("disabled chunks", chunk.attribute("label"));
    }
    read_components();
    add_cameras(chunk_.child("cameras"));
    orientation_.warnings = left_out_.sentences();
    if (!unread_.sentence().empty()) orientation_.warnings.push_back(unread_.sentence());
    place_on_earth();
    return std::move(orientation_);
  }

 private:
  [[nodiscard]] XmlElement only_chunk() const {
    std::vector<XmlElement> chunks = document_.root("document").children("chunk");
    if (chunks.size() > 1) std::erase_if(chunks, is_disabled);
    if (chunks.size() != 1) {
      throw IoError(path_, fmt::format("has {} enabled chunks; must have one", chunks.size()));
    }
    return chunks.front();
  }

  /// The transformation of the chunk is that of its active component. Where any part of the chunk
  /// has one, the place of a component without one is arbitrary; where none has, the places of all
  /// components relative to each other are, and only the active one is read.
  void read_components() {
    const XmlElement components = chunk_.child("components");
    const std::string active = components.attribute("active_id");
    const std::optional<Similarity> of_chunk = similarity_of(chunk_.child("transform"));
    for (const XmlElement& component : components.children("component")) {
      const std::string id = component.attribute("id");
      std::optional<Similarity> similarity = similarity_of(component.child("transform"));
      if (!similarity && id == active) similarity = of_chunk;
      if (similarity) world_from_component_.emplace(id, *similarity);
    }
    if (!world_from_component_.empty()) return;
    const std::string main = components.children("component").empty() ? "" : active;
    world_from_component_.emplace(main, of_chunk.value_or(Similarity()));
  }

  /// Cameras may be in groups.
  void add_cameras(const XmlElement& parent) {
    for (const XmlElement& camera : parent.children("camera")) add_camera(camera);
    for (const XmlElement& group : parent.children("group")) {
      for (const XmlElement& camera : group.children("camera")) add_camera(camera);
    }
  }

  void add_camera(const XmlElement& camera) {
    const std::string name = camera.attribute("label");
    const std::string shown = name.empty() ? "id " + camera.attribute("id") : name;
    if (!camera.child("transform").exists()) return left_out_.add("images without a pose", shown);
    if (is_disabled(camera)) return left_out_.add("disabled images", shown);
    if (name.empty()) return left_out_.add("images without a name", shown);
    const Similarity* const similarity = similarity_of_component(camera);
    if (similarity == nullptr) {
      return left_out_.add("images of a component without a place", shown);
    }
    unread_.note(camera, {"transform", "rotation_covariance", "location_covariance", "orientation",
                          "reference", "accuracy", "meta", "frames", "photo", "image"});
    add_image(camera, *similarity);
  }

  static bool is_disabled(const XmlElement& element) {
    const std::string enabled = lower_case(element.attribute("enabled"));
    return enabled == "false" || enabled == "0";
  }

  void add_image(const XmlElement& camera, const Similarity& world_from_chunk) {
    const std::vector<double> values = camera.child("transform").numbers(16);
    const Matrix4 chunk_from_cam = Eigen::Map<const Matrix4>(values.data());
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

  /// Null if the place of the component is unknown. Chunks with a single component may leave it
  /// out.
  [[nodiscard]] const Similarity* similarity_of_component(const XmlElement& camera) const {
    const auto found = world_from_component_.find(camera.attribute("component_id"));
    if (found != world_from_component_.end()) return &found->second;
    const bool is_only_one =
        camera.attribute("component_id").empty() || world_from_component_.begin()->first.empty();
    return is_only_one ? &world_from_component_.begin()->second : nullptr;
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
    note_unread(sensor->second);
    const std::string label = sensor->second.attribute("label");
    orientation_.cameras.push_back(
        {label.empty() ? "sensor " + id : label, sensor_interior(path_, sensor->second)});
    return camera_of_sensor_[id] = orientation_.cameras.size() - 1;
  }

  void note_unread(const XmlElement& sensor) {
    unread_.note(sensor, {"resolution", "calibration", "covariance", "bands", "data_type",
                          "black_level", "sensitivity", "vignetting", "meta", "pixel_width",
                          "pixel_height", "focal_length", "layer_index", "fixed"});
    unread_.note(calibration_of(sensor),
                 {"resolution", "f", "cx", "cy", "b1", "b2", "k1", "k2", "k3", "k4", "p1", "p2",
                  "p3", "p4", "covariance", "date"});
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
  std::map<std::string, Similarity> world_from_component_;  ///< not empty, by id
  std::map<std::string, std::size_t> camera_of_sensor_;
  Orientation orientation_;
  LeftOut left_out_;
  UnreadElements unread_;
};

}  // namespace

Orientation read_metashape(const std::string& path, const OrientationOptions& options) {
  return ChunkReader(path, options).read();
}

}  // namespace ridgeline::io
