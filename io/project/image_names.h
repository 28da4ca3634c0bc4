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

  /// The index in Orientation::images of the image that a file name or path refers to, or
  /// std::nullopt if there is none. The last part of the path decides first: images with the same
  /// one, otherwise ignoring case, otherwise ignoring the extension, which many programs leave out,
  /// otherwise ignoring both. Of several such images, it is the one that shares the most folders at
  /// the end of the path. Slashes and backslashes are the same. Throws std::invalid_argument,
  /// naming two images, if that is a tie.
  [[nodiscard]] std::optional<std::size_t> find(const std::string& path) const;

  /// As find(), but throws std::invalid_argument, naming the most similar images, if there is none.
  [[nodiscard]] std::size_t at(const std::string& path) const;

  /// "; similar names: a.tif, b.tif", for messages.
  [[nodiscard]] std::string similar_names(const std::string& path) const;

 private:
  using Parts = std::vector<std::string>;

  std::vector<std::string> names_;
  std::vector<Parts> parts_;  ///< lower case, one per image
  /// By the last parts of names in the four forms of find().
  std::array<std::multimap<std::string, std::size_t>, 4> numbers_;
};

}  // namespace ridgeline::io
