// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/patch.h"

#include "io/files/yaml_check.h"
#include "io/orientation/colmap.h"
#include "io/project/image_list.h"
#include "io/project/patch_area.h"
#include "io/project/patch_orientation.h"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>

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
             {"id", "crs", "height_range", "surface_model", "area", "max_views", "images",
              "orientation", "cameras", "angles", "rotation", "matrix", "colmap", "colmap_images",
              "lidar", "reference_matches", "reference_tracks", "reference_lines"}) {}

  [[nodiscard]] PatchFile read(const FindPatchPoints& find) {
    PatchFile patch;
    patch.path = path_;
    patch.id = map_.text("id");
    patch.crs = crs();
    if (map_.has("lidar")) {
      for (const std::string& file : map_.texts("lidar")) patch.lidar.push_back(resolved(file));
    }
    read_heights(patch);
    read_orientation(find, patch);
    read_area(patch);
    read_images(patch);
    check_images(patch.images);
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
    if (names_files(map_)) {
      for (const std::string& file : image_files(map_, folder_))
        images.push_back(whole_image(file));
      return images;
    }
    for (const YAML::Node& node : image_list()) {
      const YamlMap map = image_map(node);
      if (takes_orientation(map)) images.push_back(image_to_orient(map));
    }
    return images;
  }

  [[nodiscard]] static ImageToOrient whole_image(const std::string& file) {
    return {.name = std::filesystem::path(file).filename().string(), .path = file};
  }

  [[nodiscard]] static bool takes_orientation(const YamlMap& image) {
    return !image.has("projection_matrix") && !image.has("interior") && !image.has("exterior");
  }

  [[nodiscard]] ImageToOrient image_to_orient(const YamlMap& map) const {
    const std::string path = resolved(map.text("path"));
    return {.name = map.has("name") ? map.text("name")
                                    : std::filesystem::path(path).filename().string(),
            .path = path,
            .is_whole = !map.has("window_px") || map.node("window_px").size() == 4};
  }

  void read_heights(PatchFile& patch) const {
    patch.surface_model = optional_path("surface_model");
    const YAML::Node node = map_.node("height_range");
    if (!node.IsScalar()) {
      patch.height_range_m = height_range();
      if (patch.surface_model) {
        map_.fail("surface_model",
                  "surface_model serves height_range: auto; the heights are stated");
      }
      return;
    }
    if (map_.text("height_range") != "auto") {
      map_.fail("height_range", fmt::format("height_range = {}; must be [lowest, highest] or auto",
                                            map_.text("height_range")));
    }
    if (!patch.surface_model && patch.lidar.empty()) {
      map_.fail("height_range",
                "height_range: auto takes the heights from lidar or surface_model; "
                "the patch has neither");
    }
    patch.heights = patch.surface_model ? HeightSource::kSurfaceModel : HeightSource::kLidar;
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

  void read_area(PatchFile& patch) const {
    patch.area_m = area_of_patch(map_, folder_, patch.crs);
    if (map_.has("area") && map_.node("area").IsScalar())
      patch.area_file = resolved(map_.text("area"));
    if (!map_.has("max_views")) return;
    if (patch.area_m.empty()) {
      map_.fail("max_views", "max_views needs area: the images that show it best are taken");
    }
    const double most = map_.number("max_views");
    constexpr double kMost = 100.0;
    if (most != std::floor(most) || most < 2.0 || most > kMost) {
      map_.fail("max_views",
                fmt::format("max_views = {}; must be a whole number, 2 to {}", most, kMost));
    }
    patch.max_views = static_cast<std::size_t>(most);
  }

  void read_images(PatchFile& patch) const {
    if (map_.has("images") == map_.has("colmap")) {
      map_.fail("images", "one of the keys images and colmap is needed, and not both");
    }
    patch.chooses_images = !patch.area_m.empty() && (map_.has("colmap") || names_files(map_));
    if (map_.has("max_views") && !patch.chooses_images) {
      map_.fail("max_views",
                "max_views needs images by a folder or pattern, or colmap; images that "
                "are listed one by one are all used");
    }
    if (patch.chooses_images && map_.has("reference_matches")) {
      map_.fail("reference_matches",
                "reference_matches is of the first two images, which the area "
                "decides; state reference_tracks, or list the images");
    }
    if (map_.has("colmap")) {
      patch.images = colmap_images();
      return;
    }
    if (map_.has("colmap_images")) map_.fail("colmap_images", "colmap_images needs colmap");
    if (names_files(map_)) return read_image_files(patch);
    for (const YAML::Node& node : image_list()) patch.images.push_back(image(image_map(node)));
  }

  /// The files of a folder or pattern, without those that the orientation does not know.
  void read_image_files(PatchFile& patch) const {
    if (!orientation_) map_.fail("images", "images by a folder or pattern need an orientation");
    std::map<std::size_t, std::string> file_of_number;
    std::vector<std::string> unknown;
    for (const std::string& file : image_files(map_, folder_)) {
      const ImageToOrient image = whole_image(file);
      try {
        const std::optional<std::size_t> number = orientation_->number_of(image);
        if (!number) {
          unknown.push_back(file);
          continue;
        }
        const auto [other, is_new] = file_of_number.emplace(*number, file);
        if (!is_new) {
          map_.fail("images", fmt::format("{} and {} are one image of the orientation by their "
                                          "names; narrow the pattern",
                                          other->second, file));
        }
        patch.images.push_back(orientation_->oriented(image, Eigen::Vector2d::Zero()));
      } catch (const std::invalid_argument& error) {
        map_.fail("images", error.what());
      }
    }
    std::set<std::size_t> numbers;
    for (const auto& [number, file] : file_of_number) numbers.insert(number);
    patch.without_file = orientation_->others(numbers);
    if (unknown.empty()) return;
    patch.warnings.push_back(fmt::format(
        "{}: {} of {} files of images are not in the orientation and not used, the first is {}",
        path_, unknown.size(), unknown.size() + patch.images.size(), unknown.front()));
  }

  [[nodiscard]] YAML::Node image_list() const {
    YAML::Node list = map_.node("images");
    if (!list.IsSequence()) map_.fail("images", "images must be a list");
    return list;
  }

  [[nodiscard]] YamlMap image_map(const YAML::Node& node) const {
    return {path_,
            node,
            {"id", "path", "projection_matrix", "interior", "exterior", "window_px", "name",
             "radiometry"}};
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

  /// Where the file begins in the frame: [column, row] of a file that is cut out of the frame.
  [[nodiscard]] static Eigen::Vector2d window_px(const YamlMap& map) {
    if (!map.has("window_px") || map.node("window_px").size() == 4) return Eigen::Vector2d::Zero();
    const std::vector<double> window = map.numbers("window_px", 2);
    return {window[0], window[1]};
  }

  /// Sets what is read of a file that is the frame, [column, row, columns, rows].
  static void set_window(const YamlMap& map, PatchImage& image) {
    if (!map.has("window_px") || map.node("window_px").size() != 4) return;
    const std::vector<double> values = map.numbers("window_px", 4);
    constexpr double kMost = 1e6;
    for (std::size_t i = 0; i < 4; ++i) {
      const double least = i < 2 ? 0.0 : 2.0;
      if (values[i] == std::floor(values[i]) && values[i] >= least && values[i] <= kMost) continue;
      map.fail("window_px", fmt::format("window_px = [{}]; must be whole numbers [column, row, "
                                        "columns, rows] within the frame, at least 2 x 2",
                                        fmt::join(values, ", ")));
    }
    read_window_only(image, {static_cast<int>(values[0]), static_cast<int>(values[1]),
                             static_cast<int>(values[2]), static_cast<int>(values[3])});
  }

  void set_radiometry(const YamlMap& map, PatchImage& image) const {
    if (!map.has("radiometry")) return;
    const YAML::Node ranges = map.node("radiometry");
    if (!ranges.IsSequence() || ranges.size() == 0) {
      map.fail("radiometry", "radiometry must be a list of [low, high], one for each band");
    }
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const std::vector<double> range = yaml_numbers(path_, ranges[i], "a range of radiometry", 2);
      if (!(range[0] < range[1])) {
        map.fail("radiometry",
                 fmt::format("radiometry has [{}, {}]; must be [low, high]", range[0], range[1]));
      }
      image.radiometry.push_back({range[0], range[1]});
    }
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
    PatchImage image = image_with_camera(map);
    set_window(map, image);
    set_radiometry(map, image);
    return image;
  }

  [[nodiscard]] PatchImage image_with_camera(const YamlMap& map) const {
    if (orientation_ && takes_orientation(map)) return oriented_image(map);
    if (map.has("name")) {
      map.fail("name", "name needs an orientation, and an image without a camera of its own");
    }
    PatchImage image;
    image.id = map.text("id");
    image.path = resolved(map.text("path"));
    if (map.has("projection_matrix")) {
      if (map.has("interior") || map.has("exterior") || !window_px(map).isZero()) {
        map.fail("projection_matrix",
                 "projection_matrix stands alone: without interior, exterior and the corner of a "
                 "cut-out in window_px");
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

void read_window_only(PatchImage& image, const Window& window) {
  const Eigen::Vector2d corner(window.column, window.row);
  image.window = window;
  image.window_px += corner;
  image.image_from_world = window_from_world(image.image_from_world, corner);
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
