// SPDX-License-Identifier: BSD-3-Clause
// Files named by an option: those that the program wrote before are replaced, others are refused.
#include "tests/cli/cli_fixture.h"

#include <utility>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class OwnFiles : public SmallPatch {
 protected:
  /// Expects that the command writes its output `file` a second time, but not over what a user has there.
  void expect_only_own_is_replaced(const std::vector<std::string>& arguments,
                                   const std::string& file,
                                   const std::string& of_user) const {
    SCOPED_TRACE(file);
    for (int i = 0; i < 2; ++i) {
      const ProgramResult result = run(arguments);
      EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    write(path(file), of_user);
    EXPECT_REFUSED(run(arguments), AllOf(HasSubstr(file), HasSubstr("would be written over")));
    EXPECT_EQ(read(path(file)), of_user);
    fs::remove(path(file));
  }
};

TEST_F(OwnFiles, ReportsOfGate) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "results", {"--no-report"}).exit_code, 0);
  write(path("gates.yaml"), "gates: [{metric: rms_m, class: total, max: 10}]\n");
  for (const auto& [option, of_user] :
       {std::pair("--junit", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"x\">"),
        std::pair("--summary", "# Notes\n"), std::pair("--json", "{\"passed\": \"mine\"}")}) {
    expect_only_own_is_replaced({"gate", "results", "--gates", "gates.yaml", option, "file"},
                                "file", of_user);
  }
}

TEST_F(OwnFiles, TablesAndPicturesOfTheStages) {
  const std::string photo = read(path("patch/left.tif"));
  expect_only_own_is_replaced({"extract", "patch/left.tif", "--out", "s.csv", "--overlay", "s.png"},
                              "s.csv", "id,mine\n");
  expect_only_own_is_replaced({"extract", "patch/left.tif", "--out", "s.csv", "--overlay", "s.png"},
                              "s.png", photo);
  expect_only_own_is_replaced(
      {"match", "patch/patch.yaml", "--out", "m.csv", "--matcher", "chio", "--provenance", "p.csv"},
      "m.csv", "left_id,right_id\n");
  expect_only_own_is_replaced(
      {"match", "patch/patch.yaml", "--out", "m.csv", "--matcher", "chio", "--provenance", "p.csv"},
      "p.csv", "left_id,right_id\n");
  expect_only_own_is_replaced({"match", "patch/patch.yaml", "--out", "m.csv", "--segments", "seen"},
                              "seen/segments.left.csv", "id,mine\n");
}

TEST_F(OwnFiles, PointsOfTheSurface) {
  expect_only_own_is_replaced({"reconstruct", "patch/patch.yaml", "--out", "lines.geojson",
                               "--write-surface", "surface.las"},
                              "surface.las", "LASF of another program");
}

TEST_F(OwnFiles, LinesOfReconstruct) {
  ASSERT_EQ(run({"match", "patch/patch.yaml", "--out", "m.csv"}).exit_code, 0);
  const auto reconstruct = [](const std::string& format) {
    return std::vector<std::string>{
        "reconstruct", "patch/patch.yaml", "--matches", "m.csv", "--out", "l", "--format", format};
  };
  for (const char* format : {"geojson", "csv", "obj", "ply"}) {
    expect_only_own_is_replaced(reconstruct(format), "l", "0 0 0\n");
  }
  // GDAL's formats do not tell who wrote them
  ASSERT_EQ(run(reconstruct("dxf")).exit_code, 0);
  EXPECT_REFUSED(run(reconstruct("dxf")), HasSubstr("would be written over"));
}

}  // namespace
}  // namespace ridgeline::cli
