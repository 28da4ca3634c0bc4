// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/folder_kind.h"

#include "io/kinds/marks.h"
#include "io/kinds/recognise.h"
#include "io/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <system_error>

namespace ridgeline::io {
namespace fs = std::filesystem;
namespace {

using enum FileGroup;

/// Names of the entries, sorted; empty for a folder that cannot be read.
std::vector<std::string> names_in(const fs::path& folder) {
  constexpr std::size_t kMaxNames = 100'000;
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error); !error && it != fs::end(it); it.increment(error)) {
    if (names.size() == kMaxNames) break;
    names.push_back(it->path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool holds_results(const fs::path& folder, const std::vector<std::string>& names) {
  return is_there(folder / "table2.json") ||
         std::ranges::any_of(names, [](const std::string& name) {
           return name.starts_with("evaluation.") && name.ends_with(".json");
         });
}

bool holds_colmap(const fs::path& folder) {
  return std::ranges::any_of(std::array{".bin", ".txt"}, [&](const std::string& ending) {
    return is_there(folder / ("cameras" + ending)) && is_there(folder / ("images" + ending));
  });
}

std::string counted(std::size_t n, const char* what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

/// Counts the contents of a folder by file extension: "2 clouds and 1 image"; empty if there are
/// none.
std::string contents(const std::vector<std::string>& names) {
  struct Count {
    FileGroup group;
    const char* what;
    std::size_t n = 0;
  };
  std::array counts{Count{kCloud, "cloud"}, Count{kLines, "line file"}, Count{kImage, "image"}};
  for (const std::string& name : names) {
    const FileGroup group =
        kind_by_extension(lower_case(fs::path(name).extension().string())).group;
    for (Count& count : counts) count.n += count.group == group ? 1 : 0;
  }
  std::string text;
  for (const Count& count : counts) {
    if (count.n > 0) text += (text.empty() ? "" : " and ") + counted(count.n, count.what);
  }
  return text;
}

FileKind kind_of_patches(const std::vector<std::string>& files) {
  const std::string what = files.size() == 1 ? "a folder with a patch file"
                                             : fmt::format("a folder of {} patches", files.size());
  return {.group = kPatchFolder,
          .what = what,
          .advice = fmt::format("give {}{} to run", files.front(), files.size() > 1 ? " ..." : "")};
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// The files of a folder that are an orientation. Files that their name shows to be clouds or
/// images are not opened.
std::vector<std::string> orientation_files_of(const fs::path& folder) {
  constexpr std::size_t kMaxOpened = 200;
  std::vector<std::string> files;
  std::size_t n_opened = 0;
  for (const std::string& name : names_in(folder)) {
    const FileGroup by_name =
        kind_by_extension(lower_case(fs::path(name).extension().string())).group;
    if (by_name == kImage || by_name == kCloud || is_folder(folder / name)) continue;
    if (++n_opened > kMaxOpened) break;
    const std::string path = (folder / name).string();
    if (kind_of_content(beginning_of(path), path).group == kOrientation) files.push_back(path);
  }
  return files;
}

/// The orientations of subfolders, by name.
std::vector<std::string> orientations_below(const fs::path& folder, int depth) {
  constexpr std::size_t kMaxFolders = 200;
  std::vector<std::string> found;
  std::size_t n_folders = 0;
  for (const std::string& name : names_in(folder)) {
    const fs::path inner = folder / name;
    if (!is_folder(inner)) continue;
    if (++n_folders > kMaxFolders) break;
    if (holds_colmap(inner)) found.push_back(inner.string());
    for (const std::string& file : names_in(inner)) {
      if (file == "reconstruction.json" || file.ends_with("_calibrated_camera_parameters.txt"))
        found.push_back((inner / file).string());
    }
    if (depth > 1)
      std::ranges::copy(orientations_below(inner, depth - 1), std::back_inserter(found));
  }
  return found;
}

/// A folder with orientations; unknown without.
FileKind kind_of_orientations(const fs::path& folder) {
  const std::vector<std::string> files = orientations_in(folder);
  if (files.empty()) return {};
  return {.group = kOrientationFolder,
          .what = files.size() == 1 ? "a folder with an orientation"
                                    : fmt::format("a folder with {} orientations", files.size()),
          .advice = fmt::format("name {} as orientation in a patch file", files.front())};
}

FileKind kind_of_contents(const std::vector<std::string>& names) {
  const std::string found = contents(names);
  if (found.empty())
    return {.group = kFolder, .what = names.empty() ? "an empty folder" : "a folder"};
  return {.group = kFolder,
          .what = "a folder with " + found,
          .advice = "give its files by name or pattern"};
}

}  // namespace

std::vector<std::string> patch_files_in(const fs::path& folder) {
  const auto patch_of = [](const fs::path& where) { return where / "patch.yaml"; };
  if (is_there(patch_of(folder))) return {patch_of(folder).string()};
  std::vector<std::string> files;
  for (const std::string& name : names_in(folder)) {
    if (is_there(patch_of(folder / name))) files.push_back(patch_of(folder / name).string());
  }
  return files;
}

std::string block_file_in(const fs::path& folder) { return (folder / "block.yaml").string(); }

std::vector<std::string> orientations_in(const fs::path& folder) {
  constexpr int kDepth = 2;
  std::vector<std::string> files = orientation_files_of(folder);
  return files.empty() ? orientations_below(folder, kDepth) : files;
}

FileKind kind_of_folder(const fs::path& folder) {
  const std::vector<std::string> names = names_in(folder);
  if (holds_results(folder, names)) {
    return {.group = kResultFolder,
            .what = "a results folder",
            .advice = info_of(kResultFolder).advice};
  }
  if (is_there(folder / "compare.json")) {
    return {.group = kOther, .what = "a comparison of results", .advice = "open its compare.md"};
  }
  if (const std::vector<std::string> patches = patch_files_in(folder); !patches.empty()) {
    return kind_of_patches(patches);
  }
  if (is_there(block_file_in(folder))) {
    return {.group = kBlockFolder,
            .what = "a folder with a block file",
            .advice = fmt::format("give {} to block", block_file_in(folder))};
  }
  const bool is_limap = std::ranges::any_of(names, [](const std::string& name) {
    return name.starts_with("track_") && name.ends_with(".txt");
  });
  if (is_limap) {
    return {.group = kLineFolder,
            .what = "a folder of LIMAP tracks",
            .advice = info_of(kLineFolder).advice};
  }
  if (holds_colmap(folder)) {
    return {.group = kOrientation,
            .what = "a COLMAP model",
            .advice = "name it as colmap in a patch file"};
  }
  if (lower_case(folder.extension().string()) == ".gdb") {
    return {.group = kOther,
            .what = "an Esri file geodatabase",
            .advice = "save its lines as GeoPackage"};
  }
  const FileKind orientations = kind_of_orientations(folder);
  return orientations.is_known() ? orientations : kind_of_contents(names);
}

}  // namespace ridgeline::io
