// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/image_of_name.h"

#include "io/text/nearest_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace ridgeline::io {
namespace {

std::string last_part(const std::string& name) { return name.substr(name.find_last_of("/\\") + 1); }

/// The last part of a name without the extension, which begins with a letter: "7.12" has none.
std::string bare_name(const std::string& name) {
  const std::string last = last_part(name);
  const std::size_t dot = last.rfind('.');
  const bool has_extension = dot != std::string::npos && dot > 0 && dot + 1 < last.size() &&
                             std::isalpha(static_cast<unsigned char>(last[dot + 1])) != 0;
  return has_extension ? last.substr(0, dot) : last;
}

/// The images whose name `part_of` makes the same as `name`.
template <typename PartOf>
std::vector<std::size_t> images_with(const Orientation& orientation,
                                     const std::string& name,
                                     const PartOf& part_of) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < orientation.images.size(); ++i) {
    if (part_of(orientation.images[i].name) == part_of(name)) found.push_back(i);
  }
  return found;
}

std::vector<std::size_t> images_meant(const Orientation& orientation, const std::string& name) {
  const auto whole = [](const std::string& text) { return text; };
  std::vector<std::size_t> found = images_with(orientation, name, whole);
  if (found.empty()) found = images_with(orientation, name, last_part);
  if (found.empty()) found = images_with(orientation, name, bare_name);
  return found;
}

/// The names most like `name`, the nearest first.
std::vector<std::string_view> nearest_names(const Orientation& orientation,
                                            const std::string& name) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string_view> left;
  for (const OrientedImage& image : orientation.images) left.push_back(image.name);
  std::vector<std::string_view> nearest;
  while (!left.empty() && nearest.size() < kMost) {
    nearest.push_back(nearest_name(name, left));
    left.erase(std::ranges::find(left, nearest.back()));
  }
  return nearest;
}

}  // namespace

std::optional<std::size_t> find_image(const Orientation& orientation, const std::string& name) {
  const std::vector<std::size_t> found = images_meant(orientation, name);
  if (found.empty()) return std::nullopt;
  if (found.size() == 1) return found.front();
  throw std::invalid_argument(fmt::format(
      "has {} images that {} may mean, among them {} and {}; state one by the key name",
      found.size(), name, orientation.images[found[0]].name, orientation.images[found[1]].name));
}

std::size_t image_of_name(const Orientation& orientation, const std::string& name) {
  if (const auto found = find_image(orientation, name)) return *found;
  throw std::invalid_argument(fmt::format("has no image {}; the nearest names are {}", name,
                                          fmt::join(nearest_names(orientation, name), ", ")));
}

}  // namespace ridgeline::io
