// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/yaml_check.h"
#include "io/orientation/colmap.h"
#include "io/project/block_file.h"
#include "io/project/image_list.h"
#include "io/project/listed_image.h"
#include "io/project/patch.h"
#include "io/project/patch_area.h"
#include "io/project/patch_orientation.h"
#include "io/project/stated_crs.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace ridgeline::io {
namespace {

/// Whether two projection centres coincide, which indicates a copied orientation rather than a
/// short base: a millimetre is far below any stereo base.
bool in_one_place(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  constexpr double kRelativeTolerance = 1e-9;  // a few millimetres in six million metres
  return (a - b).norm() <= kRelativeTolerance * a.norm();
}

/// The keys of a patch file, or of a block file.
std::vector<std::string_view> keys_of(bool is_block) {
  std::vector<std::string_view> keys{is_block ? "block" : "id",
                                     "crs",
                                     "height_range",
                                     "surface_model",
                                     "area",
                                     "max_views",
                                     "images",
                                     "orientation",
                                     "cameras",
                                     "angles",
                                     "rotation",
                                     "matrix",
                                     "colmap",
                                     "colmap_images",
                                     "lidar",
                                     "segments"};
  if (is_block) {
    keys.insert(keys.end(), {"patch_size_m", "overlap_m"});
  } else {
    keys.insert(keys.end(), {"segment_sigma_px", "reference_matches", "reference_tracks"});
  }
  keys.emplace_back("reference_lines");
  return keys;
}

class PatchReader {
 public:
  PatchReader(const std::string& path, bool is_block)
      : path_(path),
        folder_(std::filesystem::path(path).parent_path()),
        is_block_(is_block),
        map_(path,
             load_yaml(path, is_block ? FileGroup::kBlock : FileGroup::kPatch),
             keys_of(is_block)) {}

  [[nodiscard]] PatchFile read(const FindPatchPoints& find) {
    PatchFile patch;
    read_project(find, patch);
    patch.reference_matches = optional_path("reference_matches");
    patch.reference_tracks = optional_path("reference_tracks");
    patch.reference_lines = optional_path("reference_lines");
    return patch;
  }

  [[nodiscard]] BlockFile read_block(const FindPatchPoints& find) {
    BlockFile block;
    if (map_.has("segments")) {
      map_.fail("segments", "segments are only for patches; a block extracts its own");
    }
    read_project(find, block);
    block.reference_lines = optional_path("reference_lines");
    if (map_.has("patch_size_m")) block.patch_size_m = length_m("patch_size_m", 20.0, 10000.0);
    block.overlap_m = map_.has("overlap_m") ? length_m("overlap_m", 1.0, 1000.0)
                                            : std::min(block.overlap_m, 0.5 * block.patch_size_m);
    if (block.overlap_m > 0.5 * block.patch_size_m) {
      map_.fail(
          "overlap_m",
          fmt::format(
              "overlap_m = {}, patch_size_m = {}; the overlap must be at most half the patch size",
              block.overlap_m, block.patch_size_m));
    }
    return block;
  }

 private:
  /// All but reference data.
  void read_project(const FindPatchPoints& find, ProjectFile& project) {
    project.path = path_;
    project.id = map_.text(is_block_ ? "block" : "id");
    project.crs = stated_crs(map_);
    if (map_.has("lidar")) {
      for (const std::string& file : map_.texts("lidar")) project.lidar.push_back(resolved(file));
    }
    read_heights(project);
    read_orientation(find, project);
    read_area(project);
    read_images(project);
    check_images(project);
    read_segments(project);
  }

  [[nodiscard]] double length_m(const char* key, double least, double most) const {
    const double value = map_.number(key);
    if (value < least || value > most) {
      map_.fail(key, fmt::format("{} = {}; must be {} to {} m", key, value, least, most));
    }
    return value;
  }

  [[nodiscard]] std::string resolved(const std::string& file) const {
    return (folder_ / file).lexically_normal().string();
  }

  [[nodiscard]] std::optional<std::string> optional_path(const char* key) const {
    return map_.has(key) ? std::optional(resolved(map_.text(key))) : std::nullopt;
  }

  /// Reads the orientation if the file names one. The project adopts its reference system if it has
  /// none of its own.
  void read_orientation(const FindPatchPoints& find, ProjectFile& project) {
    if (!map_.has("orientation")) {
      for (const char* key : {"cameras", "angles", "rotation", "matrix"}) {
        if (map_.has(key)) map_.fail(key, fmt::format("{} requires orientation", key));
      }
      return;
    }
    if (map_.has("colmap")) map_.fail("orientation", "orientation requires images, not colmap");
    orientation_.emplace(map_, folder_, project.crs, images_to_orient(), find);
    if (!project.crs.known()) project.crs = orientation_->crs();
    project.orientation_files = orientation_->files();
    project.decisions = orientation_->decisions();
    project.warnings = orientation_->warnings();
  }

  [[nodiscard]] std::vector<ImageToOrient> images_to_orient() const {
    std::vector<ImageToOrient> images;
    if (names_files(map_)) {
      for (const std::string& file : image_files(map_, folder_))
        images.push_back(whole_image(file));
      return images;
    }
    for (const ListedImage& image : listed_images())
      if (image.takes_orientation()) images.push_back(image.to_orient());
    return images;
  }

  [[nodiscard]] static ImageToOrient whole_image(const std::string& file) {
    return {.name = file, .path = file};
  }

  void read_heights(ProjectFile& project) const {
    project.surface_model = optional_path("surface_model");
    const YAML::Node node = map_.node("height_range");
    if (!node.IsScalar()) {
      project.height_range_m = height_range();
      if (project.surface_model) {
        map_.fail("surface_model", "surface_model is only used with height_range: auto");
      }
      return;
    }
    if (map_.text("height_range") != "auto") {
      map_.fail("height_range", fmt::format("height_range = {}; must be [lowest, highest] or auto",
                                            map_.text("height_range")));
    }
    if (!project.surface_model && project.lidar.empty()) {
      map_.fail("height_range", "height_range: auto requires lidar or surface_model");
    }
  }

  [[nodiscard]] std::array<double, 2> height_range() const {
    const std::vector<double> range = map_.numbers("height_range", 2);
    if (range[0] >= range[1]) {
      map_.fail(
          "height_range",
          fmt::format("height_range = [{}, {}]; must be [lowest, highest] with lowest < highest",
                      range[0], range[1]));
    }
    return {range[0], range[1]};
  }

  void read_area(ProjectFile& project) const {
    project.area_m = area_of_patch(map_, folder_, project.crs, project.warnings);
    if (map_.has("area") && map_.node("area").IsScalar())
      project.area_file = resolved(map_.text("area"));
    if (!map_.has("max_views")) return;
    if (project.area_m.empty() && !is_block_) {
      map_.fail("max_views", "max_views requires area, whose best images it selects");
    }
    const double most = map_.number("max_views");
    constexpr double kMaxViews = 100.0;
    if (most != std::floor(most) || most < 2.0 || most > kMaxViews) {
      map_.fail("max_views",
                fmt::format("max_views = {}; must be a whole number, 2 to {}", most, kMaxViews));
    }
    project.max_views = static_cast<std::size_t>(most);
  }

  void read_images(ProjectFile& project) const {
    if (map_.has("images") == map_.has("colmap")) {
      map_.fail("images", "exactly one of the keys images and colmap is required");
    }
    const bool are_candidates =
        is_block_ || (!project.area_m.empty() && (map_.has("colmap") || names_files(map_)));
    if (map_.has("max_views") && !are_candidates) {
      map_.fail("max_views",
                "max_views requires images given by folder or pattern, or colmap; images listed "
                "one by one are all used");
    }
    if (are_candidates && map_.has("reference_matches")) {
      map_.fail("reference_matches",
                "reference_matches refers to the first two images, which depend on the area; use "
                "reference_tracks, or list the images");
    }
    if (are_candidates && !project.max_views) project.max_views = kDefaultMaxViews;
    if (map_.has("colmap")) {
      project.images = colmap_images();
      project.orientation_files = colmap_files(resolved(map_.text("colmap")));
      return;
    }
    if (map_.has("colmap_images")) map_.fail("colmap_images", "colmap_images requires colmap");
    if (names_files(map_)) return read_image_files(project);
    for (const ListedImage& image : listed_images()) {
      if (is_block_) image.require_whole_frame();
      project.images.push_back(image.read(orientation_ ? &*orientation_ : nullptr));
    }
  }

  /// Reads the files of a folder or pattern, except those that the orientation does not contain.
  void read_image_files(ProjectFile& project) const {
    if (!orientation_)
      map_.fail("images", "images given by folder or pattern require an orientation");
    try {
      OrientedFiles files = orientation_->images_of(image_files(map_, folder_));
      project.images = std::move(files.images);
      project.without_file = std::move(files.without_file);
      if (files.unknown.empty()) return;
      project.warnings.push_back(fmt::format(
          "{}: {} of {} image files are not in the orientation and are ignored; the first is {}",
          path_, files.unknown.size(), files.unknown.size() + project.images.size(),
          files.unknown.front()));
    } catch (const std::invalid_argument& error) {
      map_.fail("images", error.what());
    }
  }

  [[nodiscard]] std::vector<ListedImage> listed_images() const {
    const YAML::Node list = map_.node("images");
    if (!list.IsSequence()) map_.fail("images", "images must be a list");
    std::vector<ListedImage> images;
    for (const YAML::Node& node : list) images.emplace_back(path_, folder_, node);
    return images;
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
      image.exterior = view.exterior;
      images.push_back(image);
    }
    return images;
  }

  void check_images(const ProjectFile& project) const {
    const char* key = map_.has("images") ? "images" : "colmap";
    const std::vector<PatchImage>& images = project.images;
    if (images.size() < 2) {
      map_.fail(key, fmt::format("{} images; at least two are required", images.size()));
    }
    std::set<std::string_view> ids;
    for (const PatchImage& image : images) {
      if (!ids.insert(image.id).second) {
        map_.fail(key, fmt::format("two images have the id {}", image.id));
      }
    }
    if (!project.max_views) require_bases(images, key);
  }

  /// Candidate images may share positions, as those of a multi-head camera do; those of a patch may
  /// not.
  void require_bases(const std::vector<PatchImage>& images, const char* key) const {
    const std::vector<Eigen::Vector3d> centres =
        transformed(images, [](const PatchImage& image) -> Eigen::Vector3d {
          return projection_centre(image.image_from_world).hnormalized();
        });
    for (std::size_t i = 0; i < images.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!in_one_place(centres[i], centres[j])) continue;
        map_.fail(key,
                  fmt::format(
                      "the cameras of {} and {} have the same position; a stereo pair needs a base",
                      images[j].id, images[i].id));
      }
    }
  }

  /// Reads the segment files, given by image id.
  void read_segments(ProjectFile& project) const {
    double sigma_px = kDefaultSegmentSigma_px;
    if (map_.has("segment_sigma_px")) {
      if (!map_.has("segments")) {
        map_.fail("segment_sigma_px", "segment_sigma_px requires segments");
      }
      sigma_px = map_.number("segment_sigma_px");
      if (!(sigma_px > 0.0)) {
        map_.fail("segment_sigma_px",
                  fmt::format("segment_sigma_px = {}; must be positive", sigma_px));
      }
    }
    if (!map_.has("segments")) return;
    const YamlMap files(path_, map_.node("segments"),
                        transformed(project.images, [](const PatchImage& image) {
                          return std::string_view(image.id);
                        }));
    for (PatchImage& image : project.images) {
      const char* id = image.id.c_str();
      image.segment_sigma_px = sigma_px;
      if (files.has(id)) image.segments = resolved(files.text(id));
    }
  }

  std::string path_;
  std::filesystem::path folder_;
  bool is_block_;  ///< otherwise a patch file
  YamlMap map_;
  std::optional<PatchOrientation> orientation_;
};

}  // namespace

PatchFile read_patch(const std::string& path, const FindPatchPoints& find) {
  return PatchReader(path, false).read(find);
}

BlockFile read_block_file(const std::string& path, const FindPatchPoints& find) {
  return PatchReader(path, true).read_block(find);
}

}  // namespace ridgeline::io
