// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/image_names.h"

#include "io/text/nearest_name.h"
#include "io/text/text.h"
#include "io/text/utf8.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace ridgeline::io {
namespace {

std::string with_slashes(const std::string& name) {
  std::string path = as_utf8(name);
  std::ranges::replace(path, '\\', '/');
  return path;
}

std::string last_part(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// A name without its extension. An extension begins with a letter: "7.12" has none.
std::string bare_name(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const bool has_extension = dot != std::string::npos && dot > 0 && dot + 1 < name.size() &&
                             std::isalpha(static_cast<unsigned char>(name[dot + 1])) != 0;
  return has_extension ? name.substr(0, dot) : name;
}

/// The forms in which the last part of a path is looked up, in this order.
std::array<std::string, 4> forms_of(const std::string& path) {
  const std::string name = last_part(with_slashes(path));
  return {name, lower_case(name), bare_name(name), lower_case(bare_name(name))};
}

/// The folders and the name of a path in lower case.
std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream rest(lower_case(with_slashes(path)));
  for (std::string part; std::getline(rest, part, '/');) {
    if (!part.empty() && part != ".") parts.push_back(part);
  }
  return parts;
}

/// The number of folders that two paths share at their ends.
std::ptrdiff_t n_common_folders(const std::vector<std::string>& a,
                                const std::vector<std::string>& b) {
  if (a.empty() || b.empty()) return 0;
  return std::mismatch(a.rbegin() + 1, a.rend(), b.rbegin() + 1, b.rend()).first - a.rbegin() - 1;
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
    const std::array<std::string, 4> forms = forms_of(image.name);
    for (std::size_t i = 0; i < forms.size(); ++i) numbers_[i].emplace(forms[i], names_.size());
    names_.push_back(image.name);
    parts_.push_back(parts_of(image.name));
  }
}

std::optional<std::size_t> ImageNames::find(const std::string& path) const {
  const Parts parts = parts_of(path);
  const std::array<std::string, 4> forms = forms_of(path);
  for (std::size_t i = 0; i < forms.size(); ++i) {
    const auto [first, end] = numbers_[i].equal_range(forms[i]);
    std::map<std::ptrdiff_t, std::vector<std::size_t>> by_folders;
    for (auto entry = first; entry != end; ++entry) {
      by_folders[n_common_folders(parts, parts_[entry->second])].push_back(entry->second);
    }
    if (by_folders.empty()) continue;
    const std::vector<std::size_t>& nearest = by_folders.rbegin()->second;
    if (nearest.size() == 1) return nearest.front();
    const auto same = std::ranges::find(nearest, path, [&](std::size_t n) { return names_[n]; });
    if (same != nearest.end()) return *same;
    throw std::invalid_argument(fmt::format(
        "has {} images that could be {}, such as {} and {}; select one with the key name",
        nearest.size(), path, names_[nearest[0]], names_[nearest[1]]));
  }
  return std::nullopt;
}

std::size_t ImageNames::at(const std::string& path) const {
  if (const auto found = find(path)) return *found;
  throw std::invalid_argument(
      fmt::format("has no image {}{}", last_part(with_slashes(path)), similar_names(path)));
}

std::string ImageNames::similar_names(const std::string& path) const {
  if (names_.empty()) return "";
  return fmt::format("; similar names: {}",
                     fmt::join(nearest_names(names_, last_part(with_slashes(path))), ", "));
}

}  // namespace ridgeline::io
