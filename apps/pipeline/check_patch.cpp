// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/check_patch.h"

#include "io/cloud/read_cloud.h"
#include "io/crs/area_of_use.h"
#include "io/crs/grid_scale.h"
#include "io/error.h"
#include "io/images/image.h"
#include "io/project/segments_file.h"
#include "io/text/json_text.h"
#include "io/text/text.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Dense>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>

namespace ridgeline::apps {
namespace {

/// Columns and rows of the part of a file that is read.
Eigen::Vector2i size_of_image(const io::PatchImage& image, const io::ImageFacts& facts) {
  return image.window ? Eigen::Vector2i(image.window->width, image.window->height)
                      : turned_size_px(image, facts);
}

/// The file must be the whole frame, or lie within it if it is a crop.
void check_size(const io::PatchImage& image, const io::ImageFacts& facts) {
  if (!image.interior || !image.interior->size_px) return;
  const Eigen::Vector2i frame = *image.interior->size_px;
  const Eigen::Vector2i size = turned_size_px(image, facts);
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
  const Eigen::Vector2i size = turned_size_px(image, facts);
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
void check_segments(const io::PatchImage& image, const io::ImageFacts& facts) {
  if (!image.segments) return;
  (void)io::read_own_segments(*image.segments, image.segment_sigma_px,
                              turned_size_px(image, facts));
}

/// Both limits of height must lie in front of the camera, on the ray through the middle of the
/// image.
void check_heights(const io::Patch& patch,
                   const io::PatchImage& image,
                   const Eigen::Vector2i& size_px) {
  const Eigen::Matrix3d m = image.image_from_world.leftCols<3>();
  const Eigen::Vector3d centre = projection_centre(image.image_from_world).hnormalized();
  const Eigen::Vector2d middle = 0.5 * (size_px.cast<double>().array() - 1.0);
  const double side = m.determinant() > 0.0 ? 1.0 : -1.0;  // the matrix may have either sign
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

/// Whether an id starts like the name of a results file: one of these names and a dot or
/// underscore. A patch with such an id could overwrite the file.
bool is_name_of_result(const std::string& id) {
  const std::array<std::string, 6> results{"table1", "table2",    "run",
                                           "report", "reference", "tolerances"};
  const std::string lower = io::lower_case(id);
  return std::ranges::any_of(results, [&](const std::string& result) {
    return lower.starts_with(result + ".") || lower.starts_with(result + "_");
  });
}

void check_id(const io::Patch& patch, const std::string& id) {
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

/// Rejects ids that differ only in case, because they are the same name on some file systems.
void check_image_ids(const io::Patch& patch) {
  std::set<std::string> seen;
  for (const io::PatchImage& image : patch.images) {
    check_id(patch, image.id);
    if (seen.insert(io::lower_case(image.id)).second) continue;
    throw io::IoError(
        patch.path,
        fmt::format("image id '{}' appears twice (ignoring case); ids must be unique", image.id));
  }
}

/// The files of a project, `references` last.
std::vector<results::InputFile> files_of(const io::Project& project,
                                         std::span<const std::optional<std::string>> references) {
  std::vector<results::InputFile> files{{"patch", project.path}};
  if (project.area_file) files.push_back({"area", *project.area_file});
  if (project.surface_model) files.push_back({"surface_model", *project.surface_model});
  for (const std::string& file : project.orientation_files) files.push_back({"orientation", file});
  for (const io::PatchImage& image : project.images) files.push_back({"image", image.path});
  for (const io::PatchImage& image : project.images) {
    if (image.segments) files.push_back({"segments", *image.segments});
  }
  for (const std::string& file : io::expand_patterns(project.lidar))
    files.push_back({"cloud", file});
  for (const std::optional<std::string>& file : references) {
    if (file) files.push_back({"reference", *file});
  }
  return files;
}

}  // namespace

std::vector<results::InputFile> input_files(const io::Patch& patch) {
  return files_of(
      patch, std::array{patch.reference_matches, patch.reference_tracks, patch.reference_lines});
}

std::vector<results::InputFile> input_files(const io::BlockFile& block) {
  return files_of(block, {&block.reference_lines, 1});
}

void check_positions(io::Project& project) {
  try {
    const std::string text = io::check_area_of_use(
        project.crs,
        transformed(project.images, [](const io::PatchImage& image) -> Eigen::Vector3d {
          return projection_centre(image.image_from_world).hnormalized();
        }));
    if (text.empty()) return;
    // that of the orientation is the same if the patch uses all of its images
    const bool is_known = std::ranges::any_of(
        project.warnings, [&](const std::string& warning) { return warning.ends_with(text); });
    if (!is_known) project.warnings.push_back(project.path + ": " + text);
  } catch (const std::invalid_argument& error) {
    throw io::IoError(project.path, error.what());
  }
}

void check_scale(const io::Patch& patch, const io::Crs& crs) {
  if (!crs.known()) return;
  const Eigen::Vector3d centre =
      projection_centre(patch.images.front().image_from_world).hnormalized();
  const double unit_m = io::describe(crs).horizontal_unit_m;
  (void)io::require_true_scale(patch.path, crs, centre.head<2>() / unit_m, "");
}

void check_patch(const io::Patch& patch, double max_image_mpx) {
  check_id(patch, patch.id);
  check_scale(patch, patch.crs);
  check_image_ids(patch);
  std::optional<int> n_bands;
  for (const io::PatchImage& image : patch.images) {
    const io::ImageFacts facts = image.facts ? *image.facts : io::image_facts(image.path);
    io::check_image_size(image.path, facts, max_image_mpx, image.window);
    check_size(image, facts);
    check_window(image, facts);
    check_radiometry(image, facts);
    check_segments(image, facts);
    check_heights(patch, image, size_of_image(image, facts));
    if (facts.n_bands != n_bands.value_or(facts.n_bands)) {
      throw io::IoError(
          image.path,
          fmt::format(
              "{} bands, but {} has {}; all images of a patch must have the same number of bands",
              facts.n_bands, patch.images[0].path, *n_bands));
    }
    n_bands = facts.n_bands;
  }
}

}  // namespace ridgeline::apps
