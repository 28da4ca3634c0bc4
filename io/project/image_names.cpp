// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/image_names.h"

#include "io/text/nearest_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string_view>

namespace ridgeline::io {
namespace {

std::string last_part(const std::string& name) { return name.substr(name.find_last_of("/\\") + 1); }

/// The last part of a name without its extension. An extension begins with a letter: "7.12" has
/// none.
std::string bare_name(const std::string& name) {
  const std::string last = last_part(name);
  const std::size_t dot = last.rfind('.');
  const bool has_extension = dot != std::string::npos && dot > 0 && dot + 1 < last.size() &&
                             std::isalpha(static_cast<unsigned char>(last[dot + 1])) != 0;
  return has_extension ? last.substr(0, dot) : last;
}

/// The forms in which a name is looked up: the full name, its last part, and the last part without
/// its extension.
std::array<std::string, 3> forms_of(const std::string& name) {
  return {name, last_part(name), bare_name(name)};
}

/// The names most similar to `name`, the most similar first.
std::vector<std::string_view> nearest_names(const std::vector<std::string>& names,
                                            const std::string& name) {
  constexpr std::size_t kMaxNames = 3;
  std::vector<std::string_view> left(names.begin(), names.end());
  std::vector<std::string_view> nearest;
  while (!left.empty() && nearest.size() < kMaxNames) {
    nearest.push_back(nearest_name(name, left));
    left.erase(std::ranges::find(left, nearest.back()));
  }
  return nearest;
}

}  // namespace

ImageNames::ImageNames(const Orientation& orientation) {
  for (const OrientedImage& image : orientation.images) {
    const std::array<std::string, 3> forms = forms_of(image.name);
    for (std::size_t i = 0; i < forms.size(); ++i) numbers_[i].emplace(forms[i], names_.size());
    names_.push_back(image.name);
  }
}

std::vector<std::size_t> ImageNames::meant(const std::string& name) const {
  const std::array<std::string, 3> forms = forms_of(name);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < forms.size() && found.empty(); ++i) {
    const auto [first, end] = numbers_[i].equal_range(forms[i]);
    for (auto entry = first; entry != end; ++entry) found.push_back(entry->second);
  }
  return found;
}

std::optional<std::size_t> ImageNames::find(const std::string& name) const {
  const std::vector<std::size_t> found = meant(name);
  if (found.empty()) return std::nullopt;
  if (found.size() == 1) return found.front();
  throw std::invalid_argument(
      fmt::format("has {} images that could be {}, such as {} and {}; select one with the key name",
                  found.size(), name, names_[found[0]], names_[found[1]]));
}

std::optional<std::size_t> ImageNames::find_file(const std::string& path) const {
  std::size_t begin = path.rfind('/');
  while (begin != std::string::npos) {
    const std::vector<std::size_t> found = meant(path.substr(begin + 1));
    if (found.empty()) return std::nullopt;
    if (found.size() == 1) return found.front();
    if (begin == 0) break;
    begin = path.rfind('/', begin - 1);
  }
  return find(path);
}

std::size_t ImageNames::at(const std::string& name) const {
  if (const auto found = find(name)) return *found;
  throw std::invalid_argument(fmt::format("has no image {}; similar names: {}", name,
                                          fmt::join(nearest_names(names_, name), ", ")));
}

}  // namespace ridgeline::io
