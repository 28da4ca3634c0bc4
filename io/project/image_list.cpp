// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/image_list.h"

#include "io/files/expand_patterns.h"
#include "io/text/text.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace ridgeline::io {
namespace fs = std::filesystem;
namespace {

bool is_named_as_image(const fs::path& path) {
  constexpr std::array<std::string_view, 6> kEndings{".tif", ".tiff", ".jp2",
                                                     ".jpg", ".jpeg", ".png"};
  return std::ranges::find(kEndings, lower_case(path.extension().string())) != kEndings.end();
}

std::vector<std::string> images_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && is_named_as_image(entry.path()))
      files.push_back(entry.path().string());
  }
  if (files.empty()) throw IoError(folder, "has no image (.tif, .tiff, .jp2, .jpg, .jpeg or .png)");
  std::ranges::sort(files);
  return files;
}

}  // namespace

bool names_files(const YamlMap& patch) {
  if (!patch.has("images")) return false;
  const YAML::Node node = patch.node("images");
  if (node.IsScalar()) return true;
  return node.IsSequence() && node.size() > 0 &&
         std::all_of(node.begin(), node.end(),
                     [](const YAML::Node& one) { return one.IsScalar(); });
}

std::vector<std::string> image_files(const YamlMap& patch, const fs::path& folder) {
  std::vector<std::string> files;
  for (const std::string& text : patch.texts("images")) {
    const std::string path = (folder / text).lexically_normal().string();
    std::ranges::move(fs::is_directory(path) ? images_in(path) : expand_patterns({path}),
                      std::back_inserter(files));
  }
  return files;
}

}  // namespace ridgeline::io
