// SPDX-License-Identifier: BSD-3-Clause
// A cloud in tiles, and lines in batches, give the bytes that the whole cloud gives at once.
#include "tests/cli/cli_fixture.h"
#include "tests/support/cut_cloud.h"

namespace ridgeline::cli {
namespace {

using ::testing::HasSubstr;

const std::string kOrigin = "513000,5403000,200";

class EvaluateTiles : public Cli {
 protected:
  /// Cuts the scene's cloud at whole multiples of `tile_m` into FOLDER/COLUMN_ROW.las; houses and
  /// their lines lie across the cuts.
  void cut(double tile_m, const std::string& folder) const {
    test::cut_cloud(path("scene/lidar.las"), path(folder), tile_m);
  }

  /// Judges the true lines and those of a tool.
  void judge(const std::string& cloud,
             const std::string& out,
             const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"evaluate",
                                       "--lines",
                                       "scene/truth.geojson",
                                       "scene/lines.fair.geojson",
                                       "--cloud",
                                       cloud,
                                       "--origin",
                                       kOrigin,
                                       "--out",
                                       out,
                                       "--no-report"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }

  void expect_same_results(const std::string& a, const std::string& b) const {
    for (const char* name :
         {"evaluation.truth.json", "evaluation.lines.fair.json", "table2.csv", "tolerances.csv"}) {
      EXPECT_EQ(read(path(a) / name), read(path(b) / name)) << name;
    }
  }
};

TEST_F(EvaluateTiles, GivesTheBytesOfTheWholeCloud) {
  cut(17.0, "tiles");
  ASSERT_GT(names_in(path("tiles")).size(), 10U);
  cut(1e6, "one_file/tiles");  // results are named after the folder
  judge("one_file/tiles/*.las", "whole");
  judge("tiles/*.las", "tiled");
  expect_same_results("whole", "tiled");
}

TEST_F(EvaluateTiles, GivesTheSameBytesInBatchesThatFitTheMemory) {
  cut(17.0, "tiles");
  cut(1e6, "one_file/tiles");  // results are named after the folder
  judge("one_file/tiles/*.las", "whole");
  judge("tiles/*.las", "batches", {"--cloud-memory-mib", "1"});
  EXPECT_GT(read_json(path("batches/run.json"))["cloud"]["n_batches"], 1);
  EXPECT_EQ(read_json(path("whole/run.json"))["cloud"]["n_batches"], 1);
  expect_same_results("whole", "batches");
}

TEST_F(EvaluateTiles, ReadsOnlyTheTilesThatLinesTouch) {
  cut(17.0, "tiles");
  write(path("one.csv"), "x1,y1,z1,x2,y2,z2\n513030,5403030,251,513035,5403032,251\n");
  const ProgramResult result = run({"evaluate", "--lines", "one.csv", "--cloud", "tiles/*.las",
                                    "--origin", kOrigin, "--out", "out", "--no-report"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json record = read_json(path("out/run.json"));
  const std::size_t n_tiles = names_in(path("tiles")).size();
  std::size_t n_inputs = 0;
  for (const auto& input : record["inputs"]) n_inputs += input["role"] == "cloud" ? 1 : 0;
  EXPECT_LE(n_inputs, 6U);
  EXPECT_EQ(record["cloud"]["n_files_unread"], n_tiles - n_inputs);
}

}  // namespace
}  // namespace ridgeline::cli
