// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/files/yaml_check.h"
#include "io/orientation/read_orientation.h"
#include "io/project/patch.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ridgeline::io {

/// An image of a patch that takes its camera and pose from an orientation.
struct ImageToOrient {
  std::string name;  ///< as image_of_name() takes it
  std::string path;
  bool is_whole = true;  ///< the file shows the whole frame
};

/// The orientation that a patch file names.
class PatchOrientation {
 public:
  /// Reads it as the patch's keys orientation, cameras, angles, rotation and matrix say; files are relative to `folder`.
  /// `crs`: what the patch states, perhaps nothing. `images` and `find` serve to decide what the file leaves open.
  /// Throws IoError as read_orientation() does, for words that are not known, and if both reference systems are stated and
  /// differ.
  PatchOrientation(const YamlMap& patch,
                   const std::filesystem::path& folder,
                   const Crs& crs,
                   const std::vector<ImageToOrient>& images,
                   const FindPatchPoints& find);

  /// The image with its camera. Throws std::invalid_argument, which names the orientation, if that does not have the image
  /// or its camera.
  [[nodiscard]] PatchImage oriented(const ImageToOrient& image,
                                    const Eigen::Vector2d& window_px) const;

  /// The number of the image that a file shows, or nothing if the orientation has none of its name. Throws
  /// std::invalid_argument, which names the orientation, if it has several.
  [[nodiscard]] std::optional<std::size_t> number_of(const ImageToOrient& image) const;

  /// The images with cameras whose numbers are not among these; they have no path.
  [[nodiscard]] std::vector<PatchImage> others(const std::set<std::size_t>& numbers) const;

  [[nodiscard]] const Crs& crs() const { return orientation_.crs; }
  /// The orientation and the file of cameras; of a COLMAP model its files of cameras and images.
  [[nodiscard]] std::vector<std::string> files() const;
  /// Decisions and warnings, with the orientation in front.
  [[nodiscard]] std::vector<std::string> decisions() const;
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  [[nodiscard]] OrientationOptions stated_options(const YamlMap& patch) const;
  void compare_systems(const YamlMap& patch, const Crs& crs);

  std::string path_;
  std::string cameras_;  ///< empty if the patch names none
  Orientation orientation_;
};

}  // namespace ridgeline::io
