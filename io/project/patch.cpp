// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/patch.h"

#include "io/files/yaml_check.h"
#include "io/orientation/colmap.h"
#include "io/project/patch_orientation.h"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace ridgeline::io {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;

/// Whether two cameras are in one place, which is a copied orientation and no short base: a millimetre is far below
/// any stereo base.
bool in_one_place(const ProjectionMatrix& a, const ProjectionMatrix& b) {
  constexpr double kRelativeTolerance = 1e-9;  // a few millimetres in six million metres
  const Eigen::Vector3d centre_a = projection_centre(a).hnormalized();
  const Eigen::Vector3d centre_b = projection_centre(b).hnormalized();
  return (centre_a - centre_b).norm() <= kRelativeTolerance * centre_a.norm();
}

class PatchReader {
 public:
  explicit PatchReader(const std::string& path)
      : path_(path),
        folder_(std::filesystem::path(path).parent_path()),
        map_(path,
             load_yaml(path, Expected::kPatch),
             {"id", "crs", "height_range", "images", "orientation", "cameras", "angles", "rotation",
              "matrix", "colmap", "colmap_images", "lidar", "reference_matches", "reference_tracks",
              "reference_lines"}) {}

  [[nodiscard]] PatchFile read(const FindPatchPoints& find) {
    PatchFile patch;
    patch.path = path_;
    patch.id = map_.text("id");
    patch.crs = crs();
    patch.height_range_m = height_range();
    read_orientation(find, patch);
    patch.images = images();
    check_images(patch.images);
    if (map_.has("lidar")) {
      for (const std::string& file : map_.texts("lidar")) patch.lidar.push_back(resolved(file));
    }
    patch.reference_matches = optional_path("reference_matches");
    patch.reference_tracks = optional_path("reference_tracks");
    patch.reference_lines = optional_path("reference_lines");
    return patch;
  }

 private:
  [[nodiscard]] std::string resolved(const std::string& file) const {
    return (folder_ / file).lexically_normal().string();
  }

  [[nodiscard]] std::optional<std::string> optional_path(const char* key) const {
    return map_.has(key) ? std::optional(resolved(map_.text(key))) : std::nullopt;
  }

  [[nodiscard]] Crs crs() const {
    if (!map_.has("crs")) return {};
    Crs crs{map_.text("crs")};
    try {
      describe(crs);
    } catch (const std::invalid_argument& error) {
      map_.fail("crs", std::string("crs: ") + error.what());
    }
    return crs;
  }

  /// Reads the orientation if the patch names one. The patch takes its reference system if it states none itself.
  void read_orientation(const FindPatchPoints& find, PatchFile& patch) {
    if (!map_.has("orientation")) {
      for (const char* key : {"cameras", "angles", "rotation", "matrix"}) {
        if (map_.has(key)) map_.fail(key, fmt::format("{} needs orientation", key));
      }
      return;
    }
    if (map_.has("colmap")) map_.fail("orientation", "orientation needs images, not colmap");
    orientation_.emplace(map_, folder_, patch.crs, images_to_orient(), find);
    if (!patch.crs.known()) patch.crs = orientation_->crs();
    patch.orientation_files = orientation_->files();
    patch.decisions = orientation_->decisions();
    patch.warnings = orientation_->warnings();
  }

  [[nodiscard]] std::vector<ImageToOrient> images_to_orient() const {
    std::vector<ImageToOrient> images;
    for (const YAML::Node& node : image_list()) {
      const YamlMap map = image_map(node);
      if (takes_orientation(map)) images.push_back(image_to_orient(map));
    }
    return images;
  }

  [[nodiscard]] static bool takes_orientation(const YamlMap& image) {
    return !image.has("projection_matrix") && !image.has("interior") && !image.has("exterior");
  }

  [[nodiscard]] ImageToOrient image_to_orient(const YamlMap& map) const {
    const std::string path = resolved(map.text("path"));
    return {.name = map.has("name") ? map.text("name")
                                    : std::filesystem::path(path).filename().string(),
            .path = path,
            .is_whole = !map.has("window_px")};
  }

  [[nodiscard]] std::array<double, 2> height_range() const {
    const std::vector<double> range = map_.numbers("height_range", 2);
    if (range[0] >= range[1]) {
      map_.fail("height_range",
                fmt::format("height_range = [{}, {}]; the lowest height comes first and must be "
                            "below the highest",
                            range[0], range[1]));
    }
    return {range[0], range[1]};
  }

  [[nodiscard]] std::vector<PatchImage> images() const {
    if (map_.has("images") == map_.has("colmap")) {
      map_.fail("images", "one of the keys images and colmap is needed, and not both");
    }
    if (map_.has("colmap")) return colmap_images();
    if (map_.has("colmap_images")) map_.fail("colmap_images", "colmap_images needs colmap");
    std::vector<PatchImage> images;
    for (const YAML::Node& node : image_list()) images.push_back(image(image_map(node)));
    return images;
  }

  [[nodiscard]] YAML::Node image_list() const {
    YAML::Node list = map_.node("images");
    if (!list.IsSequence()) map_.fail("images", "images must be a list");
    return list;
  }

  [[nodiscard]] YamlMap image_map(const YAML::Node& node) const {
    return {path_,
            node,
            {"id", "path", "projection_matrix", "interior", "exterior", "window_px", "name"}};
  }

  [[nodiscard]] std::vector<PatchImage> colmap_images() const {
    const std::string folder =
        map_.has("colmap_images") ? resolved(map_.text("colmap_images")) : folder_.string();
    std::vector<PatchImage> images;
    for (const ColmapImage& view : read_colmap(resolved(map_.text("colmap")))) {
      PatchImage image;
      image.id = std::to_string(view.id);
      image.path = (std::filesystem::path(folder) / view.name).lexically_normal().string();
      image.image_from_world = projection_matrix(view.interior, view.exterior);
      image.interior = view.interior;
      images.push_back(image);
    }
    return images;
  }

  [[nodiscard]] static Eigen::Vector2d window_px(const YamlMap& map) {
    if (!map.has("window_px")) return Eigen::Vector2d::Zero();
    const std::vector<double> window = map.numbers("window_px", 2);
    return {window[0], window[1]};
  }

  [[nodiscard]] PatchImage oriented_image(const YamlMap& map) const {
    try {
      PatchImage image = orientation_->oriented(image_to_orient(map), window_px(map));
      image.id = map.has("id") ? map.text("id") : std::filesystem::path(image.path).stem().string();
      return image;
    } catch (const std::invalid_argument& error) {
      map.fail(map.has("name") ? "name" : "path", error.what());
    }
  }

  [[nodiscard]] PatchImage image(const YamlMap& map) const {
    if (orientation_ && takes_orientation(map)) return oriented_image(map);
    if (map.has("name")) {
      map.fail("name", "name needs an orientation, and an image without a camera of its own");
    }
    PatchImage image;
    image.id = map.text("id");
    image.path = resolved(map.text("path"));
    if (map.has("projection_matrix")) {
      if (map.has("interior") || map.has("exterior") || map.has("window_px")) {
        map.fail("projection_matrix",
                 "projection_matrix stands alone: without interior, exterior and window_px");
      }
      image.image_from_world = matrix(map);
      return image;
    }
    if (!map.has("interior") || !map.has("exterior")) {
      map.fail("interior",
               "projection_matrix is missing, or in its place interior and exterior, or the "
               "orientation of the patch");
    }
    image.interior = interior(map.node("interior"));
    image.window_px = window_px(map);
    image.image_from_world = window_from_world(
        projection_matrix(*image.interior, exterior(map.node("exterior"))), image.window_px);
    return image;
  }

  [[nodiscard]] ProjectionMatrix matrix(const YamlMap& map) const {
    const YAML::Node rows = map.node("projection_matrix");
    if (!rows.IsSequence() || rows.size() != 3) {
      map.fail("projection_matrix", "projection_matrix must have three rows of four numbers");
    }
    ProjectionMatrix P;
    for (int row = 0; row < 3; ++row) {
      const std::vector<double> numbers =
          yaml_numbers(path_, rows[static_cast<std::size_t>(row)], "a row of projection_matrix", 4);
      P.row(row) = Eigen::Map<const Eigen::RowVector4d>(numbers.data());
    }
    if (!is_central_camera(P)) {
      map.fail("projection_matrix",
               "projection_matrix: its left 3x3 part has rank < 3; a central camera has rank 3");
    }
    return P;
  }

  [[nodiscard]] InteriorOrientation interior(const YAML::Node& node) const {
    const YamlMap map(path_, node,
                      {"focal_length_mm", "pixel_size_um", "size_px", "principal_point_mm", "k1",
                       "k2", "k3", "p1", "p2"});
    const std::vector<double> size = map.numbers("size_px", 2);
    const std::vector<double> point =
        map.has("principal_point_mm") ? map.numbers("principal_point_mm", 2) : std::vector{0., 0.};
    const auto optional = [&map](const char* key) { return map.has(key) ? map.number(key) : 0.0; };
    try {
      InteriorOrientation interior = interior_orientation(
          map.number("focal_length_mm"), map.number("pixel_size_um"),
          Eigen::Vector2i(std::lround(size[0]), std::lround(size[1])), {point[0], point[1]});
      interior.distortion = {optional("k1"), optional("k2"), optional("k3"), optional("p1"),
                             optional("p2")};
      return interior;
    } catch (const std::invalid_argument& error) {
      fail_yaml(path_, node, error.what());
    }
  }

  [[nodiscard]] ExteriorOrientation exterior(const YAML::Node& node) const {
    const YamlMap map(path_, node, {"position_m", "omega_phi_kappa_deg"});
    const std::vector<double> position = map.numbers("position_m", 3);
    const std::vector<double> angles = map.numbers("omega_phi_kappa_deg", 3);
    return {{position[0], position[1], position[2]},
            world_from_camera_axes(angles[0] * kRadPerDeg, angles[1] * kRadPerDeg,
                                   angles[2] * kRadPerDeg)};
  }

  void check_images(const std::vector<PatchImage>& images) const {
    const char* key = map_.has("images") ? "images" : "colmap";
    if (images.size() < 2) {
      map_.fail(key, fmt::format("{} images; at least two are needed", images.size()));
    }
    for (std::size_t i = 0; i < images.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (images[i].id == images[j].id) {
          map_.fail(key, fmt::format("two images have the id {}", images[i].id));
        }
        if (in_one_place(images[i].image_from_world, images[j].image_from_world)) {
          map_.fail(key,
                    fmt::format("the cameras of {} and {} are in one place; a stereo pair needs "
                                "a base",
                                images[j].id, images[i].id));
        }
      }
    }
  }

  std::string path_;
  std::filesystem::path folder_;
  YamlMap map_;
  std::optional<PatchOrientation> orientation_;
};

}  // namespace

std::optional<Eigen::Vector2d> undistorted_px(const PatchImage& image,
                                              const Eigen::Vector2d& x_px) {
  if (!image.interior || image.interior->distortion.is_zero()) return x_px;
  const std::optional<Eigen::Vector2d> ideal =
      undistorted_px(*image.interior, x_px + image.window_px);
  if (!ideal) return std::nullopt;
  return *ideal - image.window_px;
}

std::array<ProjectionMatrix, 2> cameras_in_local(const PatchFile& patch, const LocalFrame& frame) {
  return {image_from_local(patch.images[0].image_from_world, frame.origin_m),
          image_from_local(patch.images[1].image_from_world, frame.origin_m)};
}

std::array<double, 2> heights_in_local_m(const PatchFile& patch, const LocalFrame& frame) {
  return {patch.height_range_m[0] - frame.origin_m.z(),
          patch.height_range_m[1] - frame.origin_m.z()};
}

PatchFile read_patch(const std::string& path, const FindPatchPoints& find) {
  return PatchReader(path).read(find);
}

}  // namespace ridgeline::io
