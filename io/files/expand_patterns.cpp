// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/expand_patterns.h"

#include "io/error.h"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <system_error>

namespace ridgeline::io {

namespace {

std::vector<std::string> matches_of(const std::string& pattern) {
  glob_t found{};
  const std::unique_ptr<glob_t, decltype(&globfree)> release(&found, &globfree);
  const int status = glob(pattern.c_str(), 0, nullptr, &found);
  if (status == GLOB_NOMATCH) throw MissingFileError(pattern, "matches no file");
  if (status != 0) throw IoError(pattern, "cannot be searched; check the folder's permissions");
  std::vector<std::string> names(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  std::ranges::sort(names);  // sorted bytewise, because glob's own order depends on the locale
  return names;
}

bool is_pattern(const std::string& text) {
  std::error_code ignored;
  return text.find_first_of("*?[") != std::string::npos &&
         !std::filesystem::exists(text, ignored);  // a real file may be named "tile[1].las"
}

/// A file that matches two patterns is a single tile, whose points count once.
std::vector<std::string> without_repeats(std::vector<std::string> paths) {
  std::set<std::filesystem::path> seen;
  std::erase_if(paths, [&](const std::string& path) {
    return !seen.insert(std::filesystem::weakly_canonical(path)).second;
  });
  return paths;
}

}  // namespace

std::vector<std::string> expand_patterns(const std::vector<std::string>& paths_or_patterns) {
  std::vector<std::string> paths;
  for (const std::string& text : paths_or_patterns) {
    if (is_pattern(text)) {
      for (std::string& path : matches_of(text)) paths.push_back(std::move(path));
    } else {
      paths.push_back(text);
    }
  }
  return without_repeats(std::move(paths));
}

}  // namespace ridgeline::io
