// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/write_model.h"

#include "io/models/readers.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <string>
#include <vector>

namespace ridgeline::io {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The faces of a box of 2 m x 3 m x 4 m at `low`, outwards.
std::vector<Face> box_at(const Eigen::Vector3d& low, std::size_t building) {
  const auto at = [&](double x, double y, double z) -> Eigen::Vector3d {
    return low + Eigen::Vector3d(2.0 * x, 3.0 * y, 4.0 * z);
  };
  const std::vector<std::pair<FaceKind, Ring>> sides{
      {FaceKind::kGround, {at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)}},
      {FaceKind::kRoof, {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)}},
      {FaceKind::kWall, {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}},
      {FaceKind::kWall, {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)}},
      {FaceKind::kWall, {at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1)}},
      {FaceKind::kWall, {at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1)}}};
  std::vector<Face> faces;
  for (const auto& [kind, ring] : sides) faces.push_back({{ring}, kind, building, {}});
  return faces;
}

/// Two boxes: one closed, one without its roof, and with an unknown face with a hole.
BuildingModel two_boxes() {
  BuildingModel model;
  model.crs.definition = "EPSG:25832+7837";
  model.buildings = {{"A", "2.2"}, {"B", "2"}};
  model.faces = box_at({513000.25, 5403000.5, 250.125}, 0);
  std::vector<Face> open = box_at({513020.0, 5403000.0, -1.0}, 1);
  open[1] = {{{{513020.0, 5403000.0, 9.0}, {513029.0, 5403000.0, 9.0}, {513029.0, 5403009.0, 9.0}},
              {{513025.0, 5403001.0, 9.0}, {513026.0, 5403001.0, 9.0}, {513026.0, 5403002.0, 9.0}}},
             FaceKind::kUnknown,
             1,
             "cap"};
  open[2].kind = FaceKind::kOther;
  model.faces.insert(model.faces.end(), open.begin(), open.end());
  model.attributes.columns = {{"roof", ColumnType::kText},
                              {"storeys", ColumnType::kInteger64},
                              {"height", ColumnType::kReal}};
  model.attributes.rows = {{{0, std::string("a<b & \"c\"")}, {1, std::int64_t{3}}, {2, 7.25}}, {}};
  return model;
}

class WriteModel : public ::testing::Test {
 protected:
  std::string written(const BuildingModel& model, ModelFormat format) {
    write_model(folder_.file("model"), model, format);
    return folder_.read("model");
  }
  json written_json(const BuildingModel& model) {
    return json::parse(written(model, ModelFormat::kCityJson));
  }

  TempFolder folder_;
};

TEST_F(WriteModel, CityGmlIsReadBackAsItWas) {
  const BuildingModel model = two_boxes();
  (void)written(model, ModelFormat::kCityGml);
  const BuildingModel read = read_citygml(folder_.file("model"), {});
  EXPECT_EQ(read.format, "CityGML 2.0");
  EXPECT_EQ(read.crs.definition, "EPSG:25832+7837");
  EXPECT_THAT(read.warnings, IsEmpty());
  ASSERT_EQ(read.buildings.size(), 2U);
  EXPECT_EQ(read.buildings[0].id, "A");
  EXPECT_EQ(read.attributes.rows[0], model.attributes.rows[0]);
  ASSERT_EQ(read.faces.size(), model.faces.size());
  std::vector<Face> expected = model.faces;
  std::rotate(expected.begin() + 6, expected.begin() + 7,
              expected.begin() + 8);  // unknown faces come first
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(read.faces[i].kind, expected[i].kind) << i;
    EXPECT_EQ(read.faces[i].building, expected[i].building) << i;
    EXPECT_EQ(read.faces[i].id, expected[i].id) << i;
    EXPECT_EQ(read.faces[i].rings, expected[i].rings) << i;
  }
}

TEST_F(WriteModel, CityJsonHasASolidForFacesThatClose) {
  const json city = written_json(two_boxes());
  EXPECT_EQ(city["version"], "2.0");
  const json& solid = city["CityObjects"]["A"]["geometry"][0];
  EXPECT_EQ(solid["type"], "Solid");
  EXPECT_EQ(solid["lod"], "2.2");
  EXPECT_EQ(solid["boundaries"][0].size(), 6U);
  EXPECT_EQ(solid["semantics"]["values"][0], json({0, 1, 2, 2, 2, 2}));
  EXPECT_EQ(solid["semantics"]["surfaces"][1], json({{"type", "RoofSurface"}}));
  const json& surfaces = city["CityObjects"]["B"]["geometry"][0];
  EXPECT_EQ(surfaces["type"], "MultiSurface");
  EXPECT_EQ(surfaces["semantics"]["values"], json({0, nullptr, 1, 2, 2, 2}));
  EXPECT_EQ(surfaces["semantics"]["surfaces"][1], json({{"type", "ClosureSurface"}}));
  EXPECT_EQ(surfaces["boundaries"][1].size(), 2U);  // the hole
  EXPECT_EQ(city["CityObjects"]["A"]["attributes"],
            json({{"roof", "a<b & \"c\""}, {"storeys", 3}, {"height", 7.25}}));
  EXPECT_FALSE(city["CityObjects"]["B"].contains("attributes"));
}

TEST_F(WriteModel, VerticesOfCityJsonAreMillimetresAboveACorner) {
  const json city = written_json(two_boxes());
  EXPECT_EQ(city["transform"]["translate"], json({513000, 5403000, -1}));
  EXPECT_EQ(city["vertices"].size(), 8U + 14U);  // each vertex of a box once
  const json& ring = city["CityObjects"]["A"]["geometry"][0]["boundaries"][0][1][0];
  EXPECT_EQ(city["vertices"][ring[2].get<std::size_t>()], json({2250, 3500, 255125}));
}

TEST_F(WriteModel, AShellThatIsOpenOrTurnedIsNoSolid) {
  const auto type_of = [&](const BuildingModel& model) {
    return written_json(model)["CityObjects"]["A"]["geometry"][0]["type"].get<std::string>();
  };
  BuildingModel model = two_boxes();
  std::ranges::reverse(model.faces[0].rings[0]);
  EXPECT_EQ(type_of(model), "MultiSurface");
  model = two_boxes();
  model.faces.insert(model.faces.begin(), model.faces[0]);
  EXPECT_EQ(type_of(model), "MultiSurface");
  model = two_boxes();
  for (const double shift : {0.0004, -0.0008}) {  // less than the step of the vertices
    model.faces[0].rings[0][0].x() += shift;
    EXPECT_EQ(type_of(model), "Solid");
  }
}

TEST_F(WriteModel, TheReferenceSystemIsThatOfTheWholeOrOfThePlan) {
  const auto system_of = [&](const std::string& definition) {
    BuildingModel model = two_boxes();
    model.crs.definition = definition;
    const json city = written_json(model);
    return city.contains("metadata") ? city["metadata"]["referenceSystem"].get<std::string>() : "";
  };
  EXPECT_EQ(system_of("EPSG:7415"), "https://www.opengis.net/def/crs/EPSG/0/7415");
  EXPECT_EQ(system_of("EPSG:28992+5709"), "https://www.opengis.net/def/crs/EPSG/0/7415");
  EXPECT_EQ(system_of("urn:ogc:def:crs:EPSG::25832"),
            "https://www.opengis.net/def/crs/EPSG/0/25832");
  EXPECT_EQ(system_of("EPSG:25832+5709"), "https://www.opengis.net/def/crs/EPSG/0/25832");
  EXPECT_EQ(system_of("+proj=tmerc +lat_0=1 +lon_0=2 +type=crs"), "");
  EXPECT_EQ(system_of(""), "");
}

TEST_F(WriteModel, AModelWithoutFacesIsWritten) {
  BuildingModel model;
  model.buildings = {{"", ""}, {"1 a", ""}};
  EXPECT_EQ(written_json(model)["CityObjects"],
            json({{"building_0", {{"type", "Building"}}}, {"1 a", {{"type", "Building"}}}}));
  EXPECT_THAT(written(model, ModelFormat::kCityGml), HasSubstr("gml:id=\"id_1_a\""));
}

TEST_F(WriteModel, WhatIsNoModelIsTheCallersFault) {
  const auto fault_of = [&](BuildingModel model) -> std::string {
    try {
      write_model(folder_.file("model"), model, ModelFormat::kCityGml);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  BuildingModel model = two_boxes();
  model.buildings[1].id = "A";
  EXPECT_THAT(fault_of(model), HasSubstr("id = A"));
  model = two_boxes();
  model.faces[0].rings[0][0].z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(fault_of(model), HasSubstr("must be finite"));
  model = two_boxes();
  model.faces[0].building = 2;
  EXPECT_THAT(fault_of(model), HasSubstr("building = 2"));
  model = two_boxes();
  model.faces[0].rings[0].resize(2);
  EXPECT_THAT(fault_of(model), HasSubstr("has 2 vertices"));
  EXPECT_EQ(folder_.num_files(), 0U);
}

}  // namespace
}  // namespace ridgeline::io
