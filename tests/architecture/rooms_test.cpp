// SPDX-License-Identifier: BSD-3-Clause
// Each folder includes only what the table of docs/architecture.md allows it.
#include "tests/support/paths.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace ridgeline {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

fs::path root() { return test::source_dir(); }

/// The words in backticks of a cell.
Paths names_in(const std::string& cell) {
  static const std::regex name("`([^`]+)`");
  Paths names;
  for (std::sregex_iterator it(cell.begin(), cell.end(), name), end; it != end; ++it) {
    names.push_back((*it)[1]);
  }
  return names;
}

/// A name of a row is a path from the root, or else that of a neighbour of its folder.
std::string path_of(const std::string& name, const std::string& folder) {
  if (fs::exists(root() / name)) return name;
  return folder.substr(0, folder.find('/') + 1) + name;
}

/// The table of docs/architecture.md: by folder, what its files may include besides the folder.
std::map<std::string, Paths> allowed() {
  static const std::regex row(R"(\| `((?:reconstruct|evaluate|io|apps)/[\w*]+)` \|.*\|([^|]*)\|)");
  std::ifstream document(root() / "docs/architecture.md");
  std::map<std::string, Paths> folders;
  for (std::string line; std::getline(document, line);) {
    std::smatch cells;
    if (!std::regex_match(line, cells, row)) continue;
    Paths& paths = folders[cells[1]];
    for (const std::string& name : names_in(cells[2])) paths.push_back(path_of(name, cells[1]));
  }
  return folders;
}

Paths includes_of(const fs::path& file) {
  static const std::regex include("^#include \"((reconstruct|evaluate|io|apps|tests)/[^\"]+)\"");
  std::ifstream stream(file);
  Paths found;
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, include)) found.push_back(match[1]);
  }
  return found;
}

bool is_in(const std::string& included, const std::string& folder) {
  return included == folder || included.starts_with(folder + "/");
}

/// The sources of a folder and of those in it.
std::vector<fs::path> sources_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
  }
  return files;
}

TEST(Rooms, IncludeOnlyWhatTheTableAllows) {
  const std::map<std::string, Paths> rules = allowed();
  std::size_t n_files = 0;
  for (const char* const top : {"reconstruct", "evaluate", "io", "apps"}) {
    for (const auto& entry : fs::directory_iterator(root() / top)) {
      if (!entry.is_directory()) continue;
      const std::string room = std::string(top) + "/" + entry.path().filename().string();
      const bool is_command = std::string(top) == "apps" && !rules.contains(room);
      const auto rule = rules.find(is_command ? "apps/*" : room);
      ASSERT_TRUE(rule != rules.end()) << room << " has no row";
      for (const fs::path& file : sources_in(entry.path())) {
        ++n_files;
        for (const std::string& included : includes_of(file)) {
          EXPECT_TRUE(is_in(included, room) || std::ranges::any_of(rule->second,
                                                                   [&](const std::string& other) {
                                                                     return is_in(included, other);
                                                                   }))
              << file << " includes " << included;
        }
      }
    }
  }
  EXPECT_GT(n_files, 600);
}

TEST(Rooms, OfTheTableAreThere) {
  for (const auto& [room, others] : allowed()) {
    EXPECT_TRUE(room == "apps/*" || fs::exists(root() / room)) << room;
    for (const std::string& other : others) EXPECT_TRUE(fs::exists(root() / other)) << other;
  }
}

TEST(Papers, NeverIncludeWhatGoesBeyondThem) {
  std::size_t n_files = 0;
  for (const fs::path& file : sources_in(root() / "reconstruct")) {
    const std::string path = file.string();
    if (path.find("/ok2011/") == std::string::npos &&
        path.find("/chio_wang2000/") == std::string::npos) {
      continue;
    }
    ++n_files;
    for (const std::string& included : includes_of(file)) {
      EXPECT_EQ(included.find("/beyond/"), std::string::npos) << file << " includes " << included;
      EXPECT_FALSE(is_in(included, "reconstruct/surface")) << file << " includes " << included;
    }
  }
  EXPECT_GT(n_files, 50U);
}

}  // namespace
}  // namespace ridgeline
