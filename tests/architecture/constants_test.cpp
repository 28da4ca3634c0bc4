// SPDX-License-Identifier: BSD-3-Clause
// Sources are compiled together (unity builds): a constant of an unnamed namespace would silently
// take the place of one of a header with the same name in every source behind it.
#include "tests/support/paths.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>

namespace ridgeline {
namespace {

namespace fs = std::filesystem;

/// The constants at namespace scope of all files with an extension, each with a file that has it.
std::map<std::string, std::string> constants_in(const std::string& extension) {
  static const std::regex constant(R"(^(?:inline )?constexpr [^=({;]*\b(k[A-Z]\w*)\s*[={])");
  std::map<std::string, std::string> found;
  for (const char* folder : {"reconstruct", "evaluate", "io", "apps"}) {
    const fs::path path = fs::path(test::source_dir()) / folder;
    for (const auto& entry : fs::recursive_directory_iterator(path)) {
      if (entry.path().extension() != extension) continue;
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        std::smatch name;
        if (std::regex_search(line, name, constant)) found[name[1]] = entry.path().string();
      }
    }
  }
  return found;
}

TEST(Constants, OfHeadersHaveNamesOfTheirOwn) {
  const auto of_headers = constants_in(".h");
  const auto of_sources = constants_in(".cpp");
  EXPECT_GT(of_headers.size(), 50U);
  EXPECT_GT(of_sources.size(), 300U);
  for (const auto& [name, header] : of_headers) {
    const auto same = of_sources.find(name);
    EXPECT_TRUE(same == of_sources.end()) << name << " of " << header << " is also in "
                                          << (same == of_sources.end() ? "" : same->second);
  }
}

}  // namespace
}  // namespace ridgeline
