// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "io/images/image.h"
#include "io/orientation/conventions.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/local_frame.h"
#include "reconstruct/geometry/orientation.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Standard deviation across the line of the ends that another detector gives, if neither its file
/// nor the patch states it: that of OpenCV's LSD against the true edges of the sample patches.
constexpr double kDefaultSegmentSigma_px = 0.3;

/// One oriented image of a patch.
struct PatchImage {
  std::string id;
  std::string path;  ///< path of the image file; not checked to exist
  ProjectionMatrix image_from_world =
      ProjectionMatrix::Zero();  ///< world -> ideal (undistorted) pixel of what is read of the file
  Eigen::Vector2d window_px = Eigen::Vector2d::Zero();  ///< its top-left pixel in the full frame
  std::optional<Window> window{};     ///< what is read of the file; unset: all of it
  ImageTurn turn = ImageTurn::kNone;  ///< of the file's pixels
  /// Per band the values that become 0 and 1; empty: those of the whole file.
  std::vector<std::array<double, 2>> radiometry{};
  std::optional<ImageFacts> facts{};      ///< of the file, if its header has been read
  std::optional<std::string> segments{};  ///< file of another detector, see read_own_segments()
  double segment_sigma_px = kDefaultSegmentSigma_px;  ///< argument of read_own_segments()
  /// Interior orientation of the full frame; set only if the patch gives it. undistorted_px()
  /// removes its distortion.
  std::optional<InteriorOrientation> interior;
  std::optional<ExteriorOrientation> exterior{};  ///< set only if the patch gives it
};

/// The ideal pixel of a pixel of the file; the pixel itself for an image without distortion.
/// Nothing outside of the field that the distortion was calibrated for.
std::optional<Eigen::Vector2d> undistorted_px(const PatchImage& image, const Eigen::Vector2d& x_px);

/// Lets nothing but a window of the file, which has been read whole so far, be read.
void read_window_only(PatchImage& image, const Window& window);

/// Columns and rows of the file of an image when it has been turned.
Eigen::Vector2i turned_size_px(const PatchImage& image, const ImageFacts& facts);

/// A segment in pixels of the file in those of the window that is read of it.
Segment2 in_window(const Segment2& in_file, const PatchImage& image);
/// Whether the middle of a segment lies in what is read of the image.
bool is_read(const Segment2& in_window, const PatchImage& image);

/// The images of a patch are at most so many if the patch states an area and no number.
constexpr std::size_t kDefaultMaxViews = 5;

/// Images of one place, and what belongs to them.
struct Project {
  std::string path;  ///< of the patch or block file
  std::string id;
  Crs crs;
  std::vector<PatchImage> images;  ///< of a patch, the first is the base image
  std::vector<std::string> lidar;  ///< files or glob patterns; may be empty
  std::optional<std::string> reference_lines;
  std::optional<std::string> surface_model;    ///< raster of heights
  std::optional<std::string> area_file;        ///< polygons that the area is of
  std::vector<std::string> orientation_files;  ///< what the key `orientation` made the reader read
  std::vector<std::string> decisions;          ///< what is left open and how it was decided
  std::vector<std::string> warnings;
};

/// What patch and block files state. Decisions and warnings are those of the orientation.
struct ProjectFile : Project {
  /// Lowest, highest object height in the CRS. Unset (`auto`), they are those of the surface model
  /// if there is one, else of the LIDAR.
  std::optional<std::array<double, 2>> height_range_m;
  /// Corners of the convex area to be reconstructed, counter-clockwise, metres in the CRS; empty if
  /// the file states none.
  std::vector<Eigen::Vector2d> area_m;
  /// If set, the images are candidates, of which at most so many are to be chosen.
  std::optional<std::size_t> max_views;
  std::vector<PatchImage>
      without_file;  ///< oriented images that no file of a folder or pattern shows
};

/// What a patch file states.
struct PatchFile : ProjectFile {
  std::optional<std::string> reference_matches;
  std::optional<std::string> reference_tracks;
};

/// What belongs together in one reconstruction: a patch whose images, windows and heights have been
/// decided.
struct Patch : Project {
  std::array<double, 2> height_range_m{};  ///< lowest, highest object height in the CRS
  LocalFrame frame{};  ///< near what the base image shows; by default that of the world
  std::optional<std::string> reference_matches{};
  std::optional<std::string> reference_tracks{};
  bool images_are_chosen = false;  ///< from those of the file, which tracks may name, too
};

/// The range of heights in a local frame.
std::array<double, 2> heights_in_local_m(const Patch& patch, const LocalFrame& frame);

/// The files of Orientation::images, where they are known.
using ImageFiles = std::vector<std::optional<std::string>>;

/// Finds points that images of an orientation show, in these files; see FindObservations.
using FindPatchPoints =
    std::function<std::vector<PointObservation>(const Orientation&, const ImageFiles&)>;

/// Reads a patch file (YAML or JSON). Relative paths in it are relative to the file and come out
/// resolved. Keys:
///   id, height_range [lowest, highest] or auto, surface_model, crs, area [x_min, y_min, x_max,
///     y_max] or a file of polygons, max_views, lidar, segments {IMAGE: file, ...},
///     segment_sigma_px, reference_matches, reference_tracks, reference_lines;
///   images: list of {id, path, projection_matrix}, or in place of the matrix
///     interior {focal_length_mm, pixel_size_um, size_px, principal_point_mm, or focal_length_px
///     [x, y], size_px, principal_point_px, and k1, k2, k3, p1, p2}, exterior {position_m,
///     omega_phi_kappa_deg} and optionally window_px [column, row], where the file is cut out of
///     the frame, or [column, row, columns, rows], what is to be read of a file that is the frame;
///     and optionally radiometry, [low, high] for each band;
///   or in place of matrix and interior nothing but perhaps window_px and name, with, beside
///     images, orientation (what read_orientation() reads) and optionally cameras, angles,
///     rotation, matrix: ImageNames tells which image that is;
///   or with orientation a folder or patterns of files, whose images the orientation knows;
///   or in place of images: colmap (folder of a COLMAP model) and optionally colmap_images (folder
///     of its images, else the patch file's own).
/// `find` may be empty; it is asked only where an orientation leaves something open. Heights,
/// images of an area and windows that the patch does not state itself stay open. Throws IoError
/// with the line for unknown or missing keys and for values that cannot be: numbers that are not
/// finite, an inverted height range, a matrix of rank < 3, an id twice, two cameras in one place,
/// fewer than two images, an unreadable CRS, an image that the orientation does not have, an
/// orientation in another CRS. Faults of the orientation itself name its file.
PatchFile read_patch(const std::string& path, const FindPatchPoints& find = {});

}  // namespace ridgeline::io
