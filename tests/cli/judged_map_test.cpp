// SPDX-License-Identifier: BSD-3-Clause
// The map of judged lines as `ogrinfo` shows it.
#include "tests/cli/cli_fixture.h"

#include <filesystem>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kOgrinfo = "/usr/bin/ogrinfo";

class JudgedMap : public Cli {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kOgrinfo)) {
      GTEST_SKIP() << "ogrinfo (package gdal-bin) is not installed";
    }
  }

  /// What ogrinfo prints of a file in the test's folder.
  [[nodiscard]] std::string ogrinfo(const std::string& file,
                                    const std::vector<std::string>& arguments) const {
    std::vector<std::string> all{"-q", path(file).string()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const ProgramResult result = test::run_program(kOgrinfo, all, path("."));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  }
  [[nodiscard]] std::string sql(const std::string& file, const std::string& query) const {
    return ogrinfo(file, {"-sql", query});
  }

  /// Writes one good line of the scene, as a polyline of two parts, with columns of a user.
  void write_user_lines() const {
    const nlohmann::json truth = read_json(path("scene/truth.geojson"));
    const auto& ends = truth["features"][0]["geometry"]["coordinates"];
    const auto at = [&](double share) {
      std::string text;
      for (std::size_t i = 0; i < 3; ++i) {
        const double a = ends[0][i];
        const double b = ends[1][i];
        text += (i == 0 ? "" : " ") + std::to_string(a + share * (b - a));
      }
      return text;
    };
    write(path("user.csv"), "wkt;code;STATUS;width\n\"MULTILINESTRING Z ((" + at(0.0) + "," +
                                at(0.5) + "),(" + at(0.5) + "," + at(1.0) +
                                "))\";007;surveyed;2.5\n;008;lost;3\n");
  }
};

TEST_F(JudgedMap, HasTheColumnsOfTheInputAndWhatBecameOfEachLine) {
  write_user_lines();
  ASSERT_EQ(run({"evaluate", "--lines", "user.csv", "--cloud", "scene/lidar.las", "--out", "out",
                 "--no-report"})
                .exit_code,
            0);
  const std::string text = ogrinfo("out/judged.user.gpkg", {"lines"});
  EXPECT_THAT(text, AllOf(HasSubstr("code (String) = 007"), HasSubstr("width (Real) = 2.5"),
                          HasSubstr("STATUS_in (String) = surveyed"),
                          HasSubstr("status (String) = evaluated"),
                          HasSubstr("line_id (String) = 0.1"), HasSubstr("part (Integer) = 1"),
                          HasSubstr("source_fid (Integer64) = 1"), HasSubstr("LINESTRING Z (")));
  EXPECT_THAT(text, ContainsRegex("mean_distance_m \\(Real\\) = 0\\.0"));
  EXPECT_THAT(text, HasSubstr("status (String) = non_finite"));
}

TEST_F(JudgedMap, HasThePlanesAndTheWayToThem) {
  ASSERT_EQ(evaluate("scene/lines.fair.geojson", "out", {"--no-report"}).exit_code, 0);
  const std::string map = "out/judged.lines.fair.gpkg";
  // every plane of a line is in the layer of planes, and every vector is of a judged line
  EXPECT_THAT(sql(map,
                  "SELECT count(*) AS n FROM lines l LEFT JOIN planes p ON l.plane_1 = p.plane_id "
                  "WHERE l.status = 'evaluated' AND p.plane_id IS NULL"),
              HasSubstr("n (Integer) = 0"));
  EXPECT_THAT(sql(map,
                  "SELECT count(*) AS n FROM vectors v LEFT JOIN lines l ON v.line_id = l.line_id "
                  "WHERE l.status = 'evaluated'"),
              Not(HasSubstr("n (Integer) = 0")));
  EXPECT_THAT(sql(map,
                  "SELECT count(*) AS n FROM planes WHERE ST_GeometryType(geom) != 'POLYGON' OR "
                  "slope_deg NOT BETWEEN 0 AND 90 OR inliers < 4 OR rms_m > 0.1"),
              HasSubstr("n (Integer) = 0"));
  EXPECT_THAT(sql(map, "SELECT f_table_name FROM layer_styles WHERE useAsDefault"),
              AllOf(HasSubstr("= lines"), HasSubstr("= planes"), HasSubstr("= vectors")));
}

TEST_F(JudgedMap, NamesTheKindsOfRoofEdges) {
  ASSERT_EQ(evaluate("scene/truth.geojson", "out", {"--no-report", "--schema", "fkb"}).exit_code,
            0);
  const auto n = [&](const std::string& condition) {
    const std::string text =
        sql("out/judged.truth.gpkg", "SELECT count(*) AS n FROM lines WHERE " + condition);
    return std::stoi(text.substr(text.find("n (Integer) = ") + 14));
  };
  // valleys and hips of a roof with dormers meet planes of few points
  constexpr double kMinRightShare = 0.95;
  for (const std::string kind : {"ridge", "valley", "hip", "eave", "verge"}) {
    const std::string judged =
        "status = 'evaluated' AND kind != 'step' AND kind_in = '" + kind + "'";
    EXPECT_GE(n(judged + " AND kind = '" + kind + "'"), kMinRightShare * n(judged)) << kind;
  }
  EXPECT_EQ(n("kind = 'ridge' AND objtype != 'M\xC3\xB8nelinje'"), 0);
  EXPECT_EQ(n("status = 'evaluated' AND \"n\xC3\xB8yaktighet\" IS NULL"), 0);
  EXPECT_EQ(n("horizontal_m IS NOT NULL AND (\"n\xC3\xB8yaktighet\" < 100 * abs(horizontal_m) OR "
              "\"n\xC3\xB8yaktighet\" > 100 * abs(horizontal_m) + 1)"),
            0);
}

TEST_F(JudgedMap, IsTheSameFromRunToRun) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "a", {"--no-report", "--jobs", "1"}).exit_code, 0);
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "b", {"--no-report", "--jobs", "2"}).exit_code, 0);
  EXPECT_EQ(read(path("a/judged.lines.good.gpkg")), read(path("b/judged.lines.good.gpkg")));
}

TEST_F(JudgedMap, IsReadAgainAsLines) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "a", {"--no-report"}).exit_code, 0);
  const ProgramResult again = evaluate("a/judged.lines.good.gpkg", "b", {"--no-report"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("reading layer lines; ignored: "));
  const auto first = read_json(path("a/evaluation.lines.good.json"));
  const auto second = read_json(path("b/evaluation.judged.lines.good.json"));
  EXPECT_EQ(first["summary"]["total"]["rms_m"], second["summary"]["total"]["rms_m"]);
}

class WritePoints : public Cli {};

TEST_F(WritePoints, WritesThePointsOfThePlanesInEachFormat) {
  for (const char* name : {"points.las", "points.pcd", "points.ply"}) {
    const std::vector<std::string> more{"--no-report", "--write-points", name, "--overwrite"};
    ASSERT_EQ(evaluate("scene/lines.good.geojson", "out", more).exit_code, 0) << name;
    const std::string first = read(path(name));
    ASSERT_EQ(evaluate("scene/lines.good.geojson", "out", more).exit_code, 0) << name;
    EXPECT_EQ(read(path(name)), first) << name;
    EXPECT_THAT(run({"info", name}).out, HasSubstr("point")) << name;
  }
}

TEST_F(WritePoints, RefusesWhatItCannotDoBeforeTheWork) {
  const auto refused = [&](const std::string& name) {
    return evaluate("scene/lines.good.geojson", "out", {"--write-points", name});
  };
  EXPECT_REFUSED(refused("points.laz"), HasSubstr("points.laz, must end in .las, .pcd or .ply"));
  write(path("mine.ply"), "ply of a user");
  EXPECT_REFUSED(refused("mine.ply"), HasSubstr("mine.ply: already exists"));
  EXPECT_EQ(read(path("mine.ply")), "ply of a user");
  EXPECT_REFUSED(refused("scene/lidar.las"), HasSubstr("scene/lidar.las: is an input"));
  EXPECT_REFUSED(run({"evaluate", "--lines", "scene/lines.good.geojson", "scene/lines.poor.geojson",
                      "--cloud", "scene/lidar.las", "--out", "out", "--write-points", "p.las"}),
                 HasSubstr("there are 2 line files"));
  EXPECT_FALSE(std::filesystem::exists(path("out/run.json")));
}

}  // namespace
}  // namespace ridgeline::cli
