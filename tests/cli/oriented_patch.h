// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/images/image.h"
#include "io/project/patch.h"
#include "tests/cli/cli_fixture.h"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace ridgeline::cli {

/// Camera and pose of a projection matrix without skew.
struct DecomposedCamera {
  Eigen::Vector3d position_m;
  Eigen::Vector3d omega_phi_kappa_deg;
  double focal_length_px = 0.0;
  Eigen::Vector2d principal_point_px;
};

inline DecomposedCamera decomposed(const ProjectionMatrix& image_from_world) {
  Eigen::Matrix3d m = image_from_world.leftCols<3>() / image_from_world.row(2).head<3>().norm();
  if (m.determinant() < 0.0) m = -m;
  DecomposedCamera camera;
  camera.position_m = projection_centre(image_from_world).hnormalized();
  camera.principal_point_px = m.topRows<2>() * m.row(2).transpose();
  Eigen::Matrix3d axes_from_world;  // of the camera: x right, y down, z forwards
  axes_from_world << m.topRows<2>() - camera.principal_point_px * m.row(2), m.row(2);
  camera.focal_length_px = axes_from_world.row(0).norm();
  axes_from_world.topRows<2>() /= camera.focal_length_px;
  const Eigen::Matrix3d R =
      axes_from_world.transpose() * Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  camera.omega_phi_kappa_deg = Eigen::Vector3d(std::atan2(-R(1, 2), R(2, 2)), std::asin(R(0, 2)),
                                               std::atan2(-R(0, 1), R(0, 0))) *
                               (180.0 / std::numbers::pi);
  return camera;
}

inline std::string camera_entry(const std::string& name,
                                const DecomposedCamera& camera,
                                const io::ImageFacts& image) {
  const Eigen::Vector2d middle(0.5 * (image.width_px - 1), 0.5 * (image.height_px - 1));
  const Eigen::Vector2d offset = camera.principal_point_px - middle;
  return fmt::format(
      "{}: {{focal_length_mm: {}, pixel_size_um: 1000, size_px: [{}, {}], "
      "principal_point_mm: [{}, {}]}}\n",
      name, camera.focal_length_px, image.width_px, image.height_px, offset.x(), -offset.y());
}

/// The small patch and, beside it, oriented.yaml: the same with a table of orientations and a file
/// of cameras.
class OrientedPatch : public SmallPatch {
 protected:
  OrientedPatch() { write_orientation("omega_deg,phi_deg,kappa_deg", 0.0); }

  void write_orientation(const std::string& angles, double raised_m) const {
    const io::PatchFile patch = io::read_patch(path("patch/patch.yaml").string());
    std::string table = "name,x,y,z," + angles + ",camera\n";
    std::string cameras;
    std::string images;
    for (const io::PatchImage& image : patch.images) {
      const DecomposedCamera camera = decomposed(image.image_from_world);
      const Eigen::Vector3d& x = camera.position_m;
      const Eigen::Vector3d& a = camera.omega_phi_kappa_deg;
      table += fmt::format("{},{},{},{},{},{},{},of_{}\n", image.id, x.x(), x.y(), x.z() + raised_m,
                           a.x(), a.y(), a.z(), image.id);
      cameras += camera_entry("of_" + image.id, camera, io::image_facts(image.path));
      images +=
          fmt::format("  - path: {}\n", std::filesystem::path(image.path).filename().string());
    }
    write(path("patch/opk.csv"), table);
    write(path("patch/cameras.yaml"), cameras);
    write(path("patch/oriented.yaml"),
          fmt::format("id: '1'\ncrs: '{}'\nheight_range: [{}, {}]\nlidar: lidar.las\n"
                      "orientation: opk.csv\ncameras: cameras.yaml\nimages:\n{}",
                      patch.crs.definition, patch.height_range_m->at(0),
                      patch.height_range_m->at(1), images));
  }

  [[nodiscard]] ProgramResult run_oriented(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run",    "patch/oriented.yaml", "--out", "out", "--methods",
                                   "direct", "--no-report"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  /// How many inputs of a run's record have this role.
  [[nodiscard]] long n_inputs(const std::string& folder, const std::string& role) const {
    const nlohmann::json inputs = read_json(path(folder + "/run.json"))["inputs"];
    return std::count_if(inputs.begin(), inputs.end(),
                         [&](const auto& input) { return input["role"] == role; });
  }
};

}  // namespace ridgeline::cli
