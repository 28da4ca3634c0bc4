// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/files/yaml_check.h"
#include "io/project/patch.h"
#include "io/project/patch_orientation.h"

#include <filesystem>
#include <string>

namespace ridgeline::io {

/// An image that a patch file lists under `images`, with the keys described at read_patch(). The
/// functions throw IoError with the line for invalid values.
class ListedImage {
 public:
  /// `path`: the patch file, for messages; files are relative to `folder`.
  ListedImage(const std::string& path, std::filesystem::path folder, const YAML::Node& node);

  /// Whether the image has no camera of its own and takes it from the orientation.
  [[nodiscard]] bool takes_orientation() const;
  [[nodiscard]] ImageToOrient to_orient() const;

  /// Throws for a camera of its own, a window and radiometry, which a block decides.
  void require_whole_frame() const;

  /// `orientation`: the orientation of the patch, or null.
  [[nodiscard]] PatchImage read(const PatchOrientation* orientation) const;

 private:
  [[nodiscard]] PatchImage with_camera(const PatchOrientation* orientation) const;
  [[nodiscard]] PatchImage oriented(const PatchOrientation& orientation) const;
  [[nodiscard]] bool states_what_is_read() const;
  [[nodiscard]] Eigen::Vector2d corner_px() const;
  void set_window(PatchImage& image) const;
  void set_radiometry(PatchImage& image) const;
  [[nodiscard]] ProjectionMatrix matrix() const;
  [[nodiscard]] InteriorOrientation interior() const;
  [[nodiscard]] ExteriorOrientation exterior() const;

  std::string path_;
  std::filesystem::path folder_;
  YamlMap map_;
};

}  // namespace ridgeline::io
