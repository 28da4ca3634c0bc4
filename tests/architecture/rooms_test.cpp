// SPDX-License-Identifier: BSD-3-Clause
// Which folder may include which, read from the sources: docs/architecture.md says why.
#include "tests/support/paths.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace ridgeline {
namespace {

namespace fs = std::filesystem;
using Folders = std::vector<std::string>;

/// The name of a list of folders stands for all of them.
const std::map<std::string, Folders>& lists() {
  static const std::map<std::string, Folders> lists{
      {"<readers>",
       {"io/error.h", "io/text", "io/kinds", "io/files", "io/crs", "io/gdal", "io/images",
        "io/orientation", "io/project", "io/cloud", "io/lines", "io/models"}},
      {"<judge>", {"evaluate", "io/results"}},
      {"<method>", {"reconstruct"}}};
  return lists;
}

/// What the files of a folder may include beside the folder itself. The papers never see what goes
/// beyond them; the judge never sees the judged, nor a reader the judge; Python links no command
/// line.
const std::map<std::string, Folders>& allowed() {
  static const std::map<std::string, Folders> folders{
      {"reconstruct/geometry", {}},
      {"reconstruct/views", {"reconstruct/geometry"}},
      {"reconstruct/tracks", {"reconstruct/geometry", "reconstruct/views"}},
      {"reconstruct/ok2011", {"reconstruct/geometry", "reconstruct/views"}},
      {"reconstruct/chio_wang2000", {"reconstruct/geometry", "reconstruct/views"}},
      {"reconstruct/beyond",
       {"reconstruct/geometry", "reconstruct/views", "reconstruct/ok2011",
        "reconstruct/chio_wang2000"}},
      {"reconstruct/pair_check", {"reconstruct/geometry"}},
      {"reconstruct/block", {"reconstruct/geometry"}},
      {"evaluate/judge",
       {"reconstruct/geometry", "evaluate/line_evaluation.h", "evaluate/probability.h"}},
      {"evaluate/faces",
       {"reconstruct/geometry", "evaluate/line_evaluation.h", "evaluate/probability.h",
        "evaluate/judge", "evaluate/statistics/distribution.h", "evaluate/tables/format.h"}},
      {"evaluate/statistics",
       {"reconstruct/geometry", "evaluate/line_evaluation.h", "evaluate/probability.h",
        "evaluate/judge/options.h", "evaluate/judge/judge_line.h",
        "evaluate/judge/segment_plane.h"}},
      {"evaluate/matching", {"reconstruct/geometry", "evaluate/statistics"}},
      {"evaluate/tables", {"reconstruct/geometry", "evaluate/statistics"}},
      {"evaluate/gates", {"reconstruct/geometry", "evaluate/statistics", "evaluate/tables"}},
      {"evaluate/compare",
       {"reconstruct/geometry", "evaluate/probability.h", "evaluate/statistics",
        "evaluate/tables"}},
      {"io/text", {"reconstruct/geometry", "io/error.h"}},
      {"io/kinds", {"io/error.h", "io/text"}},
      {"io/files", {"io/error.h", "io/text", "io/kinds"}},
      {"io/crs", {"reconstruct/geometry", "io/error.h"}},
      {"io/gdal", {"io/error.h", "io/text", "io/files", "io/crs"}},
      {"io/images", {"reconstruct/geometry", "io/error.h", "io/kinds", "io/files", "io/gdal"}},
      {"io/orientation",
       {"reconstruct/geometry", "io/error.h", "io/text", "io/kinds", "io/files", "io/crs",
        "io/gdal"}},
      {"io/project",
       {"reconstruct/geometry", "io/error.h", "io/text", "io/files", "io/crs", "io/gdal",
        "io/images", "io/orientation"}},
      {"io/cloud",
       {"reconstruct/geometry", "io/error.h", "io/text", "io/kinds", "io/files", "io/crs"}},
      {"io/models",
       {"reconstruct/geometry", "io/error.h", "io/text", "io/kinds", "io/files", "io/crs",
        "io/gdal"}},
      {"io/lines",
       {"reconstruct/geometry", "io/error.h", "io/text", "io/kinds", "io/files", "io/crs",
        "io/gdal", "io/cloud", "io/models"}},
      {"io/results", {"reconstruct/geometry", "evaluate", "<readers>"}},
      {"apps/pipeline", {"<method>", "<judge>", "<readers>"}},
      {"apps/common", {"apps/pipeline", "<method>", "<judge>", "<readers>"}},
      {"apps/python", {"apps/pipeline", "<method>", "<judge>", "<readers>"}},
      {"apps/block",
       {"apps/common", "apps/pipeline", "apps/run", "apps/report", "apps/evaluate", "<method>",
        "<judge>", "<readers>"}},
      {"apps/report",
       {"apps/common", "apps/pipeline", "reconstruct/geometry", "<judge>", "<readers>"}},
      {"apps/simulate", {"apps/common", "reconstruct/geometry", "<judge>", "<readers>"}}};
  return folders;
}

/// Of a folder of `apps` that is not in allowed(): a command. Those that run a patch and write its
/// report use these two.
const Folders& allowed_to_commands() {
  static const Folders folders{"apps/common", "apps/pipeline", "apps/run", "apps/report",
                               "<method>",    "<judge>",       "<readers>"};
  return folders;
}

Folders includes_of(const fs::path& file) {
  static const std::regex include("^#include \"((reconstruct|evaluate|io|apps|tests)/[^\"]+)\"");
  std::ifstream stream(file);
  Folders found;
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, include)) found.push_back(match[1]);
  }
  return found;
}

bool is_in(const std::string& included, const std::string& folder) {
  if (const auto list = lists().find(folder); list != lists().end()) {
    return std::ranges::any_of(list->second,
                               [&](const std::string& one) { return is_in(included, one); });
  }
  return included == folder || included.starts_with(folder + "/");
}

/// Checks all files of a folder; returns their number.
int check_folder(const std::string& folder, const Folders& others) {
  int n_files = 0;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(test::source_dir()) / folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    ++n_files;
    for (const std::string& included : includes_of(entry.path())) {
      const bool may =
          is_in(included, folder) || std::ranges::any_of(others, [&](const std::string& other) {
            return is_in(included, other);
          });
      EXPECT_TRUE(may) << entry.path() << " includes " << included;
    }
  }
  return n_files;
}

TEST(Rooms, IncludeOnlyWhatTheyMay) {
  int n_files = 0;
  for (const char* const top : {"reconstruct", "evaluate", "io", "apps"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(test::source_dir()) / top)) {
      if (!entry.is_directory()) continue;
      const std::string room = std::string(top) + "/" + entry.path().filename().string();
      const auto rule = allowed().find(room);
      const bool is_command = rule == allowed().end();
      EXPECT_TRUE(!is_command || std::string(top) == "apps") << room << " has no rule";
      n_files += check_folder(room, is_command ? allowed_to_commands() : rule->second);
    }
  }
  EXPECT_GT(n_files, 600);
}

TEST(Rooms, ThatHaveARuleAreThere) {
  for (const auto& [room, others] : allowed()) {
    EXPECT_TRUE(fs::is_directory(fs::path(test::source_dir()) / room)) << room;
  }
}

}  // namespace
}  // namespace ridgeline
