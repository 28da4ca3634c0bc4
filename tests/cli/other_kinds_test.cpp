// SPDX-License-Identifier: BSD-3-Clause
// Every command and option names a file that was meant for another one.
#include "tests/cli/cli_fixture.h"

#include <sys/stat.h>

namespace ridgeline::cli {
namespace {

using ::testing::HasSubstr;

class OtherKinds : public Cli {
 protected:
  OtherKinds() {
    write(path("gates.yaml"), "gates: [{metric: rms_m, class: total, max: 10}]\n");
    write(path("judge.yaml"), "judge: {seed: 1}\n");
    write(path("page.html"), "<!DOCTYPE html>");
  }
};

TEST_F(OtherKinds, AreNamedWhereAPatchFileIsExpected) {
  const auto is_refused = [&](std::vector<std::string> arguments, const std::string& what) {
    arguments.insert(arguments.end(), {"--out", "new.csv"});
    EXPECT_REFUSED(run(arguments), HasSubstr(what + ", not a patch file (patch.yaml); "));
  };
  for (const char* const command : {"run", "match", "reconstruct"}) {
    is_refused({command, "scene/lidar.las"}, "scene/lidar.las: is a LAS point cloud");
    is_refused({command, "gates.yaml"}, "gates.yaml: is a gates file");
    is_refused({command, "scene/truth.geojson"}, "scene/truth.geojson: is GeoJSON");
  }
  EXPECT_REFUSED(evaluate("scene/lines.good.geojson", "out", {"--patch", "judge.yaml"}),
                 HasSubstr("judge.yaml: is a config file, not a patch file"));
}

TEST_F(OtherKinds, AreNamedByTheOptionsOfEvaluate) {
  EXPECT_REFUSED(evaluate("scene/lidar.las", "out"),
                 HasSubstr("is a LAS point cloud, not a file of 3D lines; give it as --cloud"));
  EXPECT_REFUSED(evaluate("page.html", "out"), HasSubstr("is a web page, perhaps from a failed"));
  EXPECT_REFUSED(evaluate("scene/lines.good.geojson", "out", {"--config", "gates.yaml"}),
                 HasSubstr("is a gates file, not a config file; give it as --gates"));
  EXPECT_REFUSED(evaluate("scene/lines.good.geojson", "out", {"--reference-lines", "judge.yaml"}),
                 HasSubstr("is a config file, not a file of 3D lines"));
  EXPECT_REFUSED(run({"evaluate", "--lines", "scene/lines.good.geojson", "--cloud",
                      "scene/truth.geojson", "--out", "out"}),
                 HasSubstr("is GeoJSON, not a point cloud; give it as --lines"));
}

TEST_F(OtherKinds, AreNamedWhereResultsAreExpected) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out", {"--no-report"}).exit_code, 0);
  EXPECT_REFUSED(run({"gate", "out", "--gates", "judge.yaml"}),
                 HasSubstr("is a config file, not a gates file; give it as --config"));
  EXPECT_REFUSED(run({"gate", "out", "--gates", "out"}),
                 HasSubstr("out: is a results folder, not a gates file"));
  for (const char* const command : {"compare", "report"}) {
    EXPECT_REFUSED(
        run({command, "out/run.json"}),
        HasSubstr("is the record of a run (run.json), not a results folder; give its folder"));
    EXPECT_REFUSED(run({command, "scene"}),
                   HasSubstr("it is a folder with 1 cloud and 4 line files"));
  }
}

TEST_F(OtherKinds, AreNamedWhereAnImageIsExpected) {
  EXPECT_REFUSED(run({"extract", "scene/lidar.las", "--out", "s.csv"}),
                 HasSubstr("is a LAS point cloud, not an image"));
}

TEST_F(OtherKinds, OfHugeFilesAreNotReadWhole) {
  write(path("huge.las"), "LASF");
  std::filesystem::resize_file(path("huge.las"), std::uintmax_t{1} << 40U);  // the file is sparse
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", "huge.las", "--out", "out"},
        {"gate", "scene", "--gates", "huge.las"},
        {"evaluate", "--lines", "huge.las", "--cloud", "scene/lidar.las", "--out", "out"}}) {
    EXPECT_REFUSED(run(arguments), HasSubstr("huge.las: is a LAS point cloud, not a"));
  }
}

TEST_F(OtherKinds, OfPipesAreNeverOpened) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_REFUSED(run({"info", "pipe"}), HasSubstr("pipe: is a device, pipe or socket"));
  EXPECT_REFUSED(run({"run", "pipe", "--out", "out"}),
                 HasSubstr("pipe: is a device, pipe or socket"));
}

}  // namespace
}  // namespace ridgeline::cli
