// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/cli/cli_fixture.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::cli {

/// Runs the small patch, by the papers' methods unless the arguments name others.
class RunPatch : public SmallPatch {
 protected:
  [[nodiscard]] ProgramResult run_patch(const std::string& out,
                                        const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"run", "patch/patch.yaml", "--out", out};
    if (std::ranges::find(more, "--methods") == more.end())
      arguments.insert(arguments.end(), {"--methods", "direct,joint"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /// Takes a key and what hangs on it out of the patch file.
  void remove_line(std::string_view key) const {
    const std::string text = read(path("patch/patch.yaml"));
    const std::size_t begin = text.find(std::string(key) + ":");
    ASSERT_NE(begin, std::string::npos) << key;
    std::string rest = text.substr(text.find('\n', begin) + 1);
    while (rest.starts_with(" ") || rest.starts_with("-")) rest.erase(0, rest.find('\n') + 1);
    write(path("patch/patch.yaml"), text.substr(0, begin) + rest);
  }
};

/// Runs sample patch 1, whose lines are of every kind.
class RunSample : public RunPatch {
 protected:
  RunSample() {
    std::filesystem::remove_all(path("patch"));
    std::filesystem::copy(std::filesystem::path(test::source_dir()) / "sample_data/1",
                          path("patch"));
  }
};

}  // namespace ridgeline::cli
