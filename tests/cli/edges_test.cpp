// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/read_lines.h"
#include "tests/cli/cli_fixture.h"

#include <set>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Edges : public Cli {
 protected:
  [[nodiscard]] ProgramResult edges(const std::string& out,
                                    const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"edges", "--cloud", "scene/lidar.las", "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

TEST_F(Edges, OfAVillageHaveKindPlanesCovarianceAndSupport) {
  const ProgramResult result = edges("edges.gpkg");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("ridge"), HasSubstr("total"), HasSubstr("edges.html")));
  const io::LineSet set = io::read_lines(path("edges.gpkg").string());
  ASSERT_GT(set.lines.size(), 10U);
  std::set<std::string> kinds;
  for (const io::Line& line : set.lines) {
    kinds.insert(line.kind);
    EXPECT_FALSE(line.plane_ids.empty());
    ASSERT_TRUE(line.covariance_m2.has_value());
    EXPECT_GT(line.covariance_m2->trace(), 0.0);
    EXPECT_GT(line.support.value_or(0.0), 0.0);
    EXPECT_TRUE(line.moved_out_m.has_value());
    EXPECT_GE(length(line.segment_in_world), 1.0);
  }
  EXPECT_TRUE(kinds.contains("ridge"));
  EXPECT_TRUE(kinds.contains("eave"));
  EXPECT_THAT(set.warnings, testing::Contains(HasSubstr("ignored: planes")));
}

TEST_F(Edges, AreTheSameLinesInEveryFormat) {
  ASSERT_EQ(edges("edges.geojson").exit_code, 0);
  const std::size_t n_lines = io::read_lines(path("edges.geojson").string()).lines.size();
  for (const char* name : {"e.gpkg", "e.dxf", "e.shp", "e.wkt.csv", "e.csv", "e.obj", "e.ply"}) {
    const ProgramResult result = edges(name, {"--no-report"});
    ASSERT_EQ(result.exit_code, 0) << name << result.err;
    EXPECT_EQ(io::read_lines(path(name).string()).lines.size(), n_lines) << name;
  }
}

TEST_F(Edges, AreInDxfOnTheLayersOfTheirKinds) {
  ASSERT_EQ(edges("edges.dxf", {"--no-report"}).exit_code, 0);
  const io::LineSet set = io::read_lines(path("edges.dxf").string());
  std::set<std::string> layers;
  for (const io::Line& line : set.lines) layers.insert(line.line_class);
  EXPECT_TRUE(layers.contains("ridge"));
}

TEST_F(Edges, CanBeJudged) {
  ASSERT_EQ(edges("edges.gpkg", {"--no-report"}).exit_code, 0);
  const ProgramResult result = evaluate("edges.gpkg", "out", {"--no-report"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(Edges, HaveAPageWithPlanTableAndSections) {
  ASSERT_EQ(edges("edges.geojson").exit_code, 0);
  const nlohmann::json data = data_of("edges.html");
  EXPECT_EQ(data["page"], "edges");
  EXPECT_EQ(data["kinds"].back()["kind"], "total");
  EXPECT_EQ(data["edges"].size(), data["n_edges"]);
  ASSERT_FALSE(data["sections"].empty());
  EXPECT_FALSE(data["sections"][0]["points"].empty());
  EXPECT_FALSE(data["sections"][0]["planes"].empty());
}

TEST_F(Edges, HaveNoPageOnRequest) {
  ASSERT_EQ(edges("alone.geojson", {"--no-report"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(path("alone.html")));
}

TEST_F(Edges, ShorterThanTheLimitAreLeftOut) {
  ASSERT_EQ(edges("long.geojson", {"--min-length-m", "6", "--no-report"}).exit_code, 0);
  const io::LineSet set = io::read_lines(path("long.geojson").string());
  ASSERT_FALSE(set.lines.empty());
  for (const io::Line& line : set.lines) EXPECT_GE(length(line.segment_in_world), 6.0 - 1e-3);
}

TEST_F(Edges, ReplaceNoFileOfTheUser) {
  write(path("mine.geojson"), "mine");
  EXPECT_REFUSED(edges("mine.geojson"), HasSubstr("mine.geojson"));
  EXPECT_EQ(read(path("mine.geojson")), "mine");
  write(path("page.html"), "mine");
  EXPECT_REFUSED(edges("page.geojson"), HasSubstr("page.html"));
  EXPECT_FALSE(std::filesystem::exists(path("page.geojson")));
  EXPECT_EQ(edges("page.geojson", {"--overwrite"}).exit_code, 0);
}

TEST_F(Edges, NeedACloudAndAKnownFormat) {
  EXPECT_REFUSED(edges("edges.kml"), HasSubstr("--out = edges.kml"));
  EXPECT_REFUSED(edges("scene/lidar.las", {"--format", "csv"}), HasSubstr("lidar.las"));
  EXPECT_REFUSED(run({"edges", "--cloud", "scene/truth.geojson", "--out", "e.gpkg"}),
                 HasSubstr("truth.geojson"));
  EXPECT_REFUSED(edges("e.gpkg", {"--classes", "99"}), HasSubstr("none of"));
  EXPECT_REFUSED(edges("e.gpkg", {"--bounds", "0,0,1,1"}),
                 AllOf(HasSubstr("no point lies within --bounds"), Not(HasSubstr("`"))));
  EXPECT_FALSE(std::filesystem::exists(path("e.gpkg")));
}

}  // namespace
}  // namespace ridgeline::cli
