// SPDX-License-Identifier: BSD-3-Clause
// What docs/architecture.md says that io may include, read from its sources.
#include "tests/support/paths.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace ridgeline {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::Not;
using ::testing::StartsWith;

TEST(Rooms, ReadersAndWritersKnowNoJudge) {
  const fs::path io = fs::path(test::source_dir()) / "io";
  int n_files = 0;
  for (auto it = fs::recursive_directory_iterator(io); it != fs::end(it); ++it) {
    if (it->path() == io / "results") it.disable_recursion_pending();
    if (!it->is_regular_file()) continue;
    ++n_files;
    std::ifstream file(it->path());
    for (std::string line; std::getline(file, line);) {
      EXPECT_THAT(line, Not(AnyOf(StartsWith("#include \"io/results/"),
                                  StartsWith("#include \"evaluate/"))))
          << it->path();
    }
  }
  EXPECT_GT(n_files, 100);
}

}  // namespace
}  // namespace ridgeline
