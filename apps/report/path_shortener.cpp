// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/path_shortener.h"

#include <algorithm>
#include <filesystem>

namespace ridgeline::apps {
namespace {

/// Whether a path begins at this position of the text; false within a longer path.
bool begins_path(const std::string& text, std::size_t at) {
  static constexpr std::string_view kWithin = "/._-";
  if (at == 0) return true;
  const auto before = static_cast<unsigned char>(text[at - 1]);
  return std::isalnum(before) == 0 && before < 0x80 &&
         kWithin.find(text[at - 1]) == std::string_view::npos;
}

}  // namespace

PathShortener::PathShortener(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    std::string name = path;
    while (name.size() > 1 && name.back() == '/') name.pop_back();
    const std::string folder = std::filesystem::path(name).parent_path().string();
    if (!folder.empty() && folder != "/") folders_.push_back(folder + "/");
  }
  std::sort(folders_.begin(), folders_.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() > b.size() : a < b;
  });
  folders_.erase(std::unique(folders_.begin(), folders_.end()), folders_.end());
}

void PathShortener::shorten(std::string& text) const {
  for (const std::string& folder : folders_) {
    std::size_t at = text.find(folder);
    while (at != std::string::npos) {
      const bool is_path = begins_path(text, at);
      if (is_path) text.erase(at, folder.size());
      at = text.find(folder, is_path ? at : at + 1);
    }
  }
}

void PathShortener::shorten(evaluate::Json& json) const {
  if (json.is_string()) {
    shorten(json.get_ref<std::string&>());
  } else if (json.is_structured()) {
    for (evaluate::Json& part : json) shorten(part);
  }
}

}  // namespace ridgeline::apps
