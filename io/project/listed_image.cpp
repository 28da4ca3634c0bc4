// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/listed_image.h"

#include "reconstruct/geometry/degrees.h"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ridgeline::io {
namespace {

Eigen::Vector2i size_px_of(const YamlMap& interior) {
  const std::vector<double> size = interior.numbers("size_px", 2);
  return {std::lround(size[0]), std::lround(size[1])};
}

InteriorOrientation interior_in_mm(const YamlMap& map) {
  if (map.has("principal_point_px")) {
    map.fail("principal_point_px", "principal_point_px requires focal_length_px");
  }
  const std::vector<double> point =
      map.has("principal_point_mm") ? map.numbers("principal_point_mm", 2) : std::vector{0., 0.};
  return interior_orientation(map.number("focal_length_mm"), map.number("pixel_size_um"),
                              size_px_of(map), {point[0], point[1]});
}

InteriorOrientation interior_in_pixels(const YamlMap& map) {
  for (const char* key : {"focal_length_mm", "pixel_size_um", "principal_point_mm"}) {
    if (map.has(key)) map.fail(key, fmt::format("{} cannot be combined with focal_length_px", key));
  }
  const std::vector<double> focal_length = map.numbers("focal_length_px", 2);
  const std::vector<double> point = map.numbers("principal_point_px", 2);
  const Eigen::Vector2i size_px = size_px_of(map);
  if (!(focal_length[0] > 0.0 && focal_length[1] > 0.0) || (size_px.array() <= 0).any()) {
    map.fail("focal_length_px", "focal_length_px and size_px must be above 0");
  }
  return {.focal_length_px = {focal_length[0], focal_length[1]},
          .principal_point_px = {point[0], point[1]},
          .distortion = {},
          .size_px = size_px};
}

}  // namespace

ListedImage::ListedImage(const std::string& path,
                         std::filesystem::path folder,
                         const YAML::Node& node)
    : path_(path),
      folder_(std::move(folder)),
      map_(path,
           node,
           {"id", "path", "projection_matrix", "interior", "exterior", "window_px", "name",
            "radiometry"}) {}

bool ListedImage::takes_orientation() const {
  return !map_.has("projection_matrix") && !map_.has("interior") && !map_.has("exterior");
}

ImageToOrient ListedImage::to_orient() const {
  const std::filesystem::path file = (folder_ / map_.text("path")).lexically_normal();
  return {.name = map_.has("name") ? map_.text("name") : file.string(),
          .path = file.string(),
          .is_whole = !map_.has("window_px") || states_what_is_read()};
}

void ListedImage::require_whole_frame() const {
  for (const char* const key :
       {"projection_matrix", "interior", "exterior", "window_px", "radiometry"}) {
    if (map_.has(key)) {
      map_.fail(key, fmt::format("{} is only for patches; an image of a block has a path and "
                                 "optionally a name and an id",
                                 key));
    }
  }
}

PatchImage ListedImage::read(const PatchOrientation* orientation) const {
  PatchImage image = with_camera(orientation);
  set_window(image);
  set_radiometry(image);
  return image;
}

PatchImage ListedImage::with_camera(const PatchOrientation* orientation) const {
  if (orientation != nullptr && takes_orientation()) return oriented(*orientation);
  if (map_.has("name")) {
    map_.fail("name", "name requires an orientation and an image without its own camera");
  }
  PatchImage image;
  image.id = map_.text("id");
  image.path = to_orient().path;
  if (map_.has("projection_matrix")) {
    if (map_.has("interior") || map_.has("exterior") || !corner_px().isZero()) {
      map_.fail("projection_matrix",
                "projection_matrix cannot be combined with interior, exterior or the corner of a "
                "cut-out in window_px");
    }
    image.image_from_world = matrix();
    return image;
  }
  if (!map_.has("interior") || !map_.has("exterior")) {
    map_.fail("interior",
              "no camera: give projection_matrix, or interior and exterior, or an orientation for "
              "the patch");
  }
  image.interior = interior();
  image.exterior = exterior();
  image.window_px = corner_px();
  image.image_from_world =
      window_from_world(projection_matrix(*image.interior, *image.exterior), image.window_px);
  return image;
}

PatchImage ListedImage::oriented(const PatchOrientation& orientation) const {
  try {
    PatchImage image = orientation.oriented(to_orient(), corner_px());
    image.id = map_.has("id") ? map_.text("id") : std::filesystem::path(image.path).stem().string();
    return image;
  } catch (const std::invalid_argument& error) {
    map_.fail(map_.has("name") ? "name" : "path", error.what());
  }
}

/// Whether window_px is [column, row, columns, rows], the part to be read of a file that shows the
/// whole frame, rather than [column, row], the position of a cut-out file in the frame.
bool ListedImage::states_what_is_read() const {
  return map_.has("window_px") && map_.node("window_px").size() == 4;
}

/// Position of the file's top-left pixel in the frame.
Eigen::Vector2d ListedImage::corner_px() const {
  if (!map_.has("window_px") || states_what_is_read()) return Eigen::Vector2d::Zero();
  const std::vector<double> corner = map_.numbers("window_px", 2);
  return {corner[0], corner[1]};
}

void ListedImage::set_window(PatchImage& image) const {
  if (!states_what_is_read()) return;
  const std::vector<double> values = map_.numbers("window_px", 4);
  constexpr double kMaxCoordinate_px = 1e6;
  for (std::size_t i = 0; i < 4; ++i) {
    const double least = i < 2 ? 0.0 : 2.0;
    if (values[i] == std::floor(values[i]) && values[i] >= least && values[i] <= kMaxCoordinate_px)
      continue;
    map_.fail("window_px", fmt::format("window_px = [{}]; must be whole numbers [column, row, "
                                       "columns, rows] within the frame, at least 2 x 2",
                                       fmt::join(values, ", ")));
  }
  read_window_only(image, {static_cast<int>(values[0]), static_cast<int>(values[1]),
                           static_cast<int>(values[2]), static_cast<int>(values[3])});
}

void ListedImage::set_radiometry(PatchImage& image) const {
  if (!map_.has("radiometry")) return;
  const YAML::Node ranges = map_.node("radiometry");
  if (!ranges.IsSequence() || ranges.size() == 0) {
    map_.fail("radiometry", "radiometry must be a list of [low, high] per band");
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const std::vector<double> range = yaml_numbers(path_, ranges[i], "a range of radiometry", 2);
    if (!(range[0] < range[1])) {
      map_.fail("radiometry",
                fmt::format("radiometry has [{}, {}]; must be [low, high]", range[0], range[1]));
    }
    image.radiometry.push_back({range[0], range[1]});
  }
}

ProjectionMatrix ListedImage::matrix() const {
  const YAML::Node rows = map_.node("projection_matrix");
  if (!rows.IsSequence() || rows.size() != 3) {
    map_.fail("projection_matrix", "projection_matrix must have three rows of four numbers");
  }
  ProjectionMatrix P;
  for (int row = 0; row < 3; ++row) {
    const std::vector<double> numbers =
        yaml_numbers(path_, rows[static_cast<std::size_t>(row)], "a row of projection_matrix", 4);
    P.row(row) = Eigen::Map<const Eigen::RowVector4d>(numbers.data());
  }
  if (!is_central_camera(P)) {
    map_.fail(
        "projection_matrix",
        "projection_matrix: its left 3x3 part has rank < 3; must have rank 3 (a central camera)");
  }
  return P;
}

InteriorOrientation ListedImage::interior() const {
  const YAML::Node node = map_.node("interior");
  const YamlMap map(path_, node,
                    {"focal_length_mm", "pixel_size_um", "size_px", "principal_point_mm",
                     "focal_length_px", "principal_point_px", "k1", "k2", "k3", "p1", "p2"});
  const auto optional = [&map](const char* key) { return map.has(key) ? map.number(key) : 0.0; };
  try {
    InteriorOrientation interior =
        map.has("focal_length_px") ? interior_in_pixels(map) : interior_in_mm(map);
    interior.distortion = {optional("k1"), optional("k2"), optional("k3"), optional("p1"),
                           optional("p2")};
    return interior;
  } catch (const std::invalid_argument& error) {
    fail_yaml(path_, node, error.what());
  }
}

ExteriorOrientation ListedImage::exterior() const {
  const YamlMap map(path_, map_.node("exterior"), {"position_m", "omega_phi_kappa_deg"});
  const std::vector<double> position = map.numbers("position_m", 3);
  const std::vector<double> angles = map.numbers("omega_phi_kappa_deg", 3);
  return {{position[0], position[1], position[2]},
          world_from_camera_axes(angles[0] * kRadPerDeg, angles[1] * kRadPerDeg,
                                 angles[2] * kRadPerDeg)};
}

}  // namespace ridgeline::io
