// SPDX-License-Identifier: BSD-3-Clause
#include "apps/info/orientation_facts.h"

#include "apps/info/own_files.h"
#include "apps/pipeline/image_points.h"
#include "io/error.h"
#include "io/kinds/folder_kind.h"
#include "io/orientation/footprints.h"
#include "io/orientation/option_words.h"
#include "io/orientation/read_orientation.h"

#include <Eigen/Geometry>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace ridgeline::apps {
namespace {

/// The folder in which images are searched.
std::string image_folder(const std::string& path, const OrientationArguments& arguments) {
  if (!arguments.images.empty()) return arguments.images;
  const std::filesystem::path file(path);
  return (std::filesystem::is_directory(file) ? file : file.parent_path()).string();
}

io::OrientationOptions options_of(const std::string& path, const OrientationArguments& arguments) {
  io::OrientationOptions options;
  options.cameras = arguments.cameras;
  options.crs = {arguments.crs};
  options.angles = io::angle_unit_named(arguments.angles);
  options.rotation = io::rotation_order_named(arguments.rotation);
  options.matrix = io::matrix_direction_named(arguments.matrix);
  options.find_observations =
      [folder = image_folder(path, arguments)](const io::Orientation& orientation) {
        return find_image_points(orientation, folder);
      };
  return options;
}

/// The name of a reference system, or its definition if it has no name, like PROJ strings.
std::string crs_text(const io::Crs& crs) {
  if (!crs.known()) return "unknown";
  const std::string name = io::describe(crs).name;
  return name == "unknown" ? crs.definition : name;
}

void print_camera(const io::Camera& camera) {
  const InteriorOrientation& interior = camera.interior;
  const std::string size =
      interior.size_px ? fmt::format("{} x {} px, ", interior.size_px->x(), interior.size_px->y())
                       : "";
  const Eigen::Vector2d& focal = interior.focal_length_px;
  const std::string focal_text = std::abs(focal.x() - focal.y()) < 0.005
                                     ? fmt::format("{:.2f}", focal.x())
                                     : fmt::format("{:.2f} and {:.2f}", focal.x(), focal.y());
  fmt::print("  camera      {}: {}focal length {} px, principal point {:.2f} {:.2f} px, {}\n",
             camera.name, size, focal_text, interior.principal_point_px.x(),
             interior.principal_point_px.y(),
             interior.distortion.is_zero() ? "no distortion" : "Brown distortion");
}

void print_positions(const io::Orientation& orientation) {
  Eigen::AlignedBox3d box;
  for (const io::OrientedImage& image : orientation.images) box.extend(image.exterior.position_m);
  fmt::print("  positions   x {:.3f} .. {:.3f}, y {:.3f} .. {:.3f}, z {:.3f} .. {:.3f}\n",
             box.min().x(), box.max().x(), box.min().y(), box.max().y(), box.min().z(),
             box.max().z());
}

void print_images(const io::Orientation& orientation, const std::string& folder) {
  const auto n_files = std::ranges::count_if(
      orientation.images,
      [&](const io::OrientedImage& image) { return image_file_in(folder, image).has_value(); });
  fmt::print("  images      {}, {} to {}; {} of them in {}\n", orientation.images.size(),
             orientation.images.front().name, orientation.images.back().name, n_files,
             folder.empty() ? "." : folder);
}

void write_map(const std::string& path,
               const OrientationArguments& arguments,
               const io::Orientation& orientation) {
  if (arguments.map.empty()) return;
  const std::optional<double> height_m =
      arguments.ground_height_m ? arguments.ground_height_m : orientation.ground_height_m;
  if (!height_m) {
    throw io::IoError(path, "has no ground height; give --ground-height");
  }
  io::write_orientation_map(arguments.map, orientation, *height_m);
  fmt::print("  map         {}, footprints at {:.1f} m\n", arguments.map, *height_m);
}

}  // namespace

void print_orientation(const std::string& path,
                       const OrientationArguments& arguments,
                       InfoWarnings& warnings) {
  const io::Orientation orientation = io::read_orientation(path, options_of(path, arguments));
  fmt::print("{}: {}\n", path, orientation.format);
  print_images(orientation, image_folder(path, arguments));
  for (const io::Camera& camera : orientation.cameras) print_camera(camera);
  if (orientation.cameras.empty()) fmt::print("  camera      unknown; give --cameras\n");
  print_positions(orientation);
  if (orientation.ground_height_m)
    fmt::print("  ground      {:.1f} m\n", *orientation.ground_height_m);
  fmt::print("  crs         {}\n", crs_text(orientation.crs));
  for (const std::string& decision : orientation.decisions)
    fmt::print("  decided     {}\n", decision);
  for (const std::string& warning : orientation.warnings) warnings.add(path, warning);
  write_map(path, arguments, orientation);
}

void print_orientations(const std::string& folder,
                        const io::FileKind& kind,
                        OrientationArguments arguments,
                        InfoWarnings& warnings) {
  if (arguments.images.empty()) {
    const std::filesystem::path images = std::filesystem::path(folder) / "images";
    arguments.images = std::filesystem::is_directory(images) ? images.string() : folder;
  }
  const std::vector<std::string> files = io::orientations_in(folder);
  if (files.size() == 1) return print_orientation(files.front(), arguments, warnings);
  fmt::print("{}: {}\n", folder, kind.what.substr(2));
  for (const std::string& file : files) fmt::print("  orientation {}\n", file);
  print_use(fmt::format("ridgeline info {}", files.front()));
}

}  // namespace ridgeline::apps
