// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/write_orientation.h"

#include "apps/simulate/orientation_writers.h"
#include "io/files/atomic_file.h"
#include "io/text/nearest_name.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace ridgeline::simulate {
namespace {

struct WrittenFile {
  const char* name;
  std::string (*text)(const io::Orientation&);
};

struct WrittenFormat {
  const char* name;
  const char* orientation;
  const char* cameras;
  const char* matrix;
  std::vector<WrittenFile> files;
};

const std::vector<WrittenFormat>& formats() {
  constexpr const char* kCameras = "cameras.yaml";
  static const std::vector<WrittenFormat> all{
      {"opk", "opk.csv", kCameras, "", {{"opk.csv", opk_table_text}, {kCameras, camera_file_text}}},
      {"opensfm", "reconstruction.json", "", "", {{"reconstruction.json", opensfm_text}}},
      {"pix4d",
       "block_calibrated_camera_parameters.txt",
       "",
       "",
       {{"block_calibrated_camera_parameters.txt", pix4d_text},
        {"block_offset.xyz", pix4d_offset_text},
        {"block_wkt.prj", wkt_text}}},
      {"inpho", "inpho.prj", "", "", {{"inpho.prj", inpho_text}}},
      {"pat_b",
       "pat_b.ori",
       kCameras,
       "world_from_camera",
       {{"pat_b.ori", pat_b_text}, {kCameras, camera_file_text}}},
      {"blocks_exchange",
       "blocks_exchange.xml",
       "",
       "",
       {{"blocks_exchange.xml", blocks_exchange_text}}},
      {"metashape", "metashape.xml", "", "", {{"metashape.xml", metashape_text}}},
      {"colmap",
       "colmap",
       "",
       "",
       {{"colmap/cameras.txt", colmap_cameras_text},
        {"colmap/images.txt", colmap_images_text},
        {"colmap/points3D.txt", colmap_points_text}}}};
  return all;
}

const WrittenFormat& format_named(std::string_view name) {
  const auto found = std::ranges::find(formats(), name, &WrittenFormat::name);
  if (found != formats().end()) return *found;
  std::vector<std::string_view> known;
  std::string list;
  for (const WrittenFormat& format : formats()) {
    known.emplace_back(format.name);
    list += (list.empty() ? "" : ", ") + std::string(format.name);
  }
  check(false, "orientation format ", name, ", the nearest is ", io::nearest_name(name, known),
        "; must be one of ", list);
  return formats().front();
}

/// Names that are valid in all formats without quoting or escaping.
void check_name(const std::string& name) {
  const bool is_plain = std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-';
  });
  check(!name.empty() && is_plain, "name \"", name,
        "\", must be of letters, digits, '.', '_' and '-'");
}

void check_camera(const io::Camera& camera) {
  const InteriorOrientation& interior = camera.interior;
  check_name(camera.name);
  check(interior.size_px.has_value(), "camera ", camera.name, ", must have a size");
  check(
      interior.distortion.is_zero() && interior.focal_length_px.x() == interior.focal_length_px.y(),
      "camera ", camera.name, ", must have one focal length and no distortion");
}

/// PAT-B has no camera names.
void check_cameras_by_image(const io::Orientation& orientation) {
  const bool by_image =
      std::ranges::all_of(orientation.images, [&](const io::OrientedImage& image) {
        return camera_name(orientation, image) == image.name;
      });
  check(orientation.cameras.size() == 1 || by_image,
        "cameras for PAT-B, must be one or named after their images");
}

void check_orientation(const io::Orientation& orientation) {
  check(!orientation.images.empty(), "orientation without images, must have one");
  for (const io::Camera& camera : orientation.cameras) check_camera(camera);
  for (const io::OrientedImage& image : orientation.images) {
    check_name(image.name);
    check(image.camera.has_value(), "image ", image.name, ", must have a camera");
  }
}

}  // namespace

OrientationFiles orientation_files(std::string_view format) {
  const WrittenFormat& f = format_named(format);
  return {f.orientation, f.cameras, f.matrix,
          transformed(f.files, [](const WrittenFile& file) { return std::string(file.name); })};
}

void write_orientation(const std::string& folder,
                       std::string_view format,
                       const io::Orientation& orientation) {
  const WrittenFormat& f = format_named(format);
  check_orientation(orientation);
  if (f.matrix[0] != '\0') check_cameras_by_image(orientation);
  for (const WrittenFile& file : f.files) {
    io::write_file((std::filesystem::path(folder) / file.name).string(), file.text(orientation));
  }
}

}  // namespace ridgeline::simulate
