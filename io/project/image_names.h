// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Finds images of an orientation by file name.
class ImageNames {
 public:
  explicit ImageNames(const Orientation& orientation);

  /// The index in Orientation::images of the image that `name` refers to, or std::nullopt if there
  /// is none: the image with this name; otherwise the one with the same last part, ignoring
  /// folders; otherwise the one with the same last part ignoring the extension, which many programs
  /// leave out. Throws std::invalid_argument, naming candidates, if several images match.
  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const;

  /// The image that a file shows, found by the last part of its path; if several images match, by
  /// as many of the preceding folders as needed. Returns std::nullopt and throws like find().
  [[nodiscard]] std::optional<std::size_t> find_file(const std::string& path) const;

  /// As find(), but throws std::invalid_argument, naming the most similar images, if there is none.
  [[nodiscard]] std::size_t at(const std::string& name) const;

 private:
  /// All images that a name may refer to.
  [[nodiscard]] std::vector<std::size_t> meant(const std::string& name) const;

  std::vector<std::string> names_;
  /// By full names, by their last parts, and by the last parts without extensions.
  std::array<std::multimap<std::string, std::size_t>, 3> numbers_;
};

}  // namespace ridgeline::io
