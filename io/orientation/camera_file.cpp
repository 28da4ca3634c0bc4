// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/camera_file.h"

#include "io/files/yaml_check.h"
#include "io/orientation/orientation_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::io {
namespace {

BrownDistortion distortion_of(const YamlMap& map) {
  const auto value = [&](const char* key) { return map.has(key) ? map.number(key) : 0.0; };
  return {value("k1"), value("k2"), value("k3"), value("p1"), value("p2")};
}

Eigen::Vector2i size_of(const YamlMap& map, const char* key) {
  const std::vector<double> size = map.numbers(key, 2);
  constexpr double kMaxSide_px = 1e6;
  for (const double side : size) {
    if (side >= 1.0 && side <= kMaxSide_px && side == std::floor(side)) continue;
    map.fail(key,
             fmt::format("{} = [{}, {}]; must be whole numbers of pixels", key, size[0], size[1]));
  }
  return {static_cast<int>(size[0]), static_cast<int>(size[1])};
}

/// One number for both axes, or two.
Eigen::Vector2d pair_of(const YamlMap& map, const char* key) {
  if (!map.node(key).IsSequence()) return Eigen::Vector2d::Constant(map.number(key));
  const std::vector<double> both = map.numbers(key, 2);
  return {both[0], both[1]};
}

/// A camera with the keys of a patch file.
InteriorOrientation metric_camera(const std::string& path, const YAML::Node& node) {
  const YamlMap map(path, node,
                    {"focal_length_mm", "pixel_size_um", "size_px", "principal_point_mm", "k1",
                     "k2", "k3", "p1", "p2"});
  const std::vector<double> point =
      map.has("principal_point_mm") ? map.numbers("principal_point_mm", 2) : std::vector{0.0, 0.0};
  try {
    InteriorOrientation interior =
        interior_orientation(map.number("focal_length_mm"), map.number("pixel_size_um"),
                             size_of(map, "size_px"), {point[0], point[1]});
    interior.distortion = distortion_of(map);
    return interior;
  } catch (const std::invalid_argument& error) {
    fail_yaml(path, node, error.what());
  }
}

/// Focal length and sensor size have the same unit; without a sensor size, the focal length is in
/// units of the longer side.
Eigen::Vector2d focal_length_px(const YamlMap& map, const Eigen::Vector2d& size_px) {
  const Eigen::Vector2d focal = pair_of(map, "focal_len");
  if (!map.has("sensor_size")) return focal * size_px.maxCoeff();
  return focal.cwiseProduct(size_px).cwiseQuotient(pair_of(map, "sensor_size"));
}

InteriorOrientation scaled_camera(const std::string& path, const YAML::Node& node) {
  const YamlMap map(
      path, node,
      {"type", "im_size", "focal_len", "sensor_size", "cx", "cy", "k1", "k2", "k3", "p1", "p2"});
  const std::string type = map.text("type");
  if (type != "pinhole" && type != "brown") {
    map.fail("type", fmt::format("camera type {}; supported are pinhole and brown", type));
  }
  InteriorOrientation interior;
  interior.size_px = size_of(map, "im_size");
  const Eigen::Vector2d size_px = interior.size_px->cast<double>();
  interior.focal_length_px = focal_length_px(map, size_px);
  if (!(interior.focal_length_px.minCoeff() > 0.0) || !interior.focal_length_px.allFinite()) {
    map.fail("focal_len", "focal_len and sensor_size must be positive");
  }
  const Eigen::Vector2d offset(map.has("cx") ? map.number("cx") : 0.0,
                               map.has("cy") ? map.number("cy") : 0.0);
  interior.principal_point_px =
      0.5 * (size_px - Eigen::Vector2d::Ones()) + size_px.maxCoeff() * offset;
  interior.distortion = distortion_of(map);
  return interior;
}

/// Whether a camera is of an unsupported type, which is refused before its keys are checked.
bool has_other_type(const YAML::Node& node) {
  return node.IsMap() && node["type"] && node["type"].IsScalar() &&
         node["type"].Scalar() != "pinhole" && node["type"].Scalar() != "brown";
}

}  // namespace

CameraFile read_cameras(const std::string& path, const std::vector<std::string>& names) {
  const YAML::Node root = parse_yaml(read_orientation_text(path), path);
  if (!root.IsMap() || root.size() == 0) {
    throw IoError(path,
                  "is not a camera file; a mapping from camera names to their keys is expected");
  }
  CameraFile file{.cameras = {}, .is_only_one = root.size() == 1};
  for (const auto& entry : root) {
    const YAML::Node& node = entry.second;
    const bool is_in_use = file.is_only_one || names.empty() ||
                           std::ranges::find(names, entry.first.Scalar()) != names.end();
    if (!is_in_use) continue;
    if (has_other_type(node)) {
      fail_yaml(path, node,
                "camera type " + node["type"].Scalar() + "; supported are pinhole and brown");
    }
    const bool is_metric = node.IsMap() && node["focal_length_mm"];
    file.cameras.push_back(
        {entry.first.Scalar(), is_metric ? metric_camera(path, node) : scaled_camera(path, node)});
  }
  return file;
}

double largest_radius(const InteriorOrientation& interior) {
  if (!interior.size_px) return 0.0;
  const Eigen::Vector2d size_px = interior.size_px->cast<double>();
  const Eigen::Vector2d farthest_px = interior.principal_point_px.cwiseAbs().cwiseMax(
      (size_px - interior.principal_point_px).cwiseAbs());
  return farthest_px.cwiseQuotient(interior.focal_length_px).norm();
}

void require_negligible(const std::string& path, const std::string& name, double effect_px) {
  if (std::abs(effect_px) <= kLeftOut_px) return;
  throw IoError(path,
                fmt::format("{} moves pixels by {:.3g} px, but only k1, k2, k3, p1 and p2 are "
                            "supported; undistort the images or adjust the block without {}",
                            name, std::abs(effect_px), name));
}

}  // namespace ridgeline::io
