// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/write_patch.h"

#include "io/files/atomic_file.h"
#include "io/orientation/conventions.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/plan_box.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr int kLossless = 17;  // digits of a double

template <typename Numbers>
void emit_numbers(const char* key, const Numbers& numbers, YAML::Emitter& yaml) {
  yaml << YAML::Key << key << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const auto number : numbers) yaml << number;
  yaml << YAML::EndSeq;
}

void emit(const InteriorOrientation& interior, YAML::Emitter& yaml) {
  const BrownDistortion& lens = interior.distortion;
  yaml << YAML::Key << "interior" << YAML::Value << YAML::BeginMap;
  emit_numbers("focal_length_px", interior.focal_length_px, yaml);
  emit_numbers("principal_point_px", interior.principal_point_px, yaml);
  emit_numbers("size_px", interior.size_px.value(), yaml);
  for (const auto& [key, value] :
       {std::pair("k1", lens.k1), std::pair("k2", lens.k2), std::pair("k3", lens.k3),
        std::pair("p1", lens.p1), std::pair("p2", lens.p2)}) {
    if (value != 0.0) yaml << YAML::Key << key << YAML::Value << value;
  }
  yaml << YAML::EndMap;
}

void emit(const ExteriorOrientation& exterior, YAML::Emitter& yaml) {
  const Angles angles = angles_deg(exterior.world_from_camera_axes);
  yaml << YAML::Key << "exterior" << YAML::Value << YAML::BeginMap;
  emit_numbers("position_m", exterior.position_m, yaml);
  emit_numbers("omega_phi_kappa_deg", std::array{angles.omega, angles.phi, angles.kappa}, yaml);
  yaml << YAML::EndMap;
}

void emit_matrix(const PatchImage& image, YAML::Emitter& yaml) {
  yaml << YAML::Key << "projection_matrix" << YAML::Value << YAML::BeginSeq;
  for (int row = 0; row < 3; ++row) {
    yaml << YAML::Flow << YAML::BeginSeq;
    for (int column = 0; column < 4; ++column) yaml << image.image_from_world(row, column);
    yaml << YAML::EndSeq;
  }
  yaml << YAML::EndSeq;
}

/// Writes the part of the file to be read, or the file's position in the frame.
void emit_window(const PatchImage& image, YAML::Emitter& yaml) {
  if (image.window) {
    const Window& w = *image.window;
    emit_numbers("window_px", std::array{w.column, w.row, w.width, w.height}, yaml);
  } else if (!image.window_px.isZero()) {
    emit_numbers("window_px", image.window_px, yaml);
  }
}

void emit_radiometry(const PatchImage& image, YAML::Emitter& yaml) {
  if (image.radiometry.empty()) return;
  yaml << YAML::Key << "radiometry" << YAML::Value << YAML::BeginSeq;
  for (const auto& [low, high] : image.radiometry)
    yaml << YAML::Flow << YAML::BeginSeq << low << high << YAML::EndSeq;
  yaml << YAML::EndSeq;
}

void emit(const PatchImage& image, bool with_camera, YAML::Emitter& yaml) {
  check(!image.interior || (image.exterior && image.interior->size_px), "write_patch: image ",
        image.id, " has an interior orientation without size, or without an exterior one");
  yaml << YAML::BeginMap;
  if (with_camera) yaml << YAML::Key << "id" << YAML::Value << image.id;
  yaml << YAML::Key << "path" << YAML::Value << image.path;
  if (with_camera && !image.interior) emit_matrix(image, yaml);
  if (with_camera && image.interior) {
    emit(*image.interior, yaml);
    emit(*image.exterior, yaml);
    emit_window(image, yaml);
  }
  emit_radiometry(image, yaml);
  yaml << YAML::EndMap;
}

void emit(const char* key, const std::optional<std::string>& file, YAML::Emitter& yaml) {
  if (file) yaml << YAML::Key << key << YAML::Value << *file;
}

/// Writes the files with another detector's segments, by image.
void emit_segments(const PatchFile& patch, YAML::Emitter& yaml) {
  const auto with_segments = std::ranges::find_if(
      patch.images, [](const auto& image) { return image.segments.has_value(); });
  if (with_segments == patch.images.end()) return;
  yaml << YAML::Key << "segments" << YAML::Value << YAML::BeginMap;
  for (const PatchImage& image : patch.images) emit(image.id.c_str(), image.segments, yaml);
  yaml << YAML::EndMap;
  yaml << YAML::Key << "segment_sigma_px" << YAML::Value << with_segments->segment_sigma_px;
}

/// Writes the area as bounds.
void emit_area(const std::vector<Eigen::Vector2d>& area_m, YAML::Emitter& yaml) {
  if (area_m.empty()) return;
  const Eigen::AlignedBox2d box = box_around(area_m);
  check(corners_of(box) == area_m, "write_patch: the area must be an upright rectangle");
  emit_numbers("area", std::array{box.min().x(), box.min().y(), box.max().x(), box.max().y()},
               yaml);
}

void emit(const PatchKeys& keys, YAML::Emitter& yaml) {
  for (const auto& [key, word] :
       {std::pair("orientation", keys.orientation), std::pair("cameras", keys.cameras),
        std::pair("matrix", keys.matrix)}) {
    if (!word.empty()) yaml << YAML::Key << key << YAML::Value << word;
  }
}

}  // namespace

void write_patch(const std::string& path, const PatchFile& patch, const PatchKeys& keys) {
  check(patch.height_range_m.has_value(), "write_patch: the heights must be stated");
  YAML::Emitter yaml;
  yaml.SetDoublePrecision(kLossless);
  yaml << YAML::BeginMap << YAML::Key << "id" << YAML::Value << YAML::DoubleQuoted << patch.id;
  if (patch.crs.known()) yaml << YAML::Key << "crs" << YAML::Value << patch.crs.definition;
  emit_numbers("height_range", *patch.height_range_m, yaml);
  emit_area(patch.area_m, yaml);
  emit(keys, yaml);
  yaml << YAML::Key << "images" << YAML::Value << YAML::BeginSeq;
  for (const PatchImage& image : patch.images) emit(image, keys.orientation.empty(), yaml);
  yaml << YAML::EndSeq;
  if (!patch.lidar.empty()) yaml << YAML::Key << "lidar" << YAML::Value << patch.lidar;
  emit_segments(patch, yaml);
  emit("reference_matches", patch.reference_matches, yaml);
  emit("reference_tracks", patch.reference_tracks, yaml);
  emit("reference_lines", patch.reference_lines, yaml);
  yaml << YAML::EndMap;
  write_file(path, std::string(yaml.c_str()) + "\n");
}

}  // namespace ridgeline::io
