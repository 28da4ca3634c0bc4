// SPDX-License-Identifier: BSD-3-Clause
// Formats that consist of rows of numbers: omega, phi and kappa; PAT-B; Pix4D; COLMAP.
#include "apps/simulate/orientation_writers.h"
#include "io/orientation/conventions.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace ridgeline::simulate {
namespace {

std::string x_y_z(const Eigen::Vector3d& x, const char* separator) {
  return fmt::format("{}{}{}{}{}", x.x(), separator, x.y(), separator, x.z());
}

/// An offset in whole metres near the images, which Pix4D subtracts from all coordinates.
Eigen::Vector3d offset_of_block_m(const io::Orientation& orientation) {
  return orientation.images.front().exterior.position_m.array().floor();
}

}  // namespace

std::string opk_table_text(const io::Orientation& orientation) {
  const std::string wkt = wkt_text(orientation);
  std::string text = wkt.empty() ? "" : "# CoordinateSystem: " + wkt + "\n";
  text += "name,x,y,z,omega_deg,phi_deg,kappa_deg,camera\n";
  for (const io::OrientedImage& image : orientation.images) {
    const io::Angles angles = io::angles_deg(image.exterior.world_from_camera_axes);
    text += fmt::format("{},{},{},{},{},{}\n", image.name, x_y_z(image.exterior.position_m, ","),
                        angles.omega, angles.phi, angles.kappa, camera_name(orientation, image));
  }
  return text;
}

std::string pat_b_text(const io::Orientation& orientation) {
  std::string text;
  for (const io::OrientedImage& image : orientation.images) {
    const Eigen::Vector3d& x = image.exterior.position_m;
    const Eigen::Matrix3d& m = image.exterior.world_from_camera_axes;
    // more digits than the columns of old programs have, so that no precision is lost
    text += fmt::format("{:>20}{:22.9f}{:22.9f}{:22.9f}\n", image.name, x.x(), x.y(), x.z());
    text += fmt::format("{:20.15f}{:20.15f}{:20.15f}{:20.15f}{:20.15f}\n", m(0, 0), m(0, 1),
                        m(0, 2), m(1, 0), m(1, 1));
    text +=
        fmt::format("{:20.15f}{:20.15f}{:20.15f}{:20.15f}\n", m(1, 2), m(2, 0), m(2, 1), m(2, 2));
  }
  return text;
}

std::string pix4d_text(const io::Orientation& orientation) {
  std::string text =
      "fileName imageWidth imageHeight \ncamera matrix K [3x3]\nradial distortion [3x1]\n"
      "tangential distortion [2x1]\ncamera position t [3x1]\ncamera rotation R [3x3]\n"
      "camera model m = K [R|-Rt] X\n\n";
  for (const io::OrientedImage& image : orientation.images) {
    const InteriorOrientation& interior = orientation.cameras[*image.camera].interior;
    const Eigen::Vector2d point_px = principal_point_from_corner_px(interior);
    const double focal_px = interior.focal_length_px.x();
    const Eigen::Matrix3d R = cam_from_world(image.exterior);
    text += fmt::format("{} {} {}\n{} 0 {}\n0 {} {}\n0 0 1\n0 0 0\n0 0\n", image.name,
                        interior.size_px->x(), interior.size_px->y(), focal_px, point_px.x(),
                        focal_px, point_px.y());
    text += x_y_z(image.exterior.position_m - offset_of_block_m(orientation), " ") + "\n";
    for (int row = 0; row < 3; ++row) text += x_y_z(R.row(row).transpose(), " ") + "\n";
  }
  return text;
}

std::string pix4d_offset_text(const io::Orientation& orientation) {
  return x_y_z(offset_of_block_m(orientation), " ") + "\n";
}

std::string colmap_cameras_text(const io::Orientation& orientation) {
  std::string text = "# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n";
  for (std::size_t i = 0; i < orientation.cameras.size(); ++i) {
    const InteriorOrientation& interior = orientation.cameras[i].interior;
    const Eigen::Vector2d point_px = principal_point_from_corner_px(interior);
    text += fmt::format("{} SIMPLE_PINHOLE {} {} {} {} {}\n", i + 1, interior.size_px->x(),
                        interior.size_px->y(), interior.focal_length_px.x(), point_px.x(),
                        point_px.y());
  }
  return text;
}

std::string colmap_images_text(const io::Orientation& orientation) {
  std::string text =
      "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n# POINTS2D[] as (X, Y, "
      "POINT3D_ID)\n";
  for (std::size_t i = 0; i < orientation.images.size(); ++i) {
    const io::OrientedImage& image = orientation.images[i];
    const Eigen::Quaterniond q(cam_from_world(image.exterior));
    // uses the rotation of the rounded quaternion, so that the centre is preserved
    const Eigen::Vector3d t = -(q.normalized().toRotationMatrix() * image.exterior.position_m);
    text += fmt::format("{} {} {} {} {} {}\n\n", i + 1, q.w(), x_y_z(q.vec(), " "), x_y_z(t, " "),
                        *image.camera + 1, image.name);
  }
  return text;
}

std::string colmap_points_text(const io::Orientation&) {
  return "# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n";
}

}  // namespace ridgeline::simulate
