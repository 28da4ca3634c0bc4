// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/files/yaml_check.h"
#include "io/orientation/read_orientation.h"
#include "io/project/image_names.h"
#include "io/project/patch.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// An image of a patch that takes its camera and pose from an orientation.
struct ImageToOrient {
  std::string name;  ///< as ImageNames takes it
  std::string path;
  bool is_whole = true;  ///< the file shows the whole frame
};

/// Files and the images of an orientation that they show.
struct OrientedFiles {
  std::vector<PatchImage> images;    ///< in the order of the files
  std::vector<std::string> unknown;  ///< files that show no image of the orientation
  std::vector<PatchImage>
      without_file;  ///< images with a camera that no file shows; they have no path
};

/// The orientation that a patch file names.
class PatchOrientation {
 public:
  /// Reads it as the patch's keys orientation, cameras, angles, rotation and matrix say; files are
  /// relative to `folder`. `crs`: what the patch states, perhaps nothing. `images` and `find` serve
  /// to decide what the file leaves open. Throws IoError as read_orientation() does, for words that
  /// are not known, and if both reference systems are stated and differ.
  PatchOrientation(const YamlMap& patch,
                   const std::filesystem::path& folder,
                   const Crs& crs,
                   const std::vector<ImageToOrient>& images,
                   const FindPatchPoints& find);

  /// The image with its camera. Throws std::invalid_argument, which names the orientation, if that
  /// does not have the image or its camera.
  [[nodiscard]] PatchImage oriented(const ImageToOrient& image,
                                    const Eigen::Vector2d& window_px) const;

  /// The images that whole files show, by their names. Throws std::invalid_argument, which names
  /// the orientation, if a file may be several images, or an image may be several files or has no
  /// camera.
  [[nodiscard]] OrientedFiles images_of(const std::vector<std::string>& files) const;

  [[nodiscard]] const Crs& crs() const { return orientation_.crs; }
  /// The orientation and the file of cameras; of a COLMAP model its files of cameras and images.
  [[nodiscard]] std::vector<std::string> files() const;
  /// Decisions and warnings, with the orientation in front.
  [[nodiscard]] std::vector<std::string> decisions() const;
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  [[nodiscard]] OrientationOptions stated_options(const YamlMap& patch) const;
  void compare_systems(const YamlMap& patch, const Crs& crs);

  [[nodiscard]] PatchImage with_camera(std::size_t number,
                                       const std::string& path,
                                       const Eigen::Vector2d& window_px) const;

  std::string path_;
  std::string cameras_;  ///< empty if the patch names none
  Orientation orientation_;
  std::optional<ImageNames> names_;  ///< of the orientation
};

}  // namespace ridgeline::io
