// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/support/run_program.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::cli {

using test::ProgramResult;

/// Whole content of a file; a missing file is a failure of the test.
std::string read(const std::filesystem::path& file);
void write(const std::filesystem::path& file, std::string_view content);
nlohmann::json read_json(const std::filesystem::path& file);
/// Names of a folder's entries, sorted.
std::vector<std::string> names_in(const std::filesystem::path& folder);
/// The folder of real data that stands beside the checkout, or nothing.
std::filesystem::path shared_data(std::string_view folder);

/// True if stderr is one line that begins `ridgeline: ` and the exit code is 1.
testing::AssertionResult is_refusal(const ProgramResult& result);
#define EXPECT_REFUSED(result, matcher)                   \
  do {                                                    \
    const ::ridgeline::cli::ProgramResult& r_ = (result); \
    EXPECT_TRUE(::ridgeline::cli::is_refusal(r_));        \
    EXPECT_THAT(r_.err, matcher);                         \
  } while (false)

/// Runs the program in a temporary folder. `scene/` in it is a simulated village, made once for all
/// tests of a suite: lidar.las, truth.geojson, lines.{good,fair,poor}.geojson.
class Cli : public testing::Test {
 protected:
  Cli();
  ~Cli() override;

  static void SetUpTestSuite();
  static void TearDownTestSuite();

  [[nodiscard]] ProgramResult run(const std::vector<std::string>& arguments,
                                  const std::vector<std::string>& environment = {}) const;
  /// Judges a line file of the folder against the scene's cloud into `out`.
  [[nodiscard]] ProgramResult evaluate(const std::string& lines,
                                       const std::string& out,
                                       const std::vector<std::string>& more = {}) const;
  [[nodiscard]] std::filesystem::path path(std::string_view name) const { return folder_ / name; }

  /// Hashes of all files of a result folder but the run's record, hidden ones too, by relative
  /// name.
  [[nodiscard]] std::map<std::string, std::string> results_in(const std::string& folder) const;

  /// The data that a report.html shows.
  [[nodiscard]] nlohmann::json data_of(const std::string& report) const;

 private:
  std::filesystem::path folder_;
};

/// A fixture with a patch of the id 1 in `patch/`: a small village, since many of its tests run it
/// several times. The program makes it once for all tests.
class SmallPatch : public Cli {
 protected:
  SmallPatch();

  /// Replaces what stands in the patch file; a failure if it does not stand there.
  void edit_patch(std::string_view from, std::string_view to) const;
};

/// A fixture with a small rendered pair in `pair/`, made in each test that needs it.
class SmallPair : public Cli {
 protected:
  void SetUp() override {
    const ProgramResult made =
        run({"simulate", "--out", "pair", "--seed", "3", "--extent-m", "45,45",
             "--samples-per-side", "1", "--focal-length-px", "7000"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
};

}  // namespace ridgeline::cli
