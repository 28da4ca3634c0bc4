// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "io/orientation/conventions.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/local_frame.h"
#include "reconstruct/geometry/orientation.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// One oriented image of a patch.
struct PatchImage {
  std::string id;
  std::string path;                   ///< path of the image file; not checked to exist
  ProjectionMatrix image_from_world;  ///< world -> ideal (undistorted) pixel of this file
  Eigen::Vector2d window_px = Eigen::Vector2d::Zero();  ///< top-left pixel in the full frame
  /// Interior orientation of the full frame; set only if the patch gives it. undistorted_px() removes its distortion.
  std::optional<InteriorOrientation> interior;
};

/// The ideal pixel of a pixel of the file; the pixel itself for an image without distortion.
/// Nothing outside of the field that the distortion was calibrated for.
std::optional<Eigen::Vector2d> undistorted_px(const PatchImage& image, const Eigen::Vector2d& x_px);

/// What belongs together in one reconstruction: images, heights to search in, LIDAR.
struct PatchFile {
  std::string path;
  std::string id;
  Crs crs;
  std::array<double, 2> height_range_m{};  ///< lowest, highest object height in the CRS
  std::vector<PatchImage> images;          ///< the first is the base image
  std::vector<std::string> lidar;          ///< files or glob patterns; may be empty
  std::optional<std::string> reference_matches;
  std::optional<std::string> reference_tracks;
  std::optional<std::string> reference_lines;
  std::vector<std::string> orientation_files;  ///< what the key `orientation` made the reader read
  std::vector<std::string> decisions;  ///< what the orientation leaves open and how it was decided
  std::vector<std::string> warnings;   ///< of the orientation
  double max_image_mpx = 0.0;          ///< argument of read_image(); the user says it, not the file
};

/// Cameras of the pair, the first two images, and the range of heights in the local frame.
std::array<ProjectionMatrix, 2> cameras_in_local(const PatchFile& patch, const LocalFrame& frame);
std::array<double, 2> heights_in_local_m(const PatchFile& patch, const LocalFrame& frame);

/// The files of Orientation::images, where they are known.
using ImageFiles = std::vector<std::optional<std::string>>;

/// Finds points that images of an orientation show, in these files; see FindObservations.
using FindPatchPoints =
    std::function<std::vector<PointObservation>(const Orientation&, const ImageFiles&)>;

/// Reads a patch file (YAML or JSON). Relative paths in it are relative to the file and come out
/// resolved. Keys:
///   id, height_range [lowest, highest], crs, lidar, reference_matches, reference_tracks,
///   reference_lines;
///   images: list of {id, path, projection_matrix}, or in place of the matrix
///     interior {focal_length_mm, pixel_size_um, size_px, principal_point_mm, k1, k2, k3, p1, p2},
///     exterior {position_m, omega_phi_kappa_deg} and optionally window_px;
///   or in place of matrix and interior nothing but perhaps window_px and name, with, beside images, orientation (what
///     read_orientation() reads) and optionally cameras, angles, rotation, matrix: the camera is that of image_of_name();
///   or in place of images: colmap (folder of a COLMAP model) and optionally colmap_images (folder
///     of its images, else the patch file's own).
/// `find` may be empty; it is asked only where an orientation leaves something open.
/// Throws IoError with the line for unknown or missing keys and for values that cannot be: numbers
/// that are not finite, an inverted height range, a matrix of rank < 3, an id twice, two cameras in
/// one place, fewer than two images, an unreadable CRS, an image that the orientation does not have, an orientation in
/// another CRS. Faults of the orientation itself name its file.
PatchFile read_patch(const std::string& path, const FindPatchPoints& find = {});

}  // namespace ridgeline::io
