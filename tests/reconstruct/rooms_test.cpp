// SPDX-License-Identifier: BSD-3-Clause
// Which room of `reconstruct` may include which: the papers never see what goes beyond them, and nothing sees the
// method as a whole.
#include "tests/support/paths.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace ridgeline {
namespace {

namespace fs = std::filesystem;

/// What the files of a room may include of `reconstruct` beside the room itself.
const std::map<std::string, std::vector<std::string>>& allowed() {
  static const std::map<std::string, std::vector<std::string>> rooms{
      {"geometry", {}},
      {"views", {"geometry"}},
      {"ok2011", {"geometry", "views"}},
      {"chio_wang2000", {"geometry", "views"}},
      {"beyond", {"geometry", "views", "ok2011", "chio_wang2000"}},
      {"pair_check", {"geometry"}}};
  return rooms;
}

std::vector<std::string> includes_of(const fs::path& file) {
  static const std::regex include("#include \"([^\"]+)\"");
  std::ifstream stream(file);
  std::vector<std::string> found;
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, include)) found.push_back(match[1]);
  }
  return found;
}

bool is_allowed(const std::string& included, const std::string& room) {
  if (included.starts_with("reconstruct/" + room + "/")) return true;
  for (const std::string& other : allowed().at(room)) {
    if (included.starts_with("reconstruct/" + other + "/")) return true;
  }
  return false;
}

TEST(Rooms, IncludeOnlyWhatTheyMay) {
  const fs::path root = fs::path(test::source_dir()) / "reconstruct";
  int n_files = 0;
  for (const auto& [room, others] : allowed()) {
    for (const auto& entry : fs::recursive_directory_iterator(root / room)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      ++n_files;
      for (const std::string& included : includes_of(entry.path())) {
        EXPECT_TRUE(is_allowed(included, room)) << entry.path() << " includes " << included;
      }
    }
  }
  EXPECT_GT(n_files, 100);
}

TEST(Rooms, AreAllThereIs) {
  for (const auto& entry : fs::directory_iterator(fs::path(test::source_dir()) / "reconstruct")) {
    if (!entry.is_directory()) continue;
    EXPECT_TRUE(allowed().contains(entry.path().filename())) << entry.path();
  }
}

}  // namespace
}  // namespace ridgeline
