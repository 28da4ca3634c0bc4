// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/read_orientation.h"

#include "io/crs/area_of_use.h"
#include "io/error.h"
#include "io/files/input_file.h"
#include "io/kinds/orientation_kind.h"
#include "io/kinds/recognise.h"
#include "io/orientation/geocentric_poses.h"
#include "io/orientation/readers.h"
#include "io/text/table_row.h"
#include "io/text/text.h"
#include "io/text/utf8.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace ridgeline::io {
namespace fs = std::filesystem;
namespace {

/// Whether the first row consists only of numbers and is long enough for a table whose image names
/// are numbers.
bool is_numbered_table(std::string_view start) {
  const std::vector<TextRow> rows = rows_of(start);
  if (rows.empty()) return false;
  const std::vector<std::string> fields = table_fields(rows[0].text, separator_of(rows[0].text));
  return fields.size() >= 7 && std::ranges::all_of(fields, [](const std::string& field) {
           return table_number(field).has_value();
         });
}

OrientationFormat format_of(const std::string& path) {
  require_regular_file(path);
  const std::string bytes = beginning_of(path);
  const std::string_view start = without_byte_order_mark(bytes);
  if (start.empty()) throw IoError(path, "is empty");
  if (const auto format = orientation_format(start)) return *format;
  if (is_numbered_table(start)) return OrientationFormat::kOpkTable;
  require_kind(path, start, FileGroup::kOrientation);
  throw IoError(path,
                "is not a supported orientation: a table of omega, phi and kappa, OpenSfM, Pix4D, "
                "Inpho, PAT-B, BlocksExchange, Metashape XML or a COLMAP folder");
}

Orientation read_by_format(const std::string& path, const OrientationOptions& options) {
  if (fs::is_directory(path)) return read_colmap_orientation(path, options);
  switch (format_of(path)) {
    case OrientationFormat::kOpensfm:
      return read_opensfm(path, options);
    case OrientationFormat::kPix4d:
      return read_pix4d(path, options);
    case OrientationFormat::kInpho:
      return read_inpho(path, options);
    case OrientationFormat::kPatB:
      return read_pat_b(path, options);
    case OrientationFormat::kBlocksExchange:
      return read_blocks_exchange(path, options);
    case OrientationFormat::kMetashape:
      return read_metashape(path, options);
    default:
      return read_opk_table(path, options);
  }
}

/// Deviation from a rotation matrix that rounding to five digits can cause.
constexpr double kRotationTolerance = 1e-4;

void check_pose(const std::string& path, const OrientedImage& image) {
  const Eigen::Matrix3d& R = image.exterior.world_from_camera_axes;
  const bool is_rotation = R.allFinite() &&
                           (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <
                               kRotationTolerance &&
                           R.determinant() > 0.0;
  if (!is_rotation) {
    throw IoError(path, fmt::format("the matrix of image {} is not a rotation", image.name));
  }
  constexpr double kMaxCoordinate_m = 1e8;
  if (!(image.exterior.position_m.cwiseAbs().maxCoeff() <= kMaxCoordinate_m)) {
    throw IoError(path, fmt::format("the position of image {} is not on Earth", image.name));
  }
}

/// Leaves out images without a name, which nothing can refer to.
void leave_out_unnamed(Orientation& orientation) {
  const auto n = std::erase_if(orientation.images,
                               [](const OrientedImage& image) { return image.name.empty(); });
  if (n > 0) orientation.warnings.push_back(fmt::format("images without a name, left out: {}", n));
}

void check_images(const std::string& path, const Orientation& orientation) {
  if (orientation.images.empty()) throw IoError(path, "has no oriented image");
  std::set<std::string> names;
  for (const OrientedImage& image : orientation.images) {
    if (!names.insert(image.name).second) {
      throw IoError(path, fmt::format("two images are named {}; rename one of the files, so that "
                                      "each name is unique, and export the orientation again",
                                      image.name));
    }
    check_pose(path, image);
  }
}

void check_cameras(const std::string& path, const Orientation& orientation) {
  for (const Camera& camera : orientation.cameras) {
    const InteriorOrientation& interior = camera.interior;
    const BrownDistortion& d = interior.distortion;
    const bool is_finite = interior.focal_length_px.allFinite() &&
                           interior.principal_point_px.allFinite() &&
                           std::isfinite(d.k1 + d.k2 + d.k3 + d.p1 + d.p2);
    if (is_finite && interior.focal_length_px.minCoeff() > 0.0) continue;
    throw IoError(
        path,
        fmt::format("camera {} must have finite numbers and a positive focal length", camera.name));
  }
}

/// Leaves out a stated system that PROJ cannot read.
void leave_out_unknown_crs(Orientation& orientation) {
  std::string& definition = orientation.crs.definition;
  const bool is_proj_string = definition.starts_with('+');
  if (is_proj_string && definition.find("+type=crs") == std::string::npos)
    definition += " +type=crs";
  try {
    if (orientation.crs.known()) describe(orientation.crs);
  } catch (const std::invalid_argument& error) {
    orientation.warnings.push_back(std::string("its reference system is ignored: ") + error.what());
    orientation.crs = {};
  }
}

/// Refuses heights above which no image is taken. Geocentric positions have such heights.
void require_heights_of_flights(const std::string& path, const Orientation& orientation) {
  constexpr double kMaxHeight_m = 50'000.0;
  for (const OrientedImage& image : orientation.images) {
    const double height_m = image.exterior.position_m.z();
    if (std::abs(height_m) <= kMaxHeight_m) continue;
    throw IoError(path, fmt::format("the height of image {} is {:.0f} m; positions must be on a "
                                    "map, or the file must state a geocentric reference system",
                                    image.name, height_m));
  }
}

/// Refuses positions far from where their system is used.
void compare_with_area_of_use(const std::string& path, Orientation& orientation) {
  try {
    const std::string warning = check_area_of_use(
        orientation.crs, transformed(orientation.images, [](const OrientedImage& image) {
          return image.exterior.position_m;
        }));
    if (!warning.empty()) orientation.warnings.push_back(warning);
  } catch (const std::invalid_argument& error) {
    throw IoError(path, error.what());
  }
}

/// Converts geocentric poses to a map, assigns the user's system to a file that states none, and
/// refuses coordinates in degrees.
void settle_crs(const std::string& path,
                const OrientationOptions& options,
                Orientation& orientation) {
  if (states_geocentric(orientation.crs)) {
    return convert_to_map(path, Eigen::Isometry3d::Identity(), options.crs, orientation);
  }
  require_heights_of_flights(path, orientation);
  leave_out_unknown_crs(orientation);
  if (!orientation.crs.known()) orientation.crs = options.crs;
  if (!orientation.crs.known()) return;
  const CrsFacts facts = describe(orientation.crs);
  if (facts.is_geographic) {
    throw IoError(
        path,
        fmt::format("has positions in degrees ({}); export it in a projected system", facts.name));
  }
  if (!same_unit(facts.horizontal_unit_m, 1.0) || !same_unit(facts.vertical_unit_m, 1.0)) {
    throw IoError(path,
                  fmt::format("has positions in {}; must be metres", facts.horizontal_unit_name));
  }
  compare_with_area_of_use(path, orientation);
}

}  // namespace

std::string file_name_of(const OrientedImage& image) {
  return image.name.substr(image.name.find_last_of("/\\") + 1);
}

Orientation read_orientation(const std::string& path, const OrientationOptions& options) {
  Orientation orientation = read_by_format(path, options);
  leave_out_unnamed(orientation);
  check_images(path, orientation);
  check_cameras(path, orientation);
  settle_crs(path, options, orientation);
  return orientation;
}

}  // namespace ridgeline::io
