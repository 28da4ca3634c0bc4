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

/// Finds images of an orientation by the names that files have.
class ImageNames {
 public:
  explicit ImageNames(const Orientation& orientation);

  /// The number in Orientation::images of the image that `name` means, or nothing if there is none:
  /// the one of this name; else the one with its last part, behind folders; else the one with its
  /// last part without the extension, as many programs leave that out. Throws
  /// std::invalid_argument, which names images of the orientation, if several are meant.
  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const;

  /// The image that a file shows, by the last part of its path; if that means several images, by so
  /// many of the folders before it as are needed. Nothing and errors as find().
  [[nodiscard]] std::optional<std::size_t> find_file(const std::string& path) const;

  /// find(); throws std::invalid_argument, which names the nearest images of the orientation, if
  /// there is none.
  [[nodiscard]] std::size_t at(const std::string& name) const;

 private:
  /// All images that a name may mean.
  [[nodiscard]] std::vector<std::size_t> meant(const std::string& name) const;

  std::vector<std::string> names_;
  /// By whole names, by their last parts, and by these without extensions.
  std::array<std::multimap<std::string, std::size_t>, 3> numbers_;
};

}  // namespace ridgeline::io
