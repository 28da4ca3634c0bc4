// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/check_patch.h"

#include "io/cloud/read_cloud.h"
#include "io/crs/grid_scale.h"
#include "io/error.h"
#include "io/images/image.h"
#include "io/project/segments_file.h"
#include "io/text/json_text.h"
#include "io/text/text.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/scene/scene.h"

#include <Eigen/Dense>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace ridgeline::apps {
namespace {

/// Columns and rows of a file as it is read, turned or not.
Eigen::Vector2i size_of_file(const io::PatchImage& image, const io::ImageFacts& facts) {
  return swaps_axes(image.turn) ? Eigen::Vector2i(facts.height_px, facts.width_px)
                                : Eigen::Vector2i(facts.width_px, facts.height_px);
}

/// Columns and rows of what is read of a file.
Eigen::Vector2i size_of_image(const io::PatchImage& image, const io::ImageFacts& facts) {
  return image.window ? Eigen::Vector2i(image.window->width, image.window->height)
                      : size_of_file(image, facts);
}

/// The file must be the frame, or lie within it where it is cut out of it.
void check_size(const io::PatchImage& image, const io::ImageFacts& facts) {
  if (!image.interior || !image.interior->size_px) return;
  const Eigen::Vector2i frame = *image.interior->size_px;
  const Eigen::Vector2i size = size_of_file(image, facts);
  const Eigen::Vector2d in_file(image.window ? image.window->column : 0,
                                image.window ? image.window->row : 0);
  const Eigen::Vector2d corner = image.window_px - in_file;
  const Eigen::Vector2d end = corner + size.cast<double>();
  const bool whole = corner.isZero();
  const bool fits =
      whole ? size == frame
            : (corner.array() >= 0.0).all() && (end.array() <= frame.cast<double>().array()).all();
  if (fits) return;
  throw io::IoError(image.path,
                    fmt::format("{} x {} pixels; its camera has {} x {}{}", size.x(), size.y(),
                                frame.x(), frame.y(),
                                whole ? "; an image cut out of the frame needs window_px"
                                      : fmt::format(", which does not contain the window at {}, {}",
                                                    corner.x(), corner.y())));
}

void check_window(const io::PatchImage& image, const io::ImageFacts& facts) {
  if (!image.window) return;
  const Eigen::Vector2i size = size_of_file(image, facts);
  const io::Window& window = *image.window;
  if (window.column + window.width <= size.x() && window.row + window.height <= size.y()) return;
  throw io::IoError(
      image.path,
      fmt::format("{} x {} pixels do not contain the window of {} x {} at {}, {}", size.x(),
                  size.y(), window.width, window.height, window.column, window.row));
}

void check_radiometry(const io::PatchImage& image, const io::ImageFacts& facts) {
  const std::size_t n = image.radiometry.size();
  if (n == 0 || n == static_cast<std::size_t>(facts.n_bands)) return;
  throw io::IoError(image.path,
                    fmt::format("has {} bands, but radiometry has {}", facts.n_bands, n));
}

/// The segments that another detector found, if there are any, must lie in the image.
void check_segments(const io::PatchFile& patch,
                    const io::PatchImage& image,
                    const io::ImageFacts& facts) {
  if (!image.segments) return;
  (void)io::read_own_segments(*image.segments, patch.segment_sigma_px, size_of_file(image, facts));
}

/// Both limits of height must lie in front of the camera, on the ray through the middle of the
/// image.
void check_heights(const io::PatchFile& patch,
                   const io::PatchImage& image,
                   const Eigen::Vector2i& size_px) {
  const Eigen::Matrix3d m = image.image_from_world.leftCols<3>();
  const Eigen::Vector3d centre = projection_centre(image.image_from_world).hnormalized();
  const Eigen::Vector2d middle = 0.5 * (size_px.cast<double>().array() - 1.0);
  const double side = m.determinant() > 0.0 ? 1.0 : -1.0;  // a matrix may have either sign
  const Eigen::Vector3d ray = side * m.inverse() * middle.homogeneous();
  for (const double z : patch.height_range_m) {
    if ((z - centre.z()) / ray.z() > 0.0) continue;
    throw io::IoError(
        patch.path,
        fmt::format("height_range [{}, {}]: the height {} m lies behind the camera of image {}, "
                    "which is at {:.1f} m and looks {}; heights must be in front of it",
                    patch.height_range_m[0], patch.height_range_m[1], z, image.id, centre.z(),
                    ray.z() < 0.0 ? "down" : "up"));
  }
}

bool is_utf8(const std::string& text) {
  try {
    (void)nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

bool is_file_name(const std::string& id) {
  constexpr std::size_t kMaxLength = 100;
  if (id.empty() || id.size() > kMaxLength || id.front() == '.') return false;
  if (id.front() == ' ' || id.back() == ' ') return false;
  return std::ranges::none_of(id, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f || c == '/' || c == '\\';
  });
}

/// Whether an id begins like a file of the results, with one of these names and a dot or an
/// underscore. A patch of that id could write over the file.
bool is_name_of_result(const std::string& id) {
  const std::array<std::string, 6> results{"table1", "table2",    "run",
                                           "report", "reference", "tolerances"};
  const std::string lower = io::lower_case(id);
  return std::ranges::any_of(results, [&](const std::string& result) {
    return lower.starts_with(result + ".") || lower.starts_with(result + "_");
  });
}

void check_id(const io::PatchFile& patch, const std::string& id) {
  if (!is_file_name(id) || !is_utf8(id)) {
    throw io::IoError(patch.path,
                      fmt::format("id {} is used as a file name in the results; it must be 1 to "
                                  "100 bytes of UTF-8 without slashes and control characters, not "
                                  "start with a dot, and not start or end with a blank",
                                  io::excerpt(id)));
  }
  if (!is_name_of_result(id)) return;
  throw io::IoError(patch.path,
                    fmt::format("id '{}' is the name of a results file; choose another", id));
}

/// Ids that differ only in case are refused: some file systems take them for one name.
void check_image_ids(const io::PatchFile& patch) {
  std::set<std::string> seen;
  for (const io::PatchImage& image : patch.images) {
    check_id(patch, image.id);
    if (seen.insert(io::lower_case(image.id)).second) continue;
    throw io::IoError(
        patch.path,
        fmt::format("image id '{}' appears twice (ignoring case); ids must be unique", image.id));
  }
}

}  // namespace

std::vector<results::InputFile> input_files(const io::PatchFile& patch) {
  std::vector<results::InputFile> files{{"patch", patch.path}};
  if (patch.area_file) files.push_back({"area", *patch.area_file});
  if (patch.surface_model) files.push_back({"surface_model", *patch.surface_model});
  for (const std::string& file : patch.orientation_files) files.push_back({"orientation", file});
  for (const io::PatchImage& image : patch.images) files.push_back({"image", image.path});
  for (const io::PatchImage& image : patch.images) {
    if (image.segments) files.push_back({"segments", *image.segments});
  }
  for (const std::string& file : io::expand_patterns(patch.lidar)) files.push_back({"cloud", file});
  if (patch.reference_matches) files.push_back({"reference", *patch.reference_matches});
  if (patch.reference_tracks) files.push_back({"reference", *patch.reference_tracks});
  if (patch.reference_lines) files.push_back({"reference", *patch.reference_lines});
  return files;
}

void check_scale(const io::PatchFile& patch, const io::Crs& crs) {
  if (!crs.known()) return;
  const Eigen::Vector3d centre =
      projection_centre(patch.images.front().image_from_world).hnormalized();
  const double unit_m = io::describe(crs).horizontal_unit_m;
  (void)io::require_true_scale(patch.path, crs, centre.head<2>() / unit_m, "");
}

LocalFrame check_patch(const io::PatchFile& patch) {
  check_id(patch, patch.id);
  check_scale(patch, patch.crs);
  check_image_ids(patch);
  LocalFrame frame;
  int n_bands = 0;
  for (std::size_t i = 0; i < patch.images.size(); ++i) {
    const io::PatchImage& image = patch.images[i];
    const io::ImageFacts facts = image.facts ? *image.facts : io::image_facts(image.path);
    io::check_image_size(image.path, facts, patch.max_image_mpx, image.window);
    check_size(image, facts);
    check_window(image, facts);
    check_radiometry(image, facts);
    check_segments(patch, image, facts);
    const Eigen::Vector2i size_px = size_of_image(image, facts);
    check_heights(patch, image, size_px);
    if (i == 0) {
      frame = reconstruct::local_frame(image.image_from_world, size_px.cast<double>(),
                                       patch.height_range_m);
    } else if (facts.n_bands != n_bands) {
      throw io::IoError(
          image.path,
          fmt::format(
              "{} bands, but {} has {}; all images of a patch must have the same number of bands",
              facts.n_bands, patch.images[0].path, n_bands));
    }
    n_bands = facts.n_bands;
  }
  return frame;
}

}  // namespace ridgeline::apps
