// SPDX-License-Identifier: BSD-3-Clause
// Models of buildings, judged: `evaluate --lines MODEL`.
#include "io/cloud/las_writer.h"
#include "io/models/read_model.h"
#include "io/models/write_model.h"
#include "tests/cli/cli_fixture.h"
#include "tests/io/models/made_model.h"
#include "tests/support/csv_rows.h"
#include "tests/support/made_buildings.h"
#include "tests/support/made_points.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// Four houses in the world with a scan of them, in a folder for all tests.
class Models : public Cli {
 protected:
  static constexpr double kRaised_m = 0.5;

  void SetUp() override {
    const std::vector<test::MadeBuilding> made = buildings();
    write_scan(made);
    io::BuildingModel model = io::model_of(made, true);
    model.crs = {"EPSG:25832"};
    model.attributes.columns = {{"roof", io::ColumnType::kText}};
    for (std::size_t b = 0; b < made.size(); ++b)
      model.attributes.rows[b] = {{0, std::string(b < 2 ? "gable" : "hip")}};
    // The second house is too high.
    for (Face& face : model.faces) {
      if (face.building != 1) continue;
      for (Ring& ring : face.rings)
        for (Eigen::Vector3d& x : ring) x.z() += kRaised_m;
    }
    io::write_model(path("town.city.json").string(), model, io::ModelFormat::kCityJson);
    io::write_model(path("town.gml").string(), model, io::ModelFormat::kCityGml);
  }

  static std::vector<test::MadeBuilding> buildings() {
    using enum test::RoofShape;
    std::vector<test::MadeBuilding> made;
    for (const test::RoofShape shape : {kGable, kGable, kHip, kMansard}) {
      const double x_m = 30.0 * static_cast<double>(made.size());
      made.push_back(test::make_building({.shape = shape,
                                          .length_m = 16.0,
                                          .width_m = 12.0,
                                          .azimuth_deg = 10.0 * x_m,
                                          .position = {x_m, 0.0, 0.0}}));
    }
    return made;
  }

  void write_scan(const std::vector<test::MadeBuilding>& made) const {
    std::vector<io::CloudPoint> points;
    for (const Eigen::Vector3d& x : test::scan(made, {.points_per_m2 = 8.0})) {
      io::CloudPoint& point = points.emplace_back();
      point.x = x.x();
      point.y = x.y();
      point.z = x.z();
    }
    io::write_las(path("scan.las").string(), points, LocalFrame{io::kMadeOrigin}, {"EPSG:25832"});
  }

  [[nodiscard]] ProgramResult judge(const std::string& model,
                                    const std::string& out,
                                    const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"evaluate", "--lines",    model, "--cloud",
                                   "scan.las", "--out",      out,   "--bootstrap-replicates",
                                   "50",       "--no-report"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  [[nodiscard]] std::vector<std::string> column(const std::string& file, const char* name) const {
    std::vector<std::string> values;
    for (const auto& row : test::read_csv(path(file))) values.push_back(row.at(name));
    return values;
  }
};

TEST_F(Models, TellTheHouseThatIsTooHighFromThoseThatAreRight) {
  const ProgramResult result = judge("town.city.json", "out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(column("out/buildings.csv", "id"), testing::ElementsAre("1", "2", "3", "4"));
  EXPECT_THAT(column("out/buildings.csv", "verdict"),
              testing::ElementsAre("right", "too high", "right", "right"));
  EXPECT_THAT(result.out, HasSubstr("town.city: 4 buildings: 3 right, 1 too high"));
  for (const auto& row : test::read_csv(path("out/faces.csv"))) {
    if (row.at("status") != "evaluated") continue;
    const double expected_m = row.at("building") == "2" ? kRaised_m : 0.0;
    constexpr double kNoise_m = 0.03;  // 3 sigma of a face with 100 points, and more
    EXPECT_NEAR(std::stod(row.at("height_m")), expected_m, kNoise_m) << row.at("face");
  }
}

TEST_F(Models, HaveTheKindsThatTheScanShows) {
  ASSERT_EQ(judge("town.city.json", "out").exit_code, 0);
  int n_same = 0, n_other = 0;
  for (const auto& row : test::read_csv(path("out/kinds.csv"))) {
    const int n = std::stoi(row.at("n_lines"));
    if (row.at("scan_kind") == "not judged") continue;
    (row.at("stated_kind") == row.at("scan_kind") ? n_same : n_other) += n;
  }
  EXPECT_GT(n_same, 30);
  EXPECT_LE(n_other, n_same / 10);
}

TEST_F(Models, OfCityGmlGiveTheFiguresOfCityJson) {
  ASSERT_EQ(judge("town.city.json", "json").exit_code, 0);
  ASSERT_EQ(judge("town.gml", "gml").exit_code, 0);
  EXPECT_EQ(column("gml/buildings.csv", "verdict"), column("json/buildings.csv", "verdict"));
  EXPECT_EQ(column("gml/buildings.csv", "n_lines"), column("json/buildings.csv", "n_lines"));
  // Lines have other numbers, which are seeds of the sample consensus.
  constexpr double kOtherSamples_m = 0.005;
  const auto of_gml = column("gml/buildings.csv", "rms_m");
  const auto of_json = column("json/buildings.csv", "rms_m");
  for (std::size_t i = 0; i < of_gml.size(); ++i)
    EXPECT_NEAR(std::stod(of_gml[i]), std::stod(of_json[i]), kOtherSamples_m);
}

TEST_F(Models, DoNotDependOnTheMemoryForPoints) {
  ASSERT_EQ(judge("town.city.json", "whole").exit_code, 0);
  ASSERT_EQ(judge("town.city.json", "parts", {"--cloud-memory-mib", "1"}).exit_code, 0);
  EXPECT_EQ(read(path("parts/faces.csv")), read(path("whole/faces.csv")));
  EXPECT_EQ(read(path("parts/buildings.csv")), read(path("whole/buildings.csv")));
}

TEST_F(Models, AreJudgedAreaByAreaAsAtOnce) {
  const std::vector<std::string> by{"--by", "roof"};
  ASSERT_EQ(judge("town.city.json", "whole", by).exit_code, 0);
  // Between the second house, which is too high, and the third one, and through the first.
  for (const char* const area : {"512000,5402000,513000,5404000", "513000,5402000,513044,5404000",
                                 "513044,5402000,514000,5404000"}) {
    const std::string out = std::string("areas/") + area;
    std::vector<std::string> words{"--area", area, by[0], by[1]};
    const ProgramResult result = judge("town.city.json", out, words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  const ProgramResult pooled =
      run({"pool", "areas/512000,5402000,513000,5404000", "areas/513000,5402000,513044,5404000",
           "areas/513044,5402000,514000,5404000", "--out", "pooled", "--no-report"});
  ASSERT_EQ(pooled.exit_code, 0) << pooled.err;
  for (const char* const name : {"buildings.csv", "faces.csv", "kinds.csv", "buildings_by.csv"}) {
    EXPECT_EQ(read(path("pooled") / name), read(path("whole") / name)) << name;
  }
}

/// Roof edges of the scan on a building, and those that the model lacks.
TEST_F(Models, LackWhatTheScanShowsBeyondThem) {
  std::vector<test::MadeBuilding> made = buildings();
  io::BuildingModel model = io::model_of(made, true);
  model.crs = {"EPSG:25832"};
  model.attributes.rows.resize(4);
  // the second house has no roof, the fourth is not in the model
  std::erase_if(model.faces, [](const Face& face) {
    return face.building == 3 || (face.building == 1 && face.kind == FaceKind::kRoof);
  });
  io::write_model(path("old.city.json").string(), model, io::ModelFormat::kCityJson);
  const ProgramResult result = judge("old.city.json", "out", {"--completeness"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("lie on no building"));
  const auto n_edges = column("out/buildings.csv", "n_scan_edges");
  const auto n_missing = column("out/buildings.csv", "n_missing_edges");
  ASSERT_GE(n_edges.size(), 3U);
  for (const std::size_t right : {0U, 2U}) {
    EXPECT_GE(std::stoi(n_edges[right]), 5);
    EXPECT_LE(std::stoi(n_missing[right]), 1);
  }
  const std::vector<test::CsvRow> roofs = test::read_csv(path("out/missing_roofs.csv"));
  ASSERT_GE(roofs.size(), 2U);
  for (const test::CsvRow& roof : roofs) {
    EXPECT_GE(std::stod(roof.at("area_m2")), 20.0);
    EXPECT_LE(std::stod(roof.at("explained_share")), 0.5);
    EXPECT_NEAR(std::stod(roof.at("x")), io::kMadeOrigin.x() + 90.0, 10.0);
  }
  ASSERT_EQ(judge("old.city.json", "out").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(path("out/missing_roofs.csv")));
  EXPECT_THAT(read(path("out/buildings.csv")), Not(HasSubstr("n_scan_edges")));
}

TEST_F(Models, LowerRoofsAreJudgedByTheirOwnPlaneAlsoInPieces) {
  // A flat roof whose level part at a wall is 3 m lower than the house behind; the lower one is two
  // faces side by side.
  const auto write_house = [&](int n_pieces) {
    io::BuildingModel model;
    model.crs = {"EPSG:25832"};
    model.buildings = {{"h", "2"}};
    model.attributes.rows.resize(1);
    const auto add = [&](double x0, double x1, double y0, double y1, double z) {
      Ring ring{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
      for (Eigen::Vector3d& x : ring) x += io::kMadeOrigin;
      model.faces.push_back({{ring}, FaceKind::kRoof, 0, ""});
    };
    add(0, 12, 0, 8, 6);
    for (int i = 0; i < n_pieces; ++i)
      add(12.0 * i / n_pieces, 12.0 * (i + 1) / n_pieces, -6, 0, 3);
    io::write_model(path("h.gml").string(), model, io::ModelFormat::kCityGml);
  };
  std::vector<io::CloudPoint> points;
  for (double x = -6.0; x < 18.0; x += 0.4) {
    for (double y = -12.0; y < 14.0; y += 0.4) {
      io::CloudPoint& point = points.emplace_back();
      const bool is_house = x > 0.0 && x < 12.0;
      point.x = x;
      point.y = y;
      point.z = !is_house || y < -6.0 || y > 8.0 ? 0.0 : y > 0.0 ? 6.0 : 3.0;
    }
  }
  io::write_las(path("scan.las").string(), points, LocalFrame{io::kMadeOrigin}, {"EPSG:25832"});
  for (const int n_pieces : {1, 2, 60}) {
    write_house(n_pieces);
    ASSERT_EQ(judge("h.gml", "out").exit_code, 0);
    EXPECT_EQ(column("out/buildings.csv", "n_judged_lines"), std::vector<std::string>{"8"});
    EXPECT_EQ(column("out/buildings.csv", "n_judged_faces"), std::vector<std::string>{"2"});
    EXPECT_LT(std::stod(column("out/buildings.csv", "worst_distance_m")[0]), 0.01) << n_pieces;
  }
}

TEST_F(Models, AreGroupedByAnAttributeAndGatedByBuildings) {
  ASSERT_EQ(judge("town.city.json", "out", {"--by", "roof"}).exit_code, 0);
  EXPECT_THAT(column("out/buildings_by.csv", "value"), testing::ElementsAre("gable", "hip"));
  EXPECT_THAT(column("out/buildings_by.csv", "n_right"), testing::ElementsAre("1", "2"));
  const auto gate = [&](const char* min) {
    write(
        path("gates.yaml"),
        std::string("gates:\n  - {metric: buildings_within_m, within_m: 0.2, min: ") + min + "}\n");
    return run({"gate", "out", "--gates", "gates.yaml"}).exit_code;
  };
  EXPECT_EQ(gate("0.75"), 0);
  EXPECT_EQ(gate("0.76"), 3);
}

TEST_F(Models, GoBackWithTheirFigures) {
  nlohmann::json model = read_json(path("town.city.json"));
  model["metadata"]["title"] = "kept";
  write(path("town.city.json"), model.dump());
  ASSERT_EQ(judge("town.city.json", "out", {"--write-attributes", "judged.city.json"}).exit_code,
            0);
  const nlohmann::json judged = read_json(path("judged.city.json"));
  EXPECT_EQ(judged["metadata"], model["metadata"]);
  EXPECT_EQ(judged["vertices"], model["vertices"]);
  const nlohmann::json attributes = judged["CityObjects"]["2"]["attributes"];
  EXPECT_EQ(attributes["roof"], "gable");
  EXPECT_EQ(attributes["ridgeline_verdict"], "too high");
  EXPECT_NEAR(attributes["ridgeline_ridge_height_m"].get<double>(), kRaised_m, 0.03);
  // What was written is a model again, in each format.
  ASSERT_EQ(judge("town.gml", "gml", {"--write-attributes", "judged.gml"}).exit_code, 0);
  EXPECT_THAT(read(path("judged.gml")), HasSubstr("ridgeline_verdict"));
  ASSERT_EQ(judge("judged.gml", "again").exit_code, 0);
  EXPECT_EQ(column("again/buildings.csv", "rms_m"), column("gml/buildings.csv", "rms_m"));
  ASSERT_EQ(judge("town.gml", "gml", {"--write-attributes", "judged.gpkg"}).exit_code, 0);
  ASSERT_EQ(
      judge("town.gml", "gml", {"--write-attributes", "judged.gpkg", "--overwrite"}).exit_code, 0);
}

TEST_F(Models, GoBackWithTheFiguresOfTheLastTimeOnly) {
  for (const std::string ending : {"gml", "city.json"}) {
    SCOPED_TRACE(ending);
    write_scan(buildings());
    const std::string once = "once." + ending;
    ASSERT_EQ(judge("town." + ending, "out", {"--write-attributes", once}).exit_code, 0);
    // Where nothing was scanned, nothing is judged: the figures of the first time must not stay.
    write_scan({buildings()[1]});
    const std::string twice = "twice." + ending;
    ASSERT_EQ(judge(once, "again", {"--write-attributes", twice}).exit_code, 0);
    const io::BuildingModel model = io::read_model(path(twice).string());
    std::set<std::string> names;
    for (const io::Column& column : model.attributes.columns)
      EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_TRUE(names.contains("roof"));
    const auto value = [&](std::size_t building, const char* name) {
      for (const auto& [column, found] : model.attributes.rows[building])
        if (model.attributes.columns[column].name == name) return io::text_of(found);
      return std::string();
    };
    EXPECT_EQ(value(0, "ridgeline_verdict"), "not judged");
    EXPECT_EQ(value(0, "ridgeline_rms_m"), "");
    EXPECT_EQ(value(1, "ridgeline_verdict"), "too high");
    const std::string text = read(path(twice));
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find("ridgeline_verdict\"", at)) != std::string::npos; ++at)
      ++n;
    EXPECT_EQ(n, 4U);
    // in a map, too
    ASSERT_EQ(judge(once, "map", {"--write-attributes", ending + ".gpkg"}).exit_code, 0);
    EXPECT_THAT(read(path(ending + ".gpkg")), Not(HasSubstr("ridgeline_verdict")));
  }
}

TEST_F(Models, WithYUpAreRefusedNamingTheAxes) {
  // x, z, -y of the first house's roof and a wall
  std::string obj;
  for (const char* const vertex : {"0 0 5", "8 0 5", "8 8 5", "0 8 5", "0 0 0", "8 0 0"}) {
    std::istringstream words(vertex);
    Eigen::Vector3d x;
    words >> x.x() >> x.y() >> x.z();
    x += io::kMadeOrigin;
    obj += fmt::format("v {} {} {}\n", x.x(), x.z(), -x.y());
  }
  write(path("y_up.obj"), obj + "f 1 2 3 4\nf 5 6 2 1\n");
  EXPECT_REFUSED(judge("y_up.obj", "out"),
                 AllOf(HasSubstr("y and z look exchanged: with -z as y"), HasSubstr("z up")));
}

TEST_F(Models, AndOptionsThatDoNotFitAreRefused) {
  write(path("lines.csv"), "x1,y1,z1,x2,y2,z2\n513000,5403000,250,513010,5403000,250\n");
  write(path("own.json"), "{}");
  EXPECT_REFUSED(judge("town.gml", "out", {"--by", "colour"}),
                 AllOf(HasSubstr("--by colour"), HasSubstr("available: roof")));
  EXPECT_REFUSED(judge("lines.csv", "out", {"--by", "roof"}), HasSubstr("not a building model"));
  EXPECT_REFUSED(judge("lines.csv", "out", {"--write-attributes", "a.json"}),
                 HasSubstr("lines.csv: is not a building model"));
  EXPECT_REFUSED(judge("town.gml", "out", {"--write-attributes", "a.txt"}),
                 HasSubstr("must end in .json, .jsonl, .gml or .gpkg"));
  EXPECT_REFUSED(judge("town.gml", "out", {"--write-attributes", "own.json"}),
                 HasSubstr("own.json"));
  EXPECT_EQ(read(path("own.json")), "{}");
  EXPECT_REFUSED(judge("town.gml", "out", {"--write-attributes", "town.gml"}),
                 HasSubstr("town.gml"));
  EXPECT_REFUSED(judge("town.gml", "out", {"--lod", "1"}),
                 HasSubstr("town.gml: has 4 buildings without faces in LoD 1"));
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(Models, AreShownByInfoWithoutAWarning) {
  const ProgramResult result = run({"info", "town.city.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("CityJSON 2.0, edges of roofs"),
                                HasSubstr("buildings   4 of LoD 2; "), HasSubstr(" ridge"),
                                Not(HasSubstr("warning"))));
  EXPECT_THAT(run({"info", "town.gml"}).out, HasSubstr("buildings   4 of LoD 2; "));
}

TEST_F(Models, TablesOfAnEarlierRunDoNotStay) {
  ASSERT_EQ(judge("town.gml", "out", {"--by", "roof"}).exit_code, 0);
  EXPECT_THAT(names_in(path("out")), Contains("buildings_by.csv"));
  write(path("lines.csv"), "x1,y1,z1,x2,y2,z2\n513000,5403000,250,513010,5403000,250\n");
  ASSERT_EQ(judge("lines.csv", "out").exit_code, 0);
  for (const char* const name : {"buildings.csv", "faces.csv", "kinds.csv", "buildings_by.csv"})
    EXPECT_THAT(names_in(path("out")), Not(Contains(name)));
}

}  // namespace
}  // namespace ridgeline::cli
