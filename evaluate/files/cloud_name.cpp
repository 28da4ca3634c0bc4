// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/cloud_name.h"

#include "evaluate/files/judge_files.h"
#include "io/text/utf8.h"

#include <filesystem>

namespace ridgeline::results {
namespace fs = std::filesystem;
namespace {

bool is_file(const std::string& path_or_pattern) {
  std::error_code ignored;
  return fs::exists(path_or_pattern, ignored);  // a file may be named "tile[1].las"
}

/// The folder of a file; for a pattern, the part of its folder before the first wildcard.
fs::path folder_of(const std::string& path_or_pattern) {
  fs::path folder = fs::absolute(path_or_pattern).lexically_normal().parent_path();
  if (is_file(path_or_pattern)) return folder;
  fs::path fixed;
  for (const fs::path& part : folder) {
    if (part.string().find_first_of("*?[") != std::string::npos) break;
    fixed /= part;
  }
  return fixed;
}

fs::path common_folder(const fs::path& a, const fs::path& b) {
  fs::path common;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end() && *i == *j; ++i, ++j) {
    common /= *i;
  }
  return common;
}

}  // namespace

std::string cloud_name(const std::vector<std::string>& paths_or_patterns) {
  if (paths_or_patterns.size() == 1 && is_file(paths_or_patterns.front())) {
    return stem_of(paths_or_patterns.front());
  }
  fs::path folder = folder_of(paths_or_patterns.front());
  for (const std::string& other : paths_or_patterns) {
    folder = common_folder(folder, folder_of(other));
  }
  const std::string name = io::as_utf8(folder.filename().string());
  return name.empty() ? "cloud" : name;
}

}  // namespace ridgeline::results
