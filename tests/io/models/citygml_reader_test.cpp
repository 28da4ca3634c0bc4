// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/readers.h"
#include "tests/support/processor_time.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <map>
#include <string>
#include <vector>

namespace ridgeline::io {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The prefixes of these documents are unusual on purpose: only the namespaces may matter.

/// A document of CityGML 2.0 with the objects, and with what stands before them.
std::string city_2(const std::string& members, const std::string& before = "") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<c:CityModel xmlns:c=\"http://www.opengis.net/citygml/2.0\" "
         "xmlns:b=\"http://www.opengis.net/citygml/building/2.0\" "
         "xmlns:a=\"http://www.opengis.net/citygml/generics/2.0\" "
         "xmlns:t=\"http://www.opengis.net/citygml/transportation/2.0\" "
         "xmlns:g=\"http://www.opengis.net/gml\" xmlns:x=\"http://www.w3.org/1999/xlink\">\n" +
         before + members + "</c:CityModel>\n";
}

/// CityGML 3.0 as other programs write it: the core has no prefix.
std::string city_3(const std::string& members) {
  return "<CityModel xmlns=\"http://www.opengis.net/citygml/3.0\" "
         "xmlns:k=\"http://www.opengis.net/citygml/construction/3.0\" "
         "xmlns:h=\"http://www.opengis.net/citygml/building/3.0\" "
         "xmlns:z=\"http://www.opengis.net/citygml/generics/3.0\" "
         "xmlns:gml=\"http://www.opengis.net/gml/3.2\" xmlns:xl=\"http://www.w3.org/1999/xlink\">" +
         members + "</CityModel>";
}

std::string building_2(const std::string& id, const std::string& content) {
  return fmt::format(
      "<c:cityObjectMember><b:Building g:id=\"{}\">{}</b:Building></c:cityObjectMember>\n", id,
      content);
}

std::string polygon_2(const std::string& id, const std::string& positions) {
  return fmt::format(
      "<g:surfaceMember><g:Polygon g:id=\"{}\"><g:exterior><g:LinearRing><g:posList "
      "srsDimension=\"3\">{}</g:posList>"
      "</g:LinearRing></g:exterior></g:Polygon></g:surfaceMember>",
      id, positions);
}

std::string surface_2(const std::string& kind,
                      const std::string& id,
                      const std::string& members,
                      int lod = 2) {
  return fmt::format(
      "<b:boundedBy><b:{0} "
      "g:id=\"{1}\"><b:lod{3}MultiSurface><g:MultiSurface>{2}</g:MultiSurface></"
      "b:lod{3}MultiSurface>"
      "</b:{0}></b:boundedBy>",
      kind, id, members, lod);
}

std::string solid_2(const std::string& members, int lod = 2) {
  return fmt::format(
      "<b:lod{1}Solid><g:Solid><g:exterior><g:CompositeSurface>{0}</g:CompositeSurface></"
      "g:exterior></g:Solid></b:lod{1}Solid>",
      members, lod);
}

std::string reference_2(const std::string& id) {
  return fmt::format("<g:surfaceMember x:href=\"#{}\"/>", id);
}

// Triangles of a small tent; each ring is closed, as GML wants it.
const std::string kRoofText = "0 0 3 4 0 3 2 2 5 0 0 3";
const std::string kWallText = "0 0 0 4 0 0 4 0 3 0 0 3 0 0 0";
const std::string kGroundText = "0 0 0 2 2 0 4 0 0 0 0 0";

class CityGml : public ::testing::Test {
 protected:
  BuildingModel read(const std::string& content, const std::string& lod = "") {
    return read_citygml(folder_.write("city.gml", content), {.lod = lod});
  }
  std::string error_of(const std::string& content) {
    return io_error_of([&] { (void)read(content); });
  }

  TempFolder folder_;
};

std::vector<FaceKind> kinds_of(const BuildingModel& model) {
  std::vector<FaceKind> kinds;
  for (const Face& face : model.faces) kinds.push_back(face.kind);
  return kinds;
}

std::vector<std::string> ids_of(const BuildingModel& model) {
  std::vector<std::string> ids;
  for (const Face& face : model.faces) ids.push_back(face.id);
  return ids;
}

/// What a model states of a building, by name; numbers as text.
std::map<std::string, std::string> attributes_of(const BuildingModel& model, std::size_t building) {
  std::map<std::string, std::string> attributes;
  for (const auto& [column, value] : model.attributes.rows[building]) {
    std::string text;
    if (const auto* const word = std::get_if<std::string>(&value)) text = *word;
    if (const auto* const n = std::get_if<std::int64_t>(&value)) text = fmt::format("{}", *n);
    if (const auto* const x = std::get_if<double>(&value)) text = fmt::format("{:.3f}", *x);
    attributes[model.attributes.columns[column].name] = text;
  }
  return attributes;
}

TEST_F(CityGml, SurfacesOfVersion2HaveTheirKindAndTheSolidThatNamesThemAddsNothing) {
  const BuildingModel model = read(city_2(building_2(
      "B1", solid_2(reference_2("p1") + reference_2("p2") + reference_2("p3") + reference_2("p4")) +
                surface_2("RoofSurface", "r", polygon_2("p1", kRoofText)) +
                surface_2("WallSurface", "w", polygon_2("p2", kWallText)) +
                surface_2("GroundSurface", "f", polygon_2("p3", kGroundText)) +
                surface_2("ClosureSurface", "o", polygon_2("p4", "0 0 0 0 0 3 2 2 5 0 0 0")))));
  EXPECT_EQ(model.format, "CityGML 2.0");
  ASSERT_EQ(model.buildings.size(), 1U);
  EXPECT_EQ(model.buildings[0].id, "B1");
  EXPECT_EQ(model.buildings[0].lod, "2");
  EXPECT_THAT(kinds_of(model),
              ElementsAre(FaceKind::kRoof, FaceKind::kWall, FaceKind::kGround, FaceKind::kOther));
  EXPECT_THAT(ids_of(model), ElementsAre("p1", "p2", "p3", "p4"));
  EXPECT_THAT(model.faces[0].rings, ElementsAre(Ring{{0, 0, 3}, {4, 0, 3}, {2, 2, 5}}));
  EXPECT_TRUE(model.left_out.empty()) << model.left_out.text();
}

TEST_F(CityGml, SurfacesOfVersion3AreRead) {
  const std::string roof =
      "<boundary><k:RoofSurface "
      "gml:id=\"r\"><lod2MultiSurface><gml:MultiSurface><gml:surfaceMember><gml:Polygon><gml:"
      "exterior>"
      "<gml:LinearRing><gml:pos>0 0 3</gml:pos><gml:pos>4 0 3</gml:pos><gml:pos>2 2 "
      "5</gml:pos><gml:pos>0 0 3</gml:pos></gml:LinearRing>"
      "</gml:exterior></gml:Polygon></gml:surfaceMember></gml:MultiSurface></lod2MultiSurface></"
      "k:RoofSurface></boundary>";
  const std::string attribute =
      "<genericAttribute><z:IntAttribute><z:name>storeys "
      "seen</z:name><z:value>3</z:value></z:IntAttribute></genericAttribute>";
  const BuildingModel model =
      read(city_3("<cityObjectMember><h:Building gml:id=\"B\">" + attribute + roof +
                  "<h:roofType>1030</h:roofType></h:Building></cityObjectMember>"));
  EXPECT_EQ(model.format, "CityGML 3.0");
  EXPECT_THAT(kinds_of(model), ElementsAre(FaceKind::kRoof));
  EXPECT_THAT(ids_of(model), ElementsAre("r"));  // the polygon has none
  EXPECT_THAT(model.faces[0].rings, ElementsAre(Ring{{0, 0, 3}, {4, 0, 3}, {2, 2, 5}}));
  EXPECT_EQ(attributes_of(model, 0),
            (std::map<std::string, std::string>{{"storeys seen", "3"}, {"roofType", "1030"}}));
}

TEST_F(CityGml, ASolidOfItsOwnHasUnknownFaces) {
  const BuildingModel model = read(city_2(building_2("B", solid_2(polygon_2("p", kRoofText), 1))));
  EXPECT_EQ(model.buildings[0].lod, "1");
  EXPECT_THAT(kinds_of(model), ElementsAre(FaceKind::kUnknown));
}

TEST_F(CityGml, ASurfaceThatNamesPolygonsOfTheSolidGivesThemItsKind) {
  const BuildingModel model = read(
      city_2(building_2("B", surface_2("RoofSurface", "r", reference_2("p")) +
                                 solid_2(polygon_2("p", kRoofText) + polygon_2("q", kWallText)))));
  EXPECT_THAT(ids_of(model), ElementsAre("p", "q"));
  EXPECT_THAT(kinds_of(model), ElementsAre(FaceKind::kRoof, FaceKind::kUnknown));
}

TEST_F(CityGml, AReferenceMayNameASurfaceOfSeveralPolygons) {
  const std::string composite = "<g:surfaceMember><g:CompositeSurface g:id=\"all\">" +
                                polygon_2("p", kRoofText) + polygon_2("q", kWallText) +
                                "</g:CompositeSurface></g:surfaceMember>";
  const BuildingModel model = read(city_2(
      building_2("B", surface_2("RoofSurface", "r", reference_2("all")) + solid_2(composite))));
  EXPECT_THAT(ids_of(model), ElementsAre("p", "q"));
  EXPECT_THAT(kinds_of(model), ElementsAre(FaceKind::kRoof, FaceKind::kRoof));
  EXPECT_TRUE(model.left_out.empty()) << model.left_out.text();
}

TEST_F(CityGml, ReferencesInACircleEnd) {
  const std::string circle = "<g:surfaceMember><g:CompositeSurface g:id=\"a\">" + reference_2("a") +
                             polygon_2("p", kRoofText) + "</g:CompositeSurface></g:surfaceMember>";
  EXPECT_THAT(ids_of(read(city_2(building_2("B", solid_2(circle))))), ElementsAre("p"));
}

TEST_F(CityGml, AReferenceToNothingIsNone) {
  const BuildingModel model =
      read(city_2(building_2("B", solid_2(reference_2("") + polygon_2("p", kRoofText)))));
  EXPECT_THAT(ids_of(model), ElementsAre("p"));
  EXPECT_FALSE(model.left_out.empty());
}

TEST_F(CityGml, ALongChainOfReferencesIsFollowed) {
  std::string chain;
  for (int i = 0; i < 100'000; ++i) {
    chain += fmt::format(
        "<g:surfaceMember><g:CompositeSurface "
        "g:id=\"s{}\">{}</g:CompositeSurface></g:surfaceMember>",
        i, reference_2(fmt::format("s{}", i + 1)));
  }
  chain += polygon_2("s100000", kRoofText);
  EXPECT_THAT(ids_of(read(city_2(building_2(
                  "B", surface_2("RoofSurface", "r", reference_2("s0")) + solid_2(chain))))),
              ElementsAre("s100000"));
}

TEST_F(CityGml, ASolidThatRepeatsTheOutlinesOfItsSurfacesAddsNothing) {
  const BuildingModel model = read(city_2(building_2(
      "B", surface_2("RoofSurface", "r", polygon_2("p", kRoofText)) +
               solid_2(polygon_2("s1", "4 0 3 0 0 3 2 2 5 4 0 3") + polygon_2("s2", kWallText)))));
  EXPECT_THAT(ids_of(model), ElementsAre("p", "s2"));
}

TEST_F(CityGml, AWallOfANeighbourMayBeNamed) {
  const BuildingModel model =
      read(city_2(building_2("A", solid_2(polygon_2("a", kRoofText) + reference_2("b1"))) +
                  building_2("B", surface_2("WallSurface", "w", polygon_2("b1", kWallText))) +
                  building_2("C", solid_2(reference_2("nowhere")))));
  EXPECT_THAT(ids_of(model), ElementsAre("a", "b1", "b1"));
  EXPECT_EQ(model.faces[1].building, 0U);
  EXPECT_EQ(model.faces[1].kind, FaceKind::kWall);
  EXPECT_EQ(model.faces[2].building, 1U);
  EXPECT_EQ(model.left_out.text(), "1 reference to a missing surface");
}

TEST_F(CityGml, PartsBelongToTheirBuilding) {
  const auto part = [](const std::string& content) {
    return "<b:consistsOfBuildingPart><b:BuildingPart g:id=\"part\"><b:roofType>1</b:roofType>" +
           content + "</b:BuildingPart></b:consistsOfBuildingPart>";
  };
  // both parts have the same outline, which is no repetition
  const BuildingModel model =
      read(city_2(building_2("A", part(solid_2(polygon_2("p", kRoofText))) +
                                      part(solid_2(polygon_2("q", kRoofText)))) +
                  building_2("B", "")));
  ASSERT_EQ(model.buildings.size(), 2U);
  EXPECT_THAT(ids_of(model), ElementsAre("p", "q"));
  EXPECT_EQ(model.faces[1].building, 0U);
  EXPECT_EQ(model.buildings[1].lod, "");
  EXPECT_THAT(attributes_of(model, 0), IsEmpty());
}

TEST_F(CityGml, ASolidOfAPartIsComparedWithTheSurfacesOfThatPart) {
  const auto part = [](const std::string& content) {
    return "<b:consistsOfBuildingPart><b:BuildingPart>" + content +
           "</b:BuildingPart></b:consistsOfBuildingPart>";
  };
  const std::string first = surface_2("WallSurface", "w", polygon_2("p", kWallText));
  const BuildingModel model =
      read(city_2(building_2("A", part(first + solid_2(polygon_2("repeated", kWallText))) +
                                      part(solid_2(polygon_2("other part", kWallText))))));
  EXPECT_THAT(ids_of(model), ElementsAre("p", "other part"));
}

TEST_F(CityGml, TheHighestLevelUpTo3IsReadUnlessOneIsChosen) {
  std::string content;
  for (int lod = 1; lod <= 4; ++lod)
    content += solid_2(polygon_2(fmt::format("p{}", lod), kRoofText), lod);
  const std::string city = city_2(building_2("B", content));
  EXPECT_THAT(ids_of(read(city)), ElementsAre("p3"));
  EXPECT_THAT(ids_of(read(city, "2")), ElementsAre("p2"));
  EXPECT_THAT(ids_of(read(city, "4")), ElementsAre("p4"));
  const BuildingModel none = read(city, "2.2");
  EXPECT_THAT(none.faces, IsEmpty());
  EXPECT_EQ(none.buildings[0].lod, "");
  EXPECT_THAT(none.warnings, Contains(HasSubstr("no building has faces of LoD 2.2")));
}

TEST_F(CityGml, EachPartIsReadInItsOwnHighestLevel) {
  const auto part = [](const std::string& id, const std::string& content) {
    return fmt::format(
        "<b:consistsOfBuildingPart><b:BuildingPart g:id=\"{}\">{}</b:BuildingPart>"
        "</b:consistsOfBuildingPart>",
        id, content);
  };
  const std::string high =
      part("high", solid_2(polygon_2("p1", kGroundText), 1) + solid_2(polygon_2("p2", kRoofText)));
  const std::string low = part("low", solid_2(polygon_2("q1", kRoofText), 1));
  const std::string city = city_2(building_2("B", low + high) + building_2("C", solid_2("")) +
                                  building_2("D", solid_2(polygon_2("d", kRoofText))));
  const BuildingModel model = read(city);
  EXPECT_THAT(ids_of(model), ElementsAre("q1", "p2", "d"));
  EXPECT_EQ(model.buildings[0].lod, "2");
  EXPECT_THAT(model.warnings,
              Contains("1 of 3 buildings and parts is read in LoD 1 (most in LoD 2): low"));
  EXPECT_THAT(ids_of(read(city, "1")), ElementsAre("q1", "p1"));
  // Faces of the building itself in a lower level are an outline of the whole.
  const std::string outline = solid_2(polygon_2("o", kGroundText), 1);
  const BuildingModel parts = read(city_2(building_2("B", outline + high)));
  EXPECT_THAT(ids_of(parts), ElementsAre("p2"));
  EXPECT_THAT(parts.warnings, Contains(HasSubstr("left out, as the faces in LoD 1 repeat")));
}

TEST_F(CityGml, OpeningsAndInstallationsAreReadButDoNotDecideTheLevel) {
  const std::string window =
      "<b:opening><b:Window g:id=\"win\"><b:lod3MultiSurface><g:MultiSurface>" +
      polygon_2("w3", kWallText) + "</g:MultiSurface></b:lod3MultiSurface></b:Window></b:opening>";
  const auto wall = [&](int lod) {
    return fmt::format(
        "<b:boundedBy><b:WallSurface><b:lod{0}MultiSurface><g:MultiSurface>{1}</g:MultiSurface></"
        "b:lod{0}MultiSurface>{2}</b:WallSurface></b:boundedBy>",
        lod, polygon_2("wall", kWallText), window);
  };
  const std::string dormer =
      "<b:outerBuildingInstallation><b:BuildingInstallation><b:lod2Geometry><g:MultiSurface>" +
      polygon_2("box", kGroundText) + "</g:MultiSurface></b:lod2Geometry>" +
      surface_2("RoofSurface", "d", polygon_2("dormer", kRoofText)) +
      "</b:BuildingInstallation></b:outerBuildingInstallation>";
  EXPECT_THAT(ids_of(read(city_2(building_2("B", wall(3))))), ElementsAre("wall", "w3"));
  const BuildingModel model = read(city_2(building_2("B", wall(2) + dormer)));
  EXPECT_THAT(ids_of(model), ElementsAre("wall", "box", "dormer"));
  EXPECT_THAT(kinds_of(model), ElementsAre(FaceKind::kWall, FaceKind::kOther, FaceKind::kRoof));
}

TEST_F(CityGml, HolesTrianglesAndTurnedSurfacesAreRead) {
  const std::string with_hole =
      "<g:surfaceMember><g:Polygon g:id=\"p\"><g:exterior><g:LinearRing><g:posList>0 0 0 9 0 0 9 9 "
      "0 0 0 0</g:posList></g:LinearRing></g:exterior>"
      "<g:interior><g:LinearRing><g:posList>5 1 0 6 1 0 6 2 0 5 1 "
      "0</g:posList></g:LinearRing></g:interior></g:Polygon></g:surfaceMember>";
  const std::string tin =
      "<g:surfaceMember><g:Tin><g:trianglePatches><g:Triangle><g:exterior><g:LinearRing><g:"
      "coordinates>0,0,1 1,0,1 1,1,1 0,0,1</g:coordinates>"
      "</g:LinearRing></g:exterior></g:Triangle></g:trianglePatches></g:Tin></g:surfaceMember>";
  const std::string turned =
      "<g:surfaceMember><g:OrientableSurface "
      "orientation=\"-\"><g:baseSurface><g:CompositeSurface>" +
      polygon_2("t", kRoofText) +
      "</g:CompositeSurface></g:baseSurface></g:OrientableSurface></g:surfaceMember>";
  const BuildingModel model = read(city_2(building_2("B", solid_2(with_hole + tin + turned))));
  ASSERT_EQ(model.faces.size(), 3U);
  EXPECT_THAT(model.faces[0].rings, ElementsAre(Ring{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}},
                                                Ring{{5, 1, 0}, {6, 1, 0}, {6, 2, 0}}));
  EXPECT_THAT(model.faces[1].rings, ElementsAre(Ring{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}));
  EXPECT_THAT(model.faces[2].rings, ElementsAre(Ring{{2, 2, 5}, {4, 0, 3}, {0, 0, 3}}));
}

TEST_F(CityGml, AttributesAreTyped) {
  const BuildingModel model = read(city_2(
      building_2(
          "A",
          "<g:name>Hall</g:name><a:stringAttribute "
          "name=\"parcel\"><a:value>007</a:value></a:stringAttribute>"
          "<a:doubleAttribute name=\"area\"><a:value>12.5</a:value></a:doubleAttribute>"
          "<a:genericAttributeSet name=\"set\"><a:intAttribute name=\"n\"><a:value> 4 "
          "</a:value></a:intAttribute></a:genericAttributeSet>"
          "<b:function>31001_2010</b:function><b:measuredHeight uom=\"m\">11.785</b:measuredHeight>"
          "<b:storeysAboveGround>3</"
          "b:storeysAboveGround><c:externalReference><c:informationSystem>x</c:informationSystem></"
          "c:externalReference>") +
      building_2("B", "<a:intAttribute name=\"n\"><a:value>many</a:value></a:intAttribute>")));
  EXPECT_EQ(attributes_of(model, 0),
            (std::map<std::string, std::string>{{"name", "Hall"},
                                                {"parcel", "007"},
                                                {"area", "12.500"},
                                                {"n", "4"},
                                                {"function", "31001_2010"},
                                                {"measuredHeight", "11.785"},
                                                {"storeysAboveGround", "3"}}));
  EXPECT_EQ(attributes_of(model, 1), (std::map<std::string, std::string>{{"n", "many"}}));
  std::map<std::string, ColumnType> types;
  for (const Column& column : model.attributes.columns) types[column.name] = column.type;
  EXPECT_EQ(types["measuredHeight"], ColumnType::kReal);
  EXPECT_EQ(types["storeysAboveGround"], ColumnType::kInteger64);
  EXPECT_EQ(types["parcel"], ColumnType::kText);
  EXPECT_EQ(types["n"], ColumnType::kText);
}

TEST_F(CityGml, WhatIsNoFaceIsCounted) {
  const std::string model_text = city_2(
      "<c:cityObjectMember><t:Road/></c:cityObjectMember><c:cityObjectMember><t:Road/></"
      "c:cityObjectMember>" +
      building_2(
          "B",
          "<b:lod2ImplicitRepresentation><c:ImplicitGeometry><c:relativeGMLGeometry><g:"
          "MultiSurface>" +
              polygon_2("i", kRoofText) +
              "</g:MultiSurface></c:relativeGMLGeometry></c:ImplicitGeometry></"
              "b:lod2ImplicitRepresentation>"
              "<b:address><c:Address><c:multiPoint><g:MultiPoint><g:pointMember><g:Point><g:pos>1 "
              "2 3</g:pos></g:Point></g:pointMember>"
              "</g:MultiPoint></c:multiPoint></c:Address></b:address><b:interiorRoom><b:Room>" +
              solid_2(polygon_2("room", kRoofText), 3) +
              "</b:Room></b:interiorRoom><b:lod2TerrainIntersection><g:MultiCurve/></"
              "b:lod2TerrainIntersection>" +
              solid_2(polygon_2("thin", "0 0 0 1 0 0 0 0 0") + polygon_2("p", kRoofText))));
  const BuildingModel model = read(model_text);
  EXPECT_THAT(ids_of(model), ElementsAre("p"));
  EXPECT_EQ(model.left_out.text(),
            "2 Road objects, 1 Room object, 1 address point, 1 building curve, 1 implicit "
            "geometry, 1 polygon of fewer than three vertices");
}

TEST_F(CityGml, PolygonsWithoutHeightsAreNoFaces) {
  const std::string flat =
      "<b:lod0FootPrint><g:MultiSurface "
      "srsDimension=\"2\"><g:surfaceMember><g:Polygon><g:exterior><g:LinearRing>"
      "<g:posList>0 0 1 0 1 1 0 "
      "0</g:posList></g:LinearRing></g:exterior></g:Polygon></g:surfaceMember></g:MultiSurface></"
      "b:lod0FootPrint>";
  const BuildingModel model = read(city_2(building_2("B", flat)));
  EXPECT_THAT(model.faces, IsEmpty());
  EXPECT_EQ(model.left_out.text(), "1 polygon without heights");
}

TEST_F(CityGml, AnAnswerOfAWebServiceIsRead) {
  const BuildingModel model = read(
      "<wfs:FeatureCollection xmlns:wfs=\"http://www.opengis.net/wfs/2.0\"><wfs:member>"
      "<bldg:Building xmlns:bldg=\"http://www.opengis.net/citygml/building/1.0\" "
      "xmlns:gml=\"http://www.opengis.net/gml\" gml:id=\"B\"/>"
      "</wfs:member></wfs:FeatureCollection>");
  EXPECT_EQ(model.format, "CityGML 1.0");
  EXPECT_EQ(model.buildings.at(0).id, "B");
}

TEST_F(CityGml, AFileThatIsCompressedIsReadWhateverItsName) {
  const std::string content = city_2(building_2("B", solid_2(polygon_2("p", kRoofText))));
  const std::string path = folder_.file("packed.gml");
  const gzFile packed = gzopen(path.c_str(), "wb");
  gzwrite(packed, content.data(), static_cast<unsigned>(content.size()));
  gzclose(packed);
  EXPECT_THAT(ids_of(read_citygml(path, {})), ElementsAre("p"));
  const std::string bytes = folder_.read("packed.gml");
  const std::string half = folder_.write("half.gml", bytes.substr(0, bytes.size() - 12));
  EXPECT_THAT(io_error_of([&] { (void)read_citygml(half, {}); }),
              AllOf(HasSubstr("half.gml"), HasSubstr("cannot be unpacked")));
}

// Reference systems and the order of axes

std::string envelope(const std::string& srs_name) {
  return fmt::format(
      "<g:boundedBy><g:Envelope srsName=\"{}\" srsDimension=\"3\"><g:lowerCorner>0 0 "
      "0</g:lowerCorner></g:Envelope></g:boundedBy>",
      srs_name);
}

std::string city_at(const std::string& srs_name,
                    const std::string& first,
                    const std::string& second) {
  const std::string positions =
      fmt::format("{0}0 {1}0 3 {0}4 {1}0 3 {0}4 {1}2 5 {0}0 {1}0 3", first, second);
  return city_2(building_2("B", solid_2(polygon_2("p", positions))), envelope(srs_name));
}

TEST_F(CityGml, NamesOfReferenceSystemsInAllForms) {
  const std::map<std::string, std::string> expected{
      {"EPSG:25832", "EPSG:25832"},
      {"epsg:25832", "EPSG:25832"},
      {"EPSG:25832+7837", "EPSG:25832+7837"},
      {"urn:ogc:def:crs:EPSG::25832", "EPSG:25832"},
      {"urn:ogc:def:crs:EPSG:6.12:25832", "EPSG:25832"},
      {"urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::5783", "EPSG:25832+5783"},
      {"urn:ogc:def:crs,crs:EPSG:6.12:25832,crs:EPSG:6.12:5783", "EPSG:25832+5783"},
      {"urn:adv:crs:ETRS89_UTM32*DE_DHHN2016_NH", "EPSG:25832+7837"},
      {"urn:adv:crs:ETRS89_UTM32*DE_DHHN2016_NH*GCG2016", "EPSG:25832+7837"},
      {"urn:adv:crs:ETRS89_UTM33*DE_DHHN92_NH", "EPSG:25833+5783"},
      {"urn:adv:crs:ETRS89_UTM32", "EPSG:25832"},
      {"http://www.opengis.net/def/crs/EPSG/0/7415", "EPSG:7415"},
      {"https://www.opengis.net/def/crs/EPSG/0/25832", "EPSG:25832"},
      {"http://www.opengis.net/gml/srs/epsg.xml#25832", "EPSG:25832"},
      {"http://www.opengis.net/def/crs-compound?1=http://www.opengis.net/def/crs/EPSG/0/"
       "25832&amp;2=http://www.opengis.net/def/crs/EPSG/0/7837",
       "EPSG:25832+7837"}};
  for (const auto& [name, definition] : expected) {
    const BuildingModel model = read(city_at(name, "50000", "550000"));
    EXPECT_EQ(model.crs.definition, definition) << name;
    EXPECT_THAT(model.warnings, IsEmpty()) << name;
    EXPECT_EQ(model.faces[0].rings[0][0].x(), 500000.0) << name;
  }
}

TEST_F(CityGml, WhatIsNotUnderstoodOfANameIsAWarning) {
  const BuildingModel heights =
      read(city_at("urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::5109", "50000", "550000"));
  EXPECT_EQ(heights.crs.definition, "EPSG:25832");
  EXPECT_THAT(heights.warnings, ElementsAre(HasSubstr("the height system EPSG:5109 is unknown")));
  const BuildingModel nothing = read(city_at("urn:adv:crs:ETRS89_UTM99", "50000", "550000"));
  EXPECT_FALSE(nothing.crs.known());
  EXPECT_THAT(nothing.warnings,
              ElementsAre(HasSubstr("\"urn:adv:crs:ETRS89_UTM99\" is not a reference system")));
  EXPECT_THAT(read(city_2(building_2("B", ""))).warnings,
              ElementsAre(HasSubstr("has no reference system")));
}

TEST_F(CityGml, TwoReferenceSystemsAreRefused) {
  const std::string surface =
      "<b:lod2MultiSurface><g:MultiSurface srsName=\"EPSG:25833\"/></b:lod2MultiSurface>";
  EXPECT_THAT(error_of(city_2(building_2("B", surface), envelope("EPSG:25832"))),
              HasSubstr("has two reference systems"));
  const std::string with_heights =
      "<b:lod2MultiSurface><g:MultiSurface srsName=\"EPSG:25832+7837\"/></b:lod2MultiSurface>";
  EXPECT_EQ(read(city_2(building_2("B", with_heights), envelope("EPSG:25832"))).crs.definition,
            "EPSG:25832+7837");
}

TEST_F(CityGml, TheOrderOfAxesIsThatInWhichTheModelLiesWhereTheSystemIsUsed) {
  // Gauss-Krueger zone 3 has its north axis first; 3,451,260 is an easting, 5,429,190 a northing.
  for (const char* name : {"EPSG:31467", "urn:ogc:def:crs:EPSG::31467"}) {
    const BuildingModel east_first = read(city_at(name, "345126", "542919"));
    EXPECT_EQ(east_first.faces[0].rings[0][1], Eigen::Vector3d(3451264.0, 5429190.0, 3.0));
    EXPECT_THAT(east_first.warnings, IsEmpty());
    const BuildingModel north_first = read(city_at(name, "542919", "345126"));
    EXPECT_EQ(north_first.faces[0].rings[0][1], Eigen::Vector3d(3451260.0, 5429194.0, 3.0));
    EXPECT_THAT(north_first.warnings, ElementsAre(HasSubstr("read as north, east")));
  }
}

TEST_F(CityGml, WhereThePlaceDoesNotTellThePlaneIsReadAsEastNorth) {
  // Poland's CS92 is a square about (500 km, 500 km).
  const BuildingModel model = read(city_at("urn:ogc:def:crs:EPSG::2180", "51000", "52000"));
  EXPECT_EQ(model.faces[0].rings[0][0], Eigen::Vector3d(510000.0, 520000.0, 3.0));
  EXPECT_THAT(model.warnings, ElementsAre(HasSubstr("read as east, north, although")));
}

TEST_F(CityGml, DegreesOfTheWholeEarthFollowTheFormOfTheName) {
  const BuildingModel by_urn = read(city_at("urn:ogc:def:crs:EPSG::4326", "48.1", "11.5"));
  EXPECT_EQ(by_urn.faces[0].rings[0][0], Eigen::Vector3d(11.5, 48.1, 3.0));
  EXPECT_THAT(by_urn.warnings, ElementsAre(HasSubstr("read as north, east")));
  EXPECT_EQ(read(city_at("EPSG:4326", "11.5", "48.1")).faces[0].rings[0][0],
            Eigen::Vector3d(11.5, 48.1, 3.0));
}

// Files that are damaged, or made to do harm

TEST_F(CityGml, AFaultNamesFileLineElementAndPolygon) {
  EXPECT_THAT(error_of(city_2(building_2("B", solid_2(polygon_2("p7", "0 0 zero 1 1 1"))))),
              AllOf(HasSubstr("city.gml:3: <posList> of polygon \"p7\""),
                    HasSubstr("'zero' is not a finite number")));
  EXPECT_THAT(error_of(city_2(building_2("B", solid_2(polygon_2("p7", "0 0 nan 1 1 1"))))),
              HasSubstr("'nan' is not a finite number"));
  EXPECT_THAT(error_of(city_2(building_2("B", solid_2(polygon_2("p7", "0 0 0 1 1"))))),
              HasSubstr("5 numbers; three are needed"));
  EXPECT_THAT(error_of("<kml><Document/></kml>"), HasSubstr("is not CityGML: its root is <kml>"));
  EXPECT_THAT(error_of("<w:FeatureCollection xmlns:w=\"http://www.opengis.net/wfs\"/>"),
              HasSubstr("no CityGML objects"));
}

TEST_F(CityGml, AFileThatIsCutAnywhereIsRefused) {
  const std::string whole =
      city_2(building_2("B", "<g:name>&#228;</g:name>" + solid_2(polygon_2("p", kRoofText))));
  for (std::size_t length = 0; length + 2 < whole.size(); length += 7) {
    EXPECT_THAT(error_of(whole.substr(0, length)), HasSubstr("city.gml")) << length;
  }
}

TEST_F(CityGml, EntitiesAreNeverExpandedNorLoaded) {
  const std::string laughs = "<!DOCTYPE c [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;&a;\">]><c>&b;</c>";
  EXPECT_THAT(error_of(laughs), HasSubstr("city.gml:1: has a DOCTYPE"));
  const std::string external =
      "<!DOCTYPE c [<!ENTITY a SYSTEM \"file:///etc/hostname\">]><c>&a;</c>";
  EXPECT_THAT(error_of(external), HasSubstr("has a DOCTYPE"));
  EXPECT_THAT(error_of("<!DOCTYPE c SYSTEM \"c.dtd\"><c/>"), HasSubstr("has a DOCTYPE"));
}

TEST_F(CityGml, WhatTakesTimeOrMemoryOutOfProportionIsRefusedAtOnce) {
  constexpr double kMaxTime_s = 12.0;  // six files of up to 2 s each, and that they are written
  const double begin_s = test::processor_s();
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<c:x>";
  EXPECT_THAT(error_of(city_2(deep)), HasSubstr("more than 200 elements are nested"));
  std::string numbers;
  for (int i = 0; i < 10'000'000; ++i) numbers += "1 ";
  EXPECT_THAT(error_of(city_2(building_2("B", solid_2(polygon_2("p", numbers))))),
              HasSubstr("more than 1,000,000 vertices"));
  EXPECT_THAT(
      error_of(city_2(building_2("B", solid_2(polygon_2("p", std::string(20'000'000, '1')))))),
      HasSubstr("is not a finite number"));
  EXPECT_THAT(error_of(city_2("<c:x y=\"" + std::string(20'000'000, 'y') + "\"/>")),
              HasSubstr("a tag has more than 4 MiB"));
  EXPECT_THAT(
      error_of(city_2(building_2("B", "<g:name>" + std::string(20'000'000, 'n') + "</g:name>"))),
      HasSubstr("<name> has more than 1 MiB"));
  const std::string bomb = folder_.file("bomb.gml");
  const gzFile packed = gzopen(bomb.c_str(), "wb1");
  const std::string begun = city_2("").substr(0, city_2("").find("</"));
  const std::string blanks(1U << 20U, ' ');
  gzwrite(packed, begun.data(), static_cast<unsigned>(begun.size()));
  for (int i = 0; i < 200; ++i)
    gzwrite(packed, blanks.data(), static_cast<unsigned>(blanks.size()));
  gzclose(packed);
  EXPECT_THAT(io_error_of([&] { (void)read_citygml(bomb, {}); }),
              HasSubstr("unpacks to more than 100 times its size"));
  EXPECT_LT(test::processor_s() - begin_s, kMaxTime_s);
}

TEST_F(CityGml, FacesThatAreNamedOverAndOverAreRefused) {
  std::string content = building_2("A", solid_2(polygon_2("p", kRoofText)));
  for (int i = 0; i < 3; ++i)
    content += building_2(fmt::format("B{}", i), solid_2(reference_2("p")));
  EXPECT_THAT(error_of(city_2(content)), HasSubstr("over and over"));
}

}  // namespace
}  // namespace ridgeline::io
