// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"

#include <string>

/// One function per file. Each returns the text for an orientation that write_orientation() has
/// checked.
namespace ridgeline::simulate {

std::string opk_table_text(const io::Orientation& orientation);
std::string opensfm_text(const io::Orientation& orientation);
std::string pix4d_text(const io::Orientation& orientation);
std::string pix4d_offset_text(const io::Orientation& orientation);
std::string inpho_text(const io::Orientation& orientation);
std::string pat_b_text(const io::Orientation& orientation);
std::string blocks_exchange_text(const io::Orientation& orientation);
std::string metashape_text(const io::Orientation& orientation);
std::string colmap_cameras_text(const io::Orientation& orientation);
std::string colmap_images_text(const io::Orientation& orientation);
std::string colmap_points_text(const io::Orientation& orientation);

/// A camera file for read_cameras().
std::string camera_file_text(const io::Orientation& orientation);

/// The system as WKT1; empty if it is unknown.
std::string wkt_text(const io::Orientation& orientation);

// Helpers shared by the formats.

/// The name of an image's camera.
const std::string& camera_name(const io::Orientation& orientation, const io::OrientedImage& image);

/// The principal point relative to the middle of the image, pixels to the right and down.
Eigen::Vector2d principal_offset_px(const InteriorOrientation& interior);

/// The principal point in pixels counted from the corner of the image.
Eigen::Vector2d principal_point_from_corner_px(const InteriorOrientation& interior);

/// The rotation from the world to camera axes x right, y down, z forwards.
Eigen::Matrix3d cam_from_world(const ExteriorOrientation& exterior);

/// The elements row by row, separated by blanks.
std::string row_by_row(const Eigen::Matrix3d& matrix);

}  // namespace ridgeline::simulate
