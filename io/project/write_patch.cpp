// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/write_patch.h"

#include "io/files/atomic_file.h"
#include "reconstruct/geometry/check.h"

#include <yaml-cpp/yaml.h>

#include <utility>

namespace ridgeline::io {
namespace {

constexpr int kLossless = 17;  // digits of a double

void emit(const PatchImage& image, bool with_matrix, YAML::Emitter& yaml) {
  check(!image.interior, "write_patch: image ", image.id, " has an interior orientation");
  yaml << YAML::BeginMap;
  if (!with_matrix) {
    yaml << YAML::Key << "path" << YAML::Value << image.path << YAML::EndMap;
    return;
  }
  yaml << YAML::Key << "id" << YAML::Value << image.id;
  yaml << YAML::Key << "path" << YAML::Value << image.path;
  yaml << YAML::Key << "projection_matrix" << YAML::Value << YAML::BeginSeq;
  for (int row = 0; row < 3; ++row) {
    yaml << YAML::Flow << YAML::BeginSeq;
    for (int column = 0; column < 4; ++column) yaml << image.image_from_world(row, column);
    yaml << YAML::EndSeq;
  }
  yaml << YAML::EndSeq << YAML::EndMap;
}

void emit(const char* key, const std::optional<std::string>& file, YAML::Emitter& yaml) {
  if (file) yaml << YAML::Key << key << YAML::Value << *file;
}

void emit(const PatchKeys& keys, YAML::Emitter& yaml) {
  if (keys.area_m) {
    yaml << YAML::Key << "area" << YAML::Value << YAML::Flow << YAML::BeginSeq;
    for (const double bound_m : *keys.area_m) yaml << bound_m;
    yaml << YAML::EndSeq;
  }
  for (const auto& [key, word] :
       {std::pair("orientation", keys.orientation), std::pair("cameras", keys.cameras),
        std::pair("matrix", keys.matrix)}) {
    if (!word.empty()) yaml << YAML::Key << key << YAML::Value << word;
  }
}

}  // namespace

void write_patch(const std::string& path, const PatchFile& patch, const PatchKeys& keys) {
  YAML::Emitter yaml;
  yaml.SetDoublePrecision(kLossless);
  yaml << YAML::BeginMap << YAML::Key << "id" << YAML::Value << YAML::DoubleQuoted << patch.id;
  if (patch.crs.known()) yaml << YAML::Key << "crs" << YAML::Value << patch.crs.definition;
  yaml << YAML::Key << "height_range" << YAML::Value << YAML::Flow << YAML::BeginSeq
       << patch.height_range_m[0] << patch.height_range_m[1] << YAML::EndSeq;
  emit(keys, yaml);
  yaml << YAML::Key << "images" << YAML::Value << YAML::BeginSeq;
  for (const PatchImage& image : patch.images) emit(image, keys.orientation.empty(), yaml);
  yaml << YAML::EndSeq;
  if (!patch.lidar.empty()) yaml << YAML::Key << "lidar" << YAML::Value << patch.lidar;
  emit("reference_matches", patch.reference_matches, yaml);
  emit("reference_tracks", patch.reference_tracks, yaml);
  emit("reference_lines", patch.reference_lines, yaml);
  yaml << YAML::EndMap;
  write_file(path, std::string(yaml.c_str()) + "\n");
}

}  // namespace ridgeline::io
