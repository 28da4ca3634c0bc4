// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

#include <cmath>
#include <cstdint>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* kLines = "scene/lines.good.geojson";

/// Where fields of a LAS 1.4 header begin, bytes.
constexpr std::size_t kLegacyPointCountAt = 107, kPointCountAt = 247, kOffsetToPointsAt = 96;

class EvaluateBadInput : public Cli {
 protected:
  [[nodiscard]] ProgramResult evaluate_against(const std::string& cloud) const {
    return run({"evaluate", "--lines", kLines, "--cloud", cloud, "--out", "out"});
  }

  /// Writes the scene's good lines as `name`, moved and in another reference system.
  void write_lines(const std::string& name,
                   double shift_x_m,
                   double shift_z_m,
                   const std::string& epsg) const {
    nlohmann::json lines = read_json(path(kLines));
    for (auto& feature : lines["features"]) {
      for (auto& vertex : feature["geometry"]["coordinates"]) {
        vertex[0] = vertex[0].get<double>() + shift_x_m;
        vertex[2] = vertex[2].get<double>() + shift_z_m;
      }
    }
    lines["crs"]["properties"]["name"] = "urn:ogc:def:crs:EPSG::" + epsg;
    write(path(name), lines.dump());
  }
};

TEST_F(EvaluateBadInput, FileThatDoesNotExistIsNamed) {
  EXPECT_REFUSED(evaluate("no.geojson", "out"), HasSubstr("no.geojson: no such file"));
  EXPECT_REFUSED(evaluate_against("no.las"), HasSubstr("no.las: does not exist"));
  EXPECT_REFUSED(evaluate_against("no*.las"), HasSubstr("no*.las: matches no file"));
  EXPECT_REFUSED(run({"evaluate", "--lines", kLines, "--patch", "no.yaml", "--out", "out"}),
                 HasSubstr("no.yaml: no such file"));
  EXPECT_REFUSED(run({"evaluate", "--lines", kLines, "--out", "out"}), HasSubstr("--cloud"));
}

TEST_F(EvaluateBadInput, FileOfAnotherKindIsNamed) {
  EXPECT_REFUSED(evaluate("scene/lidar.las", "out"),
                 HasSubstr("scene/lidar.las: is a LAS point cloud, not a file of 3D lines"));
  EXPECT_REFUSED(evaluate_against(kLines),
                 HasSubstr(std::string(kLines) + ": is GeoJSON, not a point cloud"));
  write(path("words.las"), "no cloud");
  EXPECT_REFUSED(evaluate_against("words.las"),
                 AllOf(HasSubstr("words.las"), HasSubstr("\"LASF\"")));
  EXPECT_REFUSED(evaluate_against("scene"), HasSubstr("scene: is not a regular file"));
  EXPECT_REFUSED(evaluate("scene", "out"), HasSubstr("scene: "));
}

TEST_F(EvaluateBadInput, BrokenLineFileIsNamedWithThePlace) {
  write(path("broken.geojson"), "{\n");
  write(path("empty.geojson"), "");
  write(path("words.csv"), "id,x1,y1,z1,x2,y2,z2\n0,one,2,3,4,5,6\n");
  EXPECT_REFUSED(evaluate("broken.geojson", "out"),
                 AllOf(HasSubstr("broken.geojson"), HasSubstr("line 2")));
  EXPECT_REFUSED(evaluate("empty.geojson", "out"), HasSubstr("empty.geojson"));
  EXPECT_REFUSED(evaluate("words.csv", "out"), AllOf(HasSubstr("words.csv"), HasSubstr("one")));
}

TEST_F(EvaluateBadInput, TruncatedCloudIsRefusedWithBothCounts) {
  const std::string whole = read(path("scene/lidar.las"));
  constexpr std::size_t kCutAt = 3000;  // behind the header, within the points
  write(path("cut.las"), whole.substr(0, kCutAt));
  EXPECT_REFUSED(evaluate_against("cut.las"),
                 AllOf(HasSubstr("cut.las"), HasSubstr("point_count"), HasSubstr("has room for")));
}

TEST_F(EvaluateBadInput, CloudCutAnywhereIsNeverAnInternalError) {
  const std::string whole = read(path("scene/lidar.las"));
  for (const std::size_t size : {0, 1, 4, 100, 227, 374, 375, 400, 1000, 1062, 1063}) {
    SCOPED_TRACE(size);
    write(path("cut.las"), whole.substr(0, size));
    EXPECT_REFUSED(evaluate_against("cut.las"), HasSubstr("cut.las"));
  }
}

TEST_F(EvaluateBadInput, CloudWithoutPointsIsRefused) {
  std::string empty = read(path("scene/lidar.las"));
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(empty[kOffsetToPointsAt + i]));
  };
  empty.resize(byte(0) | byte(1) << 8U | byte(2) << 16U | byte(3) << 24U);
  empty.replace(kLegacyPointCountAt, 4, 4, '\0');
  empty.replace(kPointCountAt, 8, 8, '\0');
  write(path("none.las"), empty);
  EXPECT_REFUSED(evaluate_against("none.las"), HasSubstr("none.las: has no points"));
}

TEST_F(EvaluateBadInput, LinesOutsideTheCloudAreRefusedWithBothBounds) {
  write_lines("far.geojson", 5000.0, 0.0, "25832");
  EXPECT_REFUSED(evaluate("far.geojson", "out"),
                 AllOf(HasSubstr("far.geojson"), HasSubstr("not in the same frame"),
                       HasSubstr("x 518000."), HasSubstr("x 513000.")));
}

TEST_F(EvaluateBadInput, EllipsoidalHeightsAreRefusedAsAnotherFrame) {
  write_lines("ellipsoid.geojson", 0.0, 45.0, "25832");
  EXPECT_REFUSED(evaluate("ellipsoid.geojson", "out"),
                 AllOf(HasSubstr("not in the same frame"), HasSubstr("median distance")));
}

TEST_F(EvaluateBadInput, ALineWithoutHeightIsCountedAndDoesNotDecideTheRms) {
  ASSERT_EQ(evaluate(kLines, "right").exit_code, 0);
  nlohmann::json lines = read_json(path(kLines));
  for (auto& vertex : lines["features"][0]["geometry"]["coordinates"]) vertex[2] = -9999.0;
  write(path("scene/mark.geojson"), lines.dump());
  const ProgramResult result = evaluate("scene/mark.geojson", "out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("not judged (out_of_range): "));
  const nlohmann::json all =
      read_json(path("right/evaluation.lines.good.json"))["summary"]["total"];
  const nlohmann::json rest = read_json(path("out/evaluation.mark.json"))["summary"]["total"];
  EXPECT_EQ(rest["n_excluded"]["out_of_range"], 1);
  EXPECT_EQ(rest["n_lines"], all["n_lines"]);
  EXPECT_NEAR(rest["rms_m"].get<double>(), all["rms_m"].get<double>(), 0.02);
  EXPECT_THAT(read(path("out/run.json")), HasSubstr("(out_of_range): "));
  EXPECT_THAT(read(path("out/report.html")), HasSubstr("(out_of_range): "));
}

TEST_F(EvaluateBadInput, LinesOfSixDigitsAreWarnedOfAndRefusedIfStrict) {
  nlohmann::json lines = read_json(path(kLines));
  for (auto& feature : lines["features"]) {
    for (auto& vertex : feature["geometry"]["coordinates"]) {
      vertex[1] = 10.0 * std::round(vertex[1].get<double>() / 10.0);
    }
  }
  write(path("digits.geojson"), lines.dump());
  const ProgramResult result = evaluate("digits.geojson", "out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("digits.geojson: coordinates have y in steps of 10 m"));
  EXPECT_REFUSED(evaluate("digits.geojson", "strict", {"--strict"}),
                 HasSubstr("digits.geojson: coordinates have y in steps of 10 m"));
  EXPECT_EQ(evaluate(kLines, "fine", {"--strict"}).exit_code, 0);
}

TEST_F(EvaluateBadInput, AnotherCrsIsRefusedWithBothNames) {
  write_lines("zone33.geojson", 0.0, 0.0, "25833");
  const ProgramResult result = evaluate("zone33.geojson", "out");
  EXPECT_REFUSED(result, AllOf(HasSubstr("zone33.geojson"), HasSubstr("ETRS89 / UTM zone 33N"),
                               HasSubstr("ETRS89 / UTM zone 32N"), HasSubstr("--assume-crs")));
  EXPECT_EQ(evaluate("zone33.geojson", "declared", {"--assume-crs", "EPSG:25832"}).exit_code, 0);
}

TEST_F(EvaluateBadInput, FeetAgainstMetresAreRefusedWithBothUnits) {
  write_lines("feet.geojson", 0.0, 0.0, "2263");
  EXPECT_REFUSED(evaluate("feet.geojson", "out"),
                 AllOf(HasSubstr("US survey foot"), HasSubstr("metre")));
}

TEST_F(EvaluateBadInput, FilterThatLeavesNoPointIsExplained) {
  EXPECT_REFUSED(evaluate(kLines, "out", {"--classes", "77"}),
                 AllOf(HasSubstr("scene/lidar.las: none of"), HasSubstr("dropped by class"),
                       HasSubstr("ridgeline info")));
  EXPECT_REFUSED(evaluate(kLines, "out", {"--bounds", "0,0,3,4"}),
                 AllOf(HasSubstr("scene/lidar.las"), HasSubstr("--bounds")));
}

TEST_F(EvaluateBadInput, OptionOutOfRangeIsNamedWithValueAndRule) {
  const auto with = [&](const std::string& option, const std::string& value) {
    return evaluate(kLines, "out", {option, value});
  };
  EXPECT_REFUSED(with("--lidar-sigma-m", "-1"),
                 HasSubstr("--lidar-sigma-m: -1, must be in [0, 10]"));
  EXPECT_REFUSED(with("--lidar-sigma-m", "small"), HasSubstr("small"));
  EXPECT_REFUSED(with("--classes", "777"), HasSubstr("777 not in range 0 to 255"));
  EXPECT_REFUSED(with("--bounds", "5,2,3,4"), HasSubstr("must not be inverted"));
  EXPECT_REFUSED(with("--bounds", "1,2,3"), HasSubstr("--bounds"));
  EXPECT_REFUSED(with("--origin", "0.5,2,3"), HasSubstr("must be whole metres"));
  EXPECT_REFUSED(with("--gross-m", "-1"), HasSubstr("--gross-m = -1, must be finite and > 0"));
  EXPECT_REFUSED(with("--gross-m", "nan"), HasSubstr("--gross-m = nan"));
  EXPECT_REFUSED(with("--sigma-sys-m", "-1"), HasSubstr("--sigma-sys-m = -1"));
  EXPECT_REFUSED(with("--bootstrap-replicates", "0"), HasSubstr("--bootstrap-replicates"));
  EXPECT_REFUSED(with("--bootstrap-seed", "-1"), HasSubstr("--bootstrap-seed"));
  EXPECT_REFUSED(with("--assume-crs", "EPSG:999999"), HasSubstr("EPSG:999999"));
  EXPECT_REFUSED(with("--max-points", "10"), HasSubstr("scene/lidar.las"));
}

TEST_F(EvaluateBadInput, TwoLineFilesOfOneNameAreRefused) {
  EXPECT_REFUSED(
      run({"evaluate", "--lines", kLines, kLines, "--cloud", "scene/lidar.las", "--out", "out"}),
      HasSubstr("second line file is called 'lines.good'"));
}

TEST_F(EvaluateBadInput, WrongKeyOfAPatchIsNamedBesideTheKnownOnes) {
  write(path("patch.yaml"), "id: north\nheigth_range: [250, 300]\n");
  EXPECT_REFUSED(run({"evaluate", "--lines", kLines, "--patch", "patch.yaml", "--out", "out"}),
                 AllOf(HasSubstr("patch.yaml: line 2"), HasSubstr("'heigth_range'"),
                       HasSubstr("height_range, surface_model")));
}

TEST_F(EvaluateBadInput, FolderThatCannotBeMadeIsNamed) {
  EXPECT_REFUSED(evaluate(kLines, "scene/lidar.las"),
                 HasSubstr("scene/lidar.las: the folder cannot be created"));
  EXPECT_REFUSED(evaluate(kLines, "/proc/out"), HasSubstr("/proc/out"));
}

}  // namespace
}  // namespace ridgeline::cli
