// SPDX-License-Identifier: BSD-3-Clause
#include "apps/info/patch_facts.h"

#include "apps/info/data_facts.h"
#include "apps/info/image_facts.h"
#include "apps/info/own_files.h"
#include "apps/pipeline/open_patch.h"
#include "io/error.h"
#include "io/files/input_file.h"
#include "io/kinds/folder_kind.h"
#include "io/project/patch.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <vector>

namespace ridgeline::apps {
namespace {

std::vector<std::string> missing_files(const io::Patch& patch) {
  std::vector<std::string> warnings;
  const auto look_for = [&](const std::string& file) {
    if (!std::filesystem::exists(file)) warnings.push_back(file + " does not exist");
  };
  for (const io::PatchImage& image : patch.images) {
    look_for(image.path);
    if (image.segments) look_for(*image.segments);
  }
  for (const std::string& pattern : patch.lidar) {
    try {
      for (const std::string& file : io::expand_patterns({pattern})) look_for(file);
    } catch (const io::IoError& error) {
      warnings.emplace_back(error.what());
    }
  }
  if (patch.reference_matches) look_for(*patch.reference_matches);
  if (patch.reference_tracks) look_for(*patch.reference_tracks);
  if (patch.reference_lines) look_for(*patch.reference_lines);
  return warnings;
}

void print_image_of_patch(const io::PatchImage& image) {
  const Eigen::Vector3d centre = projection_centre(image.image_from_world).hnormalized();
  const std::string window =
      image.window ? fmt::format(", window {} x {} at {}, {}", image.window->width,
                                 image.window->height, image.window->column, image.window->row)
                   : "";
  fmt::print("  image       {}: {}, {}{}, projection centre {:.3f} {:.3f} {:.3f}\n", image.id,
             image.path, image_text(image.path), window, centre.x(), centre.y(), centre.z());
}

}  // namespace

void print_patch(const std::string& path, InfoWarnings& warnings) {
  const io::Patch patch = read_patch(path);
  fmt::print("{}: patch {}\n  heights     {:g} .. {:g} m\n", path, patch.id,
             patch.height_range_m[0], patch.height_range_m[1]);
  for (const io::PatchImage& image : patch.images) print_image_of_patch(image);
  if (patch.area_file) fmt::print("  area        {}\n", *patch.area_file);
  if (!patch.orientation_files.empty())
    fmt::print("  orientation {}\n", fmt::join(patch.orientation_files, " "));
  fmt::print("  lidar       {}\n", fmt::join(patch.lidar, " "));
  print_crs(patch.crs);
  for (const std::string& decision : patch.decisions) fmt::print("  decided     {}\n", decision);
  for (const std::string& warning : patch.warnings) warnings.add(path, warning);
  for (const std::string& warning : missing_files(patch)) warnings.add(path, warning);
  print_use(fmt::format("ridgeline run {} --out results", path));
}

void print_patches(const std::string& folder, const io::FileKind& kind, InfoWarnings& warnings) {
  const std::vector<std::string> files = io::patch_files_in(folder);
  if (files.size() == 1) return print_patch(files.front(), warnings);
  fmt::print("{}: {}\n", folder, kind.what.substr(2));
  for (const std::string& file : files) {
    const io::Patch patch = read_patch(file);
    fmt::print("  patch       {}: {}, {} images\n", patch.id, file, patch.images.size());
  }
  print_use(fmt::format("ridgeline run {} --out results", fmt::join(files, " ")));
}

}  // namespace ridgeline::apps
