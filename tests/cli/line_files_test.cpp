// SPDX-License-Identifier: BSD-3-Clause
// Line files as people have them, judged as a user does: the same lines in another dress have the
// same figures.
#include "tests/cli/cli_fixture.h"

#include <fmt/format.h>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kGood = "scene/lines.good.geojson";

class LineFiles : public Cli {
 protected:
  /// Writes the scene's good lines as `name`, after `change` has been applied to their features.
  template <typename Change>
  void write_changed(const std::string& name, const Change& change) const {
    json lines = read_json(path(kGood));
    std::erase_if(lines["features"].get_ref<json::array_t&>(),
                  [](const json& feature) { return feature["geometry"].is_null(); });
    for (json& feature : lines["features"]) change(feature);
    write(path(name), lines.dump());
  }

  /// Judges `name` and the good lines; expects the same figures and returns what it was warned of.
  std::string expect_as_good(const std::string& name) const {
    write_changed("plain.geojson", [](const json&) {});
    const ProgramResult good = evaluate("plain.geojson", "good", {"--no-report"});
    EXPECT_EQ(good.exit_code, 0) << good.err;
    const ProgramResult result = evaluate(name, "out", {"--no-report"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const json figures = total(name);
    const json expected = total("plain.geojson", "good");
    EXPECT_EQ(figures[0], expected[0]);
    EXPECT_EQ(figures[1], expected[1]);
    constexpr double kBySeed_m = 2e-4;  // the judge draws its points by the line's id
    EXPECT_NEAR(figures[2].get<double>(), expected[2].get<double>(), kBySeed_m);
    return result.err;
  }

  [[nodiscard]] json total(const std::string& name, const std::string& folder = "out") const {
    const std::string file =
        fmt::format("{}/evaluation.{}.json", folder, fs::path(name).stem().string());
    const json summary = read_json(path(file))["summary"]["total"];
    return {summary["n_lines"], summary["n_evaluated"], summary["rms_m"]};
  }

  [[nodiscard]] std::vector<std::string> recorded_warnings() const {
    return read_json(path("out/run.json"))["warnings"];
  }
};

TEST_F(LineFiles, WithOneIdForAllLinesAreJudgedAll) {
  write_changed("same.geojson", [](json& feature) { feature["properties"]["id"] = 12; });
  EXPECT_THAT(expect_as_good("same.geojson"), HasSubstr("get a number: 12.1, 12.2, 12.3, ..."));
  const json lines = read_json(path("out/evaluation.same.json"))["lines"];
  EXPECT_EQ(lines[0]["id"], "12");
  EXPECT_EQ(lines[1]["id"], "12.1");
}

TEST_F(LineFiles, InCollectionsAreJudgedAndWhatIsBesideThemIsCounted) {
  write_changed("grouped.geojson", [](json& feature) {
    const json line = feature["geometry"];
    const json point = {{"type", "Point"}, {"coordinates", line["coordinates"][0]}};
    feature["geometry"] = {{"type", "GeometryCollection"}, {"geometries", {point, line}}};
  });
  EXPECT_THAT(expect_as_good("grouped.geojson"), HasSubstr("ignored: "));
  EXPECT_THAT(recorded_warnings(),
              Contains(AllOf(HasSubstr("grouped.geojson: ignored: "), HasSubstr("points"))));
}

TEST_F(LineFiles, WithAVertexEveryQuarterOfAMetreAreJudgedAsTheyAre) {
  write_changed("dense.geojson", [](json& feature) {
    json& vertices = feature["geometry"]["coordinates"];
    const json ends = vertices;
    vertices = json::array();
    for (int k = 0; k <= 40; ++k) {
      json x = json::array();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double a = ends[0][axis];
        const double b = ends[1][axis];
        x.push_back(k == 40 ? b : a + (b - a) * k / 40.0);
      }
      vertices.push_back(x);
    }
  });
  EXPECT_THAT(expect_as_good("dense.geojson"), HasSubstr("of a straight line are ignored"));
}

TEST_F(LineFiles, WithColumnsOfAnotherToolKeepThemInTheMap) {
  write_changed("other.geojson",
                [](json& feature) { feature["properties"]["n_points"] = "about 120"; });
  EXPECT_THAT(expect_as_good("other.geojson"), HasSubstr("column n_points has another meaning"));
}

TEST_F(LineFiles, OfMoreColumnsThanTheMapHoldsAreSaidToBe) {
  write_changed("wide.geojson", [](json& feature) {
    for (int i = 0; i < 2000; ++i) feature["properties"][fmt::format("c{}", i)] = i;
  });
  EXPECT_THAT(expect_as_good("wide.geojson"), HasSubstr("the first 1900 of its 20"));
}

TEST_F(LineFiles, WithoutALineAreRefusedNamingWhatTheyHold) {
  write_changed("points.geojson", [](json& feature) {
    feature["geometry"] = {{"type", "Point"},
                           {"coordinates", feature["geometry"]["coordinates"][0]}};
  });
  EXPECT_REFUSED(
      evaluate("points.geojson", "out"),
      AllOf(HasSubstr("points.geojson: has no 3D lines but "), HasSubstr(" points; 3D lines, or")));
  EXPECT_REFUSED(evaluate(kGood, "out", {"--reference-lines", "points.geojson"}),
                 HasSubstr("points.geojson: has no 3D lines but "));
  write(path("none.geojson"), R"({"type":"FeatureCollection","crs":null,"features":[]})");
  EXPECT_REFUSED(evaluate(kGood, "out", {"--reference-lines", "none.geojson"}),
                 HasSubstr("none.geojson: has no reference lines"));
}

TEST_F(LineFiles, OfReferenceAreWarnedOfAsThoseThatAreJudged) {
  json truth = read_json(path("scene/truth.geojson"));
  truth["features"].push_back(
      {{"type", "Feature"},
       {"properties", nullptr},
       {"geometry", {{"type", "Point"}, {"coordinates", {513000.0, 5403000.0, 250.0}}}}});
  write(path("true.geojson"), truth.dump());
  const ProgramResult result =
      evaluate(kGood, "out", {"--reference-lines", "true.geojson", "--no-report"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("true.geojson: ignored: 1 point"));
  EXPECT_THAT(recorded_warnings(), Contains("true.geojson: ignored: 1 point"));
}

TEST_F(LineFiles, OfPolygonsAsReferenceGiveTheirEdges) {
  // a triangle with a good line as a side, so that this line has a true one
  const json line = read_json(path(kGood))["features"][0]["geometry"]["coordinates"];
  const json above = {line[0][0], line[0][1], line[0][2].get<double>() + 30.0};
  const json feature = {
      {"type", "Feature"},
      {"properties", nullptr},
      {"geometry", {{"type", "Polygon"}, {"coordinates", {{line[0], line[1], above, line[0]}}}}}};
  const json crs = read_json(path(kGood))["crs"];
  write(path("roof.geojson"),
        json{{"type", "FeatureCollection"}, {"crs", crs}, {"features", {feature}}}.dump());
  const ProgramResult result =
      evaluate(kGood, "out", {"--reference-lines", "roof.geojson", "--no-report"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("the 3 edges of 1 polygons with heights"));
  EXPECT_THAT(read(path("out/tolerances.csv")), HasSubstr(",lines,"));
}

TEST_F(LineFiles, InMillimetresAreRefusedWithTheUnit) {
  write_changed("mm.geojson", [](json& feature) {
    for (json& vertex : feature["geometry"]["coordinates"]) {
      for (json& x : vertex) x = x.get<double>() * 1000.0;
    }
  });
  json lines = read_json(path("mm.geojson"));
  lines["crs"] = nullptr;
  write(path("mm.geojson"), lines.dump());
  EXPECT_REFUSED(
      evaluate("mm.geojson", "out"),
      HasSubstr("scaled by 0.001 the lines would lie in the cloud: are they in millimetres"));
}

TEST_F(LineFiles, NamedAndWrittenInLatin1GiveUtf8) {
  const std::string rows = read(path(kGood));
  write_changed("plain.geojson", [](json& feature) { feature["properties"]["id"] = "Stra@e"; });
  std::string latin1 = read(path("plain.geojson"));
  for (std::size_t at = 0; (at = latin1.find('@', at)) != std::string::npos;) latin1[at] = '\xDF';
  write(path("na\xEFve.geojson"), latin1);
  ASSERT_EQ(evaluate("na\xEFve.geojson", "out").exit_code, 0);
  const auto names = names_in(path("out"));
  EXPECT_THAT(names, Contains("evaluation.na\xC3\xAFve.csv"));
  for (const std::string& name : names) {
    if (name.ends_with(".gpkg") || name.ends_with(".png")) continue;
    const std::string text = read(path("out/" + name));
    EXPECT_NO_THROW((void)json(text).dump()) << name;  // throws for what is no UTF-8
  }
  EXPECT_THAT(read(path("out/evaluation.na\xC3\xAFve.csv")), HasSubstr("Stra\xC3\x9F"
                                                                       "e.1,"));
}

TEST_F(LineFiles, ThatWereReportedHaveTheFiguresOfTheirBase) {
  const fs::path folder = shared_data("reported");
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  for (const char* const file :
       {"base/lines.geojson", "2/exploded.geojson", "2/two_layers.gpkg", "8/qgis_expression.csv",
        "9/collections.geojson", "14/view_beside.gpkg", "15/n_points_text.geojson",
        "16/densified.geojson", "17/edge_start_end.ply"}) {
    SCOPED_TRACE(file);
    const ProgramResult result =
        run({"evaluate", "--lines", (folder / file).string(), "--cloud",
             (folder / "base/cloud.las").string(), "--out", "out", "--no-report"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json figures = total(file);
    EXPECT_EQ(figures[0], 7);
    EXPECT_EQ(figures[1], 7);
    EXPECT_NEAR(figures[2].get<double>(), 0.037, 0.0005);
  }
}

}  // namespace
}  // namespace ridgeline::cli
