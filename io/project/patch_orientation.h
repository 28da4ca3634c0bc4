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
  std::string name;  ///< a name for ImageNames to look up
  std::string path;
  bool is_whole = true;  ///< whether the file shows the whole frame
};

/// Files assigned to the images of an orientation that they show.
struct OrientedFiles {
  std::vector<PatchImage> images;    ///< in the order of the files
  std::vector<std::string> unknown;  ///< files that match no image of the orientation
  std::vector<PatchImage>
      without_file;  ///< images that have a camera but no file; their path is empty
};

/// The orientation that a patch file refers to.
class PatchOrientation {
 public:
  /// Reads it as specified by the patch's keys orientation, cameras, angles, rotation and matrix;
  /// files are relative to `folder`. `crs`: the patch's own CRS, which may be unknown. `images` and
  /// `find` are used to resolve ambiguities of the file. Throws IoError under the same conditions
  /// as read_orientation(), for invalid words, and if the reference systems of patch and
  /// orientation are both known but differ.
  PatchOrientation(const YamlMap& patch,
                   const std::filesystem::path& folder,
                   const Crs& crs,
                   const std::vector<ImageToOrient>& images,
                   const FindPatchPoints& find);

  /// The image with its camera. Throws std::invalid_argument, naming the orientation, if the
  /// orientation lacks the image or its camera.
  [[nodiscard]] PatchImage oriented(const ImageToOrient& image,
                                    const Eigen::Vector2d& window_px) const;

  /// Assigns files that show whole frames to images by name. Throws std::invalid_argument, naming
  /// the orientation, if no file matches an image, if a file matches several images or several
  /// files match one image, or if a matched image has no camera.
  [[nodiscard]] OrientedFiles images_of(const std::vector<std::string>& files) const;

  [[nodiscard]] const Crs& crs() const { return orientation_.crs; }
  /// The files of the orientation, those read with it, and the camera file; for a COLMAP model, its
  /// files of cameras and images.
  [[nodiscard]] std::vector<std::string> files() const;
  /// Decisions and warnings, each prefixed with the orientation's path.
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
