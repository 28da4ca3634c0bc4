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

/// Standard deviation, across the line, of the endpoints from another detector if neither its file
/// nor the patch states it: the value for OpenCV's LSD, measured against the true edges of the
/// sample patches.
constexpr double kDefaultSegmentSigma_px = 0.3;

/// One oriented image of a patch.
struct PatchImage {
  std::string id;
  std::string path;  ///< path of the image file; not checked to exist
  ProjectionMatrix image_from_world =
      ProjectionMatrix::Zero();  ///< world -> ideal (undistorted) pixel of the part of the file
                                 ///< that is read
  Eigen::Vector2d window_px = Eigen::Vector2d::Zero();  ///< its top-left pixel in the full frame
  std::optional<Window> window{};     ///< the part of the file that is read; unset: all of it
  ImageTurn turn = ImageTurn::kNone;  ///< applied to the file's pixels
  /// For each band, the values that are mapped to 0 and 1; empty: derived from the whole file.
  std::vector<std::array<double, 2>> radiometry{};
  std::optional<ImageFacts> facts{};      ///< facts of the file, if its header has been read
  std::optional<std::string> segments{};  ///< file of another detector, see read_own_segments()
  double segment_sigma_px = kDefaultSegmentSigma_px;  ///< argument of read_own_segments()
  /// Interior orientation of the full frame; set only if the patch states it. undistorted_px()
  /// removes its distortion.
  std::optional<InteriorOrientation> interior;
  std::optional<ExteriorOrientation> exterior{};  ///< set only if the patch states it
};

/// The ideal position of a pixel of the file; the same position for an image without distortion.
/// std::nullopt outside the field for which the distortion was calibrated.
std::optional<Eigen::Vector2d> undistorted_px(const PatchImage& image, const Eigen::Vector2d& x_px);

/// Restricts reading to a window of the file, of which all was to be read before.
void read_window_only(PatchImage& image, const Window& window);

/// Columns and rows of an image file after turning.
Eigen::Vector2i turned_size_px(const PatchImage& image, const ImageFacts& facts);

/// Converts a segment from pixels of the file to pixels of the window that is read.
Segment2 in_window(const Segment2& in_file, const PatchImage& image);
/// Whether the midpoint of a segment lies in the part of the image that is read.
bool is_read(const Segment2& in_window, const PatchImage& image);

/// Maximum number of images of a patch that states an area but no `max_views`.
constexpr std::size_t kDefaultMaxViews = 5;

/// Images of one place and the associated data.
struct Project {
  std::string path;  ///< of the patch or block file
  std::string id;
  Crs crs;
  std::vector<PatchImage> images;  ///< in a patch, the first is the base image
  std::vector<std::string> lidar;  ///< files or glob patterns; may be empty
  std::optional<std::string> reference_lines;
  std::optional<std::string> surface_model;    ///< raster of heights
  std::optional<std::string> area_file;        ///< file of polygons that defines the area
  std::vector<std::string> orientation_files;  ///< files read for the key `orientation` or `colmap`
  std::vector<std::string> decisions;          ///< ambiguities and how they were resolved
  std::vector<std::string> warnings;
};

/// The content common to patch and block files. Decisions and warnings are those of the
/// orientation.
struct ProjectFile : Project {
  /// Lowest and highest object height in the CRS. If unset (`auto`), they are taken from the
  /// surface model if there is one, otherwise from the LIDAR.
  std::optional<std::array<double, 2>> height_range_m;
  /// Corners of the convex area to be reconstructed, counter-clockwise, metres in the CRS; empty if
  /// no area is given.
  std::vector<Eigen::Vector2d> area_m;
  /// If set, the images are candidates, of which at most this many are to be chosen.
  std::optional<std::size_t> max_views;
  std::vector<PatchImage>
      without_file;  ///< oriented images without a file in the given folder or pattern
};

/// The content of a patch file.
struct PatchFile : ProjectFile {
  std::optional<std::string> reference_matches;
  std::optional<std::string> reference_tracks;
};

/// The complete input of one reconstruction: a patch whose images, windows and heights have been
/// decided.
struct Patch : Project {
  std::array<double, 2> height_range_m{};  ///< lowest, highest object height in the CRS
  LocalFrame frame{};  ///< near the area shown by the base image; by default the world frame
  std::optional<std::string> reference_matches{};
  std::optional<std::string> reference_tracks{};
  bool images_are_chosen = false;  ///< from those of the file; tracks may also refer to the others
};

/// The range of heights in a local frame.
std::array<double, 2> heights_in_local_m(const Patch& patch, const LocalFrame& frame);

/// The files of Orientation::images, if known.
using ImageFiles = std::vector<std::optional<std::string>>;

/// Finds points visible in the images of an orientation, using these files; see FindObservations.
using FindPatchPoints =
    std::function<std::vector<PointObservation>(const Orientation&, const ImageFiles&)>;

/// Reads a patch file (YAML or JSON). Relative paths in it are resolved relative to the file. Keys:
///   id, height_range [lowest, highest] or auto, surface_model, crs, area [x_min, y_min, x_max,
///     y_max] or a file of polygons, max_views, lidar, segments {IMAGE: file, ...},
///     segment_sigma_px, reference_matches, reference_tracks, reference_lines;
///   images: list of {id, path, projection_matrix}, or instead of the matrix
///     interior {focal_length_mm, pixel_size_um, size_px, principal_point_mm, or focal_length_px
///     [x, y], size_px, principal_point_px, and k1, k2, k3, p1, p2}, exterior {position_m,
///     omega_phi_kappa_deg} and optionally window_px: [column, row] of the file's top-left pixel in
///     the frame, or [column, row, columns, rows] of the part to be read of a file that shows the
///     whole frame; and optionally radiometry, [low, high] for each band;
///   or, instead of matrix and interior, only an optional window_px and name, if the patch has the
///     key orientation (input of read_orientation()) and optionally cameras, angles, rotation,
///     matrix: ImageNames identifies the image;
///   or, with orientation, a folder or patterns of files that show images of the orientation;
///   or, instead of images: colmap (folder of a COLMAP model) and optionally colmap_images (folder
///     of its images, by default the patch file's own).
/// `find` may be empty; it is called only if an orientation is ambiguous. Heights, images of an
/// area and windows that the patch does not state are left undecided. Throws IoError with the line
/// for unknown or missing keys and for invalid values: non-finite numbers, an inverted height
/// range, a matrix of rank < 3, a duplicate id, two cameras in one place, fewer than two images, an
/// unreadable CRS, an image missing from the orientation, an orientation in another CRS. Errors in
/// the orientation itself name its file.
PatchFile read_patch(const std::string& path, const FindPatchPoints& find = {});

}  // namespace ridgeline::io
