// SPDX-License-Identifier: BSD-3-Clause
// The documents name files of the sources: each must be there.
#include "tests/support/paths.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ridgeline {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::vector<fs::path> documents() {
  const fs::path root(test::source_dir());
  std::vector<fs::path> files{root / "README.md", root / "CONTRIBUTING.md"};
  for (const auto& entry : fs::directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  }
  return files;
}

/// Names of all source files.
std::set<std::string> source_names() {
  std::set<std::string> names;
  for (const char* const top : {"reconstruct", "evaluate", "io", "apps", "tests", "cmake"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(test::source_dir()) / top)) {
      if (entry.is_regular_file()) names.insert(entry.path().filename().string());
    }
  }
  return names;
}

TEST(DocumentedPaths, AreThere) {
  static const std::regex path(
      "(?:^|[^A-Za-z0-9_/.])((?:reconstruct|evaluate|io|apps|tests|cmake|sample_data|docs)/"
      "[A-Za-z0-9_./"
      "-]*[A-Za-z0-9_])");
  int n_paths = 0;
  for (const fs::path& document : documents()) {
    const std::string text = text_of(document);
    for (std::sregex_iterator it(text.begin(), text.end(), path), end; it != end; ++it) {
      ++n_paths;
      EXPECT_TRUE(fs::exists(fs::path(test::source_dir()) / (*it)[1].str()))
          << document << " names " << (*it)[1];
    }
  }
  EXPECT_GT(n_paths, 50);
}

TEST(DocumentedPaths, NamesOfHeadersAreThoseOfFiles) {
  static const std::regex name("\\b([a-z0-9_]+\\.(?:h|cpp))\\b");
  const std::set<std::string> known = source_names();
  for (const fs::path& document : documents()) {
    const std::string text = text_of(document);
    for (std::sregex_iterator it(text.begin(), text.end(), name), end; it != end; ++it) {
      EXPECT_TRUE(known.contains((*it)[1])) << document << " names " << it->str();
    }
  }
}

}  // namespace
}  // namespace ridgeline
