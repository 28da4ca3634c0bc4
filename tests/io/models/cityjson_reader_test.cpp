// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/models/read_model.h"
#include "io/models/readers.h"
#include "tests/support/paths.h"
#include "tests/support/processor_time.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <map>

namespace ridgeline::io {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A house with a gable roof of 10 m by 8 m, ridge along x at y = 4 and z = 8; two roof faces, four
/// walls, ground.
json house() {
  return json::parse(R"({
    "type": "CityJSON", "version": "2.0",
    "metadata": {"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/7415"},
    "transform": {"scale": [0.001, 0.001, 0.001], "translate": [100000, 450000, 10]},
    "CityObjects": {"h1": {"type": "Building", "attributes": {"roof": "gable", "year": 1930, "slim": null},
      "geometry": [{"type": "Solid", "lod": "2.2",
        "boundaries": [[[[0,1,5,4]], [[2,3,4,5]], [[6,7,1,0]], [[8,9,3,2]], [[7,8,2,5,1]], [[6,0,4,3,9]], [[6,9,8,7]]]],
        "semantics": {"surfaces": [{"type": "RoofSurface"}, {"type": "WallSurface"}, {"type": "GroundSurface"}],
                      "values": [[0, 0, 1, 1, 1, null, 2]]}}]}},
    "vertices": [[0,0,5000],[10000,0,5000],[10000,8000,5000],[0,8000,5000],[0,4000,8000],[10000,4000,8000],
                 [0,0,0],[10000,0,0],[10000,8000,0],[0,8000,0]]})");
}

BuildingModel read(const json& document, const ReadModelOptions& options = {}) {
  return read_cityjson("a.city.json", document.dump(), options);
}

std::string error_of(const std::string& text) {
  try {
    (void)read_cityjson("a.city.json", text, {});
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(CityJson, GivesFacesInTheCoordinatesOfTheWorldWithWhatTheyAre) {
  const BuildingModel model = read(house());
  EXPECT_EQ(model.format, "CityJSON 2.0");
  EXPECT_EQ(model.crs.definition, "EPSG:7415");
  ASSERT_EQ(model.buildings.size(), 1U);
  EXPECT_EQ(model.buildings[0].id, "h1");
  EXPECT_EQ(model.buildings[0].lod, "2.2");
  ASSERT_EQ(model.faces.size(), 7U);
  using enum FaceKind;
  std::vector<FaceKind> kinds;
  for (const Face& face : model.faces) kinds.push_back(face.kind);
  EXPECT_THAT(kinds, testing::ElementsAre(kRoof, kRoof, kWall, kWall, kWall, kUnknown, kGround));
  const Ring& ring = model.faces[0].rings[0];
  ASSERT_EQ(ring.size(), 4U);
  EXPECT_EQ(ring[2], Eigen::Vector3d(100010.0, 450004.0, 18.0));
}

TEST(CityJson, AttributesOfABuildingAreItsRow) {
  const AttributeTable table = read(house()).attributes;
  ASSERT_EQ(table.columns.size(), 2U);
  EXPECT_EQ(table.columns[0].name, "roof");
  EXPECT_EQ(table.columns[1].name, "year");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(std::get<std::int64_t>(table.rows[0][1].second), 1930);
}

TEST(CityJson, PartsBelongToTheirBuilding) {
  json document = house();
  json& objects = document["CityObjects"];
  objects["part"] = objects["h1"];
  objects["part"]["type"] = "BuildingPart";
  objects["part"]["parents"] = {"h1"};
  objects["h1"].erase("geometry");
  objects["tree"] = {{"type", "SolitaryVegetationObject"}};
  const BuildingModel model = read(document);
  ASSERT_EQ(model.buildings.size(), 1U);
  EXPECT_EQ(model.buildings[0].id, "h1");
  EXPECT_EQ(model.faces.size(), 7U);
  EXPECT_EQ(model.attributes.rows[0].size(), 2U);
  EXPECT_EQ(model.left_out.text(), "1 SolitaryVegetationObject");
}

TEST(CityJson, GroupsOfBuildingsAreNoBuildings) {
  json document = house();
  json& objects = document["CityObjects"];
  objects["h1"]["parents"] = {"g"};
  objects["h2"] = objects["h1"];
  objects["g"] = {{"type", "CityObjectGroup"}, {"children", {"h1", "h2"}}};
  const BuildingModel model = read(document);
  EXPECT_EQ(model.buildings.size(), 2U);
  EXPECT_EQ(model.left_out.text(), "1 CityObjectGroup");
}

TEST(CityJson, PartsOfEachOtherEnd) {
  json document = house();
  json& objects = document["CityObjects"];
  objects["h1"]["parents"] = {"h2"};
  objects["h2"] = {{"type", "BuildingPart"}, {"parents", {"h1"}}};
  EXPECT_EQ(read(document).faces.size(), 7U);
}

TEST(CityJson, HighestLevelIsReadUnlessAnotherIsWanted) {
  json document = house();
  json& geometry = document["CityObjects"]["h1"]["geometry"];
  geometry.push_back({{"type", "MultiSurface"}, {"lod", "1.3"}, {"boundaries", {{{6, 9, 8, 7}}}}});
  geometry.push_back({{"type", "MultiSurface"}, {"lod", "0"}, {"boundaries", {{{6, 9, 8, 7}}}}});
  EXPECT_EQ(read(document).buildings[0].lod, "2.2");
  EXPECT_EQ(read(document, {"1"}).faces.size(), 1U);
  EXPECT_EQ(read(document, {"1.3"}).buildings[0].lod, "1.3");
  EXPECT_EQ(read(document, {"0"}).faces.size(), 1U);
  EXPECT_EQ(read(document, {"3"}).faces.size(), 0U);
}

TEST(CityJson, EachPartIsReadInItsOwnHighestLevel) {
  json document = house();
  json& objects = document["CityObjects"];
  const json box = {{"type", "MultiSurface"}, {"lod", "1.3"}, {"boundaries", {{{6, 9, 8, 7}}}}};
  objects["whole"] = objects["h1"];
  objects["whole"]["type"] = "BuildingPart";
  objects["whole"]["parents"] = {"h1"};
  objects["whole"]["geometry"].push_back(box);
  objects["low"] = {{"type", "BuildingPart"}, {"parents", {"h1"}}, {"geometry", {box}}};
  objects["h1"].erase("geometry");
  const BuildingModel model = read(document);
  EXPECT_EQ(model.buildings[0].lod, "2.2");
  EXPECT_EQ(model.faces.size(), 8U);
  EXPECT_THAT(model.warnings, testing::ElementsAre(HasSubstr("is read in LoD 1.3")));
  EXPECT_THAT(model.warnings[0], HasSubstr(": low"));
  EXPECT_EQ(read(document, {"2"}).faces.size(), 8U);
  EXPECT_EQ(read(document, {"1.3"}).faces.size(), 2U);
  EXPECT_THAT(read(document, {"1.3"}).warnings, testing::IsEmpty());
}

TEST(CityJson, NumbersAsLevelAndNoTransformAreOfVersion10) {
  json document = house();
  document["version"] = "1.0";
  document.erase("transform");
  document["CityObjects"]["h1"]["geometry"][0]["lod"] = 2;
  document["metadata"]["referenceSystem"] = "urn:ogc:def:crs:EPSG::28992";
  const BuildingModel model = read(document);
  EXPECT_EQ(model.buildings[0].lod, "2");
  EXPECT_EQ(model.crs.definition, "EPSG:28992");
  EXPECT_EQ(model.faces[0].rings[0][2], Eigen::Vector3d(10000.0, 4000.0, 8000.0));
}

TEST(CityJson, SequenceGivesTheBuildingsOfAllItsLines) {
  const json document = house();
  json header = document;
  header["CityObjects"] = json::object();
  header["vertices"] = json::array();
  std::string text = header.dump() + "\n";
  for (const char* const id : {"b", "a"}) {
    json feature{{"type", "CityJSONFeature"}, {"id", id}, {"vertices", document["vertices"]}};
    feature["CityObjects"][id] = document["CityObjects"]["h1"];
    text += feature.dump() + "\r\n\n";
  }
  const BuildingModel model = read_cityjson("a.city.jsonl", text, {});
  ASSERT_EQ(model.buildings.size(), 2U);
  EXPECT_EQ(model.buildings[0].id, "b");
  ASSERT_EQ(model.faces.size(), 14U);
  EXPECT_EQ(model.faces[7].building, 1U);
  EXPECT_EQ(model.faces[0].rings[0][2], Eigen::Vector3d(100010.0, 450004.0, 18.0));
  EXPECT_THAT(error_of(text + "{\"type\":\"CityJSONFeature\""),
              HasSubstr("a.city.json: line 6: is not CityJSON"));
}

TEST(CityJson, TemplatesAreTurnedAndPutInPlace) {
  json document = house();
  json& object = document["CityObjects"]["h1"];
  document["geometry-templates"] = {
      {"templates", {{{"type", "MultiSurface"}, {"lod", "2"}, {"boundaries", {{{0, 1, 2}}}}}}},
      {"vertices-templates", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}}};
  // a quarter turn about z
  object["geometry"] = {
      {{"type", "GeometryInstance"},
       {"template", 0},
       {"boundaries", {6}},
       {"transformationMatrix", {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}};
  const BuildingModel model = read(document);
  ASSERT_EQ(model.faces.size(), 1U);
  const Ring& ring = model.faces[0].rings[0];
  EXPECT_LT((ring[1] - Eigen::Vector3d(100000, 450001, 10)).norm(), 1e-9);
  EXPECT_LT((ring[2] - Eigen::Vector3d(99999, 450000, 10.5)).norm(), 1e-9);
  object["geometry"][0]["template"] = 7;
  EXPECT_THAT(read(document).left_out.text(), HasSubstr("1 unknown geometry template"));
}

TEST(CityJson, FacesWithUnknownVerticesAreCounted) {
  json document = house();
  json& faces = document["CityObjects"]["h1"]["geometry"][0]["boundaries"][0];
  faces[0][0][0] = 99;
  faces[1][0] = {1, 2};
  faces[2][0][0] = -1;
  const BuildingModel model = read(document);
  EXPECT_EQ(model.faces.size(), 4U);
  EXPECT_EQ(model.left_out.text(), "3 faces without three vertices");
}

TEST(CityJson, FaultsAreNamed) {
  EXPECT_THAT(error_of("{"), HasSubstr("a.city.json: is not CityJSON: "));
  EXPECT_THAT(error_of("{}"), HasSubstr("\"type\" must be \"CityJSON\""));
  EXPECT_THAT(error_of(R"({"type":"CityJSON","version":"1.1"})"),
              HasSubstr("has no array \"vertices\""));
  EXPECT_THAT(error_of(R"({"type":"CityJSON","version":"1.1","vertices":[]})"),
              HasSubstr("has no object \"CityObjects\""));
  EXPECT_THAT(
      error_of(R"({"type":"CityJSON","version":"1.1","vertices":[[1,2]],"CityObjects":{}})"),
      HasSubstr("vertex 0: [1,2] must be three numbers"));
  json document = house();
  document["transform"]["scale"][0] = "x";
  EXPECT_THAT(error_of(document.dump()), HasSubstr("transform.scale: \"x\" must be a number"));
  document = house();
  document["CityObjects"]["h1"]["geometry"][0]["boundaries"] = 7;
  EXPECT_THAT(error_of(document.dump()),
              HasSubstr("building h1: \"boundaries\" must be nested arrays"));
}

/// A house and this many instances of a template of so many faces.
json with_instances(int n_instances, int n_faces) {
  const json identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  json faces = json::array(), instances = json::array();
  for (int i = 0; i < n_faces; ++i) faces.push_back({{0, 1, 2}});
  for (int i = 0; i < n_instances; ++i) {
    instances.push_back({{"type", "GeometryInstance"},
                         {"template", 0},
                         {"boundaries", {0}},
                         {"transformationMatrix", identity}});
  }
  json document = house();
  document["geometry-templates"] = {
      {"templates", {{{"type", "MultiSurface"}, {"lod", "2"}, {"boundaries", faces}}}},
      {"vertices-templates", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}}};
  document["CityObjects"]["h1"]["geometry"] = instances;
  return document;
}

template <typename Work>
double processor_seconds_of(const Work& work) {
  const double start_s = test::processor_s();
  work();
  return test::processor_s() - start_s;
}

TEST(CityJson, HostileTextsAreRefusedAtOnce) {
  // Nine million faces would take a thousand times as long as the three thousand of a harmless
  // text.
  constexpr double kMaxTimeRatio = 100.0;
  const double harmless_s = processor_seconds_of([] { read(with_instances(3000, 1)); });
  const std::string deep(1'000'000, '[');
  EXPECT_LT(
      processor_seconds_of([&] { EXPECT_THAT(error_of(deep), HasSubstr("nested too deeply")); }),
      kMaxTimeRatio * harmless_s);
  const std::string many = with_instances(3000, 3000).dump();
  EXPECT_LT(processor_seconds_of([&] { EXPECT_THAT(error_of(many), HasSubstr("over and over")); }),
            kMaxTimeRatio * harmless_s);
}

class RealModels : public testing::TestWithParam<const char*> {};

struct RealModel {
  std::size_t n_buildings, n_faces;
  std::string crs;
};

TEST_P(RealModels, AreRead) {
  static const std::map<std::string, RealModel> expected{{"cube.json", {1, 6, ""}},
                                                         {"rotterdam_subset.json", {16, 248, ""}},
                                                         {"DH_01_subs.city.json", {4, 70, ""}},
                                                         {"delft_1b.json", {1, 229, "EPSG:7415"}},
                                                         {"multi_lod.json", {10, 348, ""}}};
  const std::string path = test::shared_data_dir() + "/models/" + GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const BuildingModel model = read_model(path);
  const RealModel& real = expected.at(GetParam());
  EXPECT_EQ(model.buildings.size(), real.n_buildings);
  EXPECT_EQ(model.faces.size(), real.n_faces);
  EXPECT_EQ(model.crs.definition, real.crs);
  EXPECT_TRUE(model.left_out.empty()) << model.left_out.text();
  EXPECT_TRUE(model.warnings.empty());
}

INSTANTIATE_TEST_SUITE_P(,
                         RealModels,
                         testing::Values("cube.json",
                                         "rotterdam_subset.json",
                                         "DH_01_subs.city.json",
                                         "delft_1b.json",
                                         "multi_lod.json"),
                         [](const auto& file) {
                           std::string name = file.param;
                           std::erase_if(name, [](char c) { return c == '.'; });
                           return name;
                         });

}  // namespace
}  // namespace ridgeline::io
