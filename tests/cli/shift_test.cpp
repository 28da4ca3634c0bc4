// SPDX-License-Identifier: BSD-3-Clause
// A shift that all lines have against the LIDAR planes: reported with its interval, and taken away
// only with --apply-shift.
#include "io/cloud/las_writer.h"
#include "io/cloud/read_cloud.h"
#include "tests/cli/run_fixture.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace ridgeline::cli {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

using Shift = std::array<double, 3>;

class ShiftedLines : public Cli {
 protected:
  /// Writes the lines of a GeoJSON file, moved by (x, y, z) metres.
  void write_moved(const std::string& from, const Shift& by_m, const std::string& to) const {
    json lines = read_json(path(from));
    for (json& feature : lines["features"]) {
      for (json& x : feature["geometry"]["coordinates"]) {
        for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = x[axis].get<double>() + by_m[axis];
      }
    }
    write(path(to), lines.dump());
  }
};

TEST_F(ShiftedLines, OfVillagesAreReportedToFiveCentimetres) {
  if (test::kIsSanitized)
    GTEST_SKIP() << "figures, which sanitizers do not change; the next test runs the code";
  constexpr double kShift_m = 0.3;
  constexpr double kTolerance_m = 0.05;
  constexpr std::array<Shift, 4> kShifts{Shift{}, Shift{kShift_m, 0.0, 0.0},
                                         Shift{0.0, kShift_m, 0.0}, Shift{0.0, 0.0, kShift_m}};
  int n_held = 0;
  for (const char* const seed : {"301", "302", "303"}) {
    ASSERT_EQ(run({"simulate", "--no-images", "--seed", seed, "--out", seed}).exit_code, 0);
    std::vector<std::string> arguments{
        "evaluate", "--cloud",     fmt::format("{}/lidar.las", seed), "--out",
        "out",      "--no-report", "--bootstrap-replicates",          "1",
        "--lines"};
    for (std::size_t i = 0; i < kShifts.size(); ++i) {
      arguments.push_back(fmt::format("{}.geojson", i));
      write_moved(fmt::format("{}/lines.good.geojson", seed), kShifts[i], arguments.back());
    }
    const ProgramResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (std::size_t i = 0; i < kShifts.size(); ++i) {
      const json shift = read_json(path(fmt::format("out/evaluation.{}.json", i)))["shift"];
      EXPECT_EQ(shift["significant"], i > 0) << seed << " " << shift["axes"];
      EXPECT_EQ(result.out.find(fmt::format(": {}: all lines are shifted", i)) != std::string::npos,
                i > 0);
      if (i == 0) continue;
      const json axis = shift["axes"][std::array{"x", "y", "z"}[i - 1]];
      EXPECT_NEAR(axis["shift_m"].get<double>(), kShift_m, kTolerance_m) << seed;
      n_held += axis["ci95_m"][0] <= kShift_m && kShift_m <= axis["ci95_m"][1] ? 1 : 0;
    }
  }
  EXPECT_GE(n_held, 7) << "of 9; 95 % intervals";
}

TEST_F(ShiftedLines, AreMovedOnRequestAndEverythingSaysSo) {
  // roofs in two directions, which the village of the other tests lacks
  ASSERT_EQ(run({"simulate", "--no-images", "--seed", "41", "--out", "scene"}).exit_code, 0);
  write_moved("scene/lines.good.geojson", {0.3, 0.0, 0.4}, "moved.geojson");
  const std::string given = read(path("moved.geojson"));
  const ProgramResult as_given = evaluate("moved.geojson", "as_given");
  ASSERT_EQ(as_given.exit_code, 0) << as_given.err;
  EXPECT_THAT(as_given.out,
              HasSubstr("Figures include it; --apply-shift judges the lines without it."));
  const ProgramResult result = evaluate("moved.geojson", "out", {"--apply-shift"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read(path("moved.geojson")), given);
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "unmoved").exit_code, 0);

  const auto rms_in = [&](const char* folder, const char* name) {
    return read_json(path(
        fmt::format("{}/evaluation.{}.json", folder, name)))["summary"]["total"]["rms_m"]
        .get<double>();
  };
  constexpr double kAlike_m = 0.01;  // what the errors of the lines leave of the shift
  EXPECT_NEAR(rms_in("out", "moved"), rms_in("unmoved", "lines.good"), kAlike_m);
  EXPECT_GT(rms_in("as_given", "moved"), 0.3);

  const json shift = read_json(path("out/evaluation.moved.json"))["shift"];
  EXPECT_TRUE(shift["applied"]);
  EXPECT_THAT(result.out, AllOf(HasSubstr("the lines were moved by x -0."),
                                HasSubstr("They were moved against it")));
  for (const char* const file :
       {"table2.md", "table2.tex", "table2.json", "table2.csv", "tolerances.md",
        "evaluation.moved.csv", "accuracy.moved.md", "run.json", "report.html"}) {
    EXPECT_THAT(read(path(std::string("out/") + file)), HasSubstr("moved")) << file;
  }
  EXPECT_THAT(read(path("out/judged.moved.gpkg")), HasSubstr("moved_x_m"));
  EXPECT_THAT(read(path("as_given/judged.moved.gpkg")), Not(HasSubstr("moved_x_m")));
}

TEST_F(ShiftedLines, WithoutAShiftKeepTheirTablesToTheByte) {
  const ProgramResult without = evaluate("scene/lines.good.geojson", "without");
  const ProgramResult with = evaluate("scene/lines.good.geojson", "with", {"--apply-shift"});
  ASSERT_EQ(with.exit_code, 0) << with.err;
  EXPECT_THAT(without.out, Not(HasSubstr("shifted")));
  EXPECT_THAT(without.out, Not(HasSubstr("significant")));
  EXPECT_THAT(with.out, HasSubstr("no shift of the lines is significant, so no line was moved"));
  auto expected = results_in("without");
  auto actual = results_in("with");
  for (auto* results : {&expected, &actual}) results->erase("report.html");
  EXPECT_EQ(actual, expected);
}

TEST_F(ShiftedLines, ByTheHeightOfTheGeoidAreRefusedWithTheCause) {
  constexpr double kGeoid_m = 48.2;
  write_moved("scene/lines.good.geojson", {0.0, 0.0, kGeoid_m}, "high.geojson");
  EXPECT_REFUSED(evaluate("high.geojson", "out"),
                 AllOf(HasSubstr("not in the same frame"), HasSubstr("by the same shift"),
                       ::testing::ContainsRegex("z 48[.](19|2)"), HasSubstr("geoid and ellipsoid"),
                       HasSubstr("egm96_15.gtx")));
  const ProgramResult result = evaluate("high.geojson", "out", {"--apply-shift"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("likely cause: geoid and ellipsoid"));
  EXPECT_LT(read_json(path("out/evaluation.high.json"))["summary"]["total"]["rms_m"], 0.1);
}

TEST_F(ShiftedLines, OfExchangedAxesAreRefusedWithAHint) {
  json lines = read_json(path("scene/lines.good.geojson"));
  for (json& feature : lines["features"]) {
    for (json& x : feature["geometry"]["coordinates"]) std::swap(x[0], x[1]);
  }
  write(path("exchanged.geojson"), lines.dump());
  EXPECT_REFUSED(evaluate("exchanged.geojson", "out"),
                 HasSubstr("with x and y exchanged the lines would lie in the cloud"));
}

TEST_F(ShiftedLines, GeoidMustBeAGrid) {
  write(path("text.gtx"), "no grid");
  EXPECT_REFUSED(evaluate("scene/lines.good.geojson", "out", {"--geoid", "text.gtx"}),
                 HasSubstr("text.gtx: is not a grid that PROJ can read"));
}

/// Sample patch 1 with its cloud 0.5 m lower.
class ShiftedCloud : public RunSample {
 protected:
  ShiftedCloud() {
    io::PointCloud cloud = io::read_cloud({path("patch/lidar.las").string()}, {});
    for (io::CloudPoint& point : cloud.points) point.z -= 0.5;
    std::filesystem::remove(path("patch/lidar.las"));
    io::write_las(path("patch/lidar.las").string(), cloud.points, cloud.frame, cloud.crs);
  }
};

TEST_F(ShiftedCloud, OfARunMovesWhatIsJudgedAndNotTheLines) {
  ASSERT_EQ(run_patch("as_given", {"--methods", "joint"}).exit_code, 0);
  const ProgramResult result = run_patch("out", {"--methods", "joint", "--apply-shift"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read(path("out/1/lines.joint.geojson")), read(path("as_given/1/lines.joint.geojson")));
  const json given = read_json(path("as_given/1/evaluation.joint.json"));
  const json moved = read_json(path("out/1/evaluation.joint.json"));
  EXPECT_TRUE(given["shift"]["significant"]);
  EXPECT_FALSE(given["shift"]["applied"]);
  EXPECT_TRUE(moved["shift"]["applied"]);
  EXPECT_NEAR(moved["shift"]["axes"]["z"]["shift_m"].get<double>(), 0.5, 0.05);
  EXPECT_LT(moved["summary"]["total"]["median_m"], 0.1);
  EXPECT_GT(given["summary"]["total"]["median_m"], 0.3);
  EXPECT_THAT(read_json(path("out/run.json"))["messages"].dump(),
              HasSubstr("They were moved against it"));
  const ProgramResult again = run_patch("out", {"--methods", "joint", "--apply-shift", "--resume"});
  EXPECT_EQ(again.out, result.out);
}

}  // namespace
}  // namespace ridgeline::cli
