// SPDX-License-Identifier: BSD-3-Clause
// What a file states of its lines is kept column by column, with its types.
#include "io/gdal/attribute_table.h"

#include "io/lines/read_lines.h"
#include "tests/support/temp_folder.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include <map>
#include <optional>

namespace ridgeline::io {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> names_of(const LineSet& set) {
  std::vector<std::string> names;
  for (const Column& column : set.features.columns) names.push_back(column.name);
  return names;
}

ColumnType type_of(const LineSet& set, const std::string& name) {
  for (const Column& column : set.features.columns) {
    if (column.name == name) return column.type;
  }
  throw std::invalid_argument(name);
}

/// The value of a column for a line; empty if the feature of the line has none.
Value value_of(const LineSet& set, std::size_t line, const std::string& name) {
  for (const auto& [column, value] : set.features.rows.at(set.lines.at(line).row)) {
    if (set.features.columns[column].name == name) return value;
  }
  return {};
}

TEST(TypeOfWord, IsThatOfANumberThatGivesTheWordBack) {
  EXPECT_EQ(type_of_word("12"), ColumnType::kInteger64);
  EXPECT_EQ(type_of_word("-3"), ColumnType::kInteger64);
  EXPECT_EQ(type_of_word("1.50"), ColumnType::kReal);
  EXPECT_EQ(type_of_word("1e3"), ColumnType::kReal);
  for (const char* text : {"007", "+1", "-0", "12345678901234567890", "nan", "1 m", "+0.5"}) {
    EXPECT_EQ(type_of_word(text), ColumnType::kText) << text;
  }
}

TEST(AttributesOfCsv, AreNumbersWhereAllAreNumbers) {
  const TempFolder folder;
  const LineSet set = read_lines(folder.write("lines.csv",
                                              "Name,x1,y1,z1,x2,y2,z2,code,width,n,mixed\n"
                                              "a,0,0,1,4,0,1,007,1.5,3,1\n"
                                              "b,0,1,1,4,1,1,008,2,,x\n"));
  EXPECT_THAT(names_of(set), ElementsAre("Name", "code", "width", "n", "mixed"));
  EXPECT_EQ(value_of(set, 0, "code"), Value("007"));
  EXPECT_EQ(value_of(set, 1, "width"), Value(2.0));
  EXPECT_EQ(value_of(set, 0, "n"), Value(std::int64_t{3}));
  EXPECT_EQ(value_of(set, 1, "n"), Value());
  EXPECT_EQ(value_of(set, 0, "mixed"), Value("1"));
}

TEST(AttributesOfGeoJson, HaveTheTypesOfTheirValues) {
  const TempFolder folder;
  const auto feature = [](const char* id, const char* properties) {
    return std::string(R"({"type":"Feature",)") + id + R"("properties":)" + properties +
           R"(,"geometry":{"type":"LineString","coordinates":[[0,0,1],[4,0,1],[4,3,1]]}})";
  };
  const LineSet set = read_lines(folder.write(
      "lines.geojson", R"({"type":"FeatureCollection","crs":null,"features":[)" +
                           feature("", R"({"n":1,"x":1,"ok":true,"list":[1,2],"big":1e300})") +
                           "," + feature(R"("id":17,)", R"({"n":2,"x":1.5,"ok":null,"who":"me"})") +
                           "]}"));
  ASSERT_EQ(set.lines.size(), 4U);
  EXPECT_EQ(type_of(set, "n"), ColumnType::kInteger64);
  EXPECT_EQ(type_of(set, "x"), ColumnType::kReal);
  EXPECT_EQ(type_of(set, "ok"), ColumnType::kBoolean);
  EXPECT_EQ(value_of(set, 0, "x"), Value(1.0));
  EXPECT_EQ(value_of(set, 0, "list"), Value("[1,2]"));
  EXPECT_EQ(value_of(set, 2, "ok"), Value());
  // both parts of a polyline belong to its feature
  EXPECT_EQ(value_of(set, 3, "who"), Value("me"));
  EXPECT_EQ(set.lines[3].part, 1);
  EXPECT_EQ(set.lines[3].source_fid, 17);
  EXPECT_EQ(set.lines[1].source_fid, 0);
  EXPECT_EQ(set.lines[3].id, "17.1");
}

/// Writes a GeoPackage with GDAL alone: layers of lines with one column of each type.
void write_typed(const std::string& path,
                 const std::vector<std::string>& layers,
                 const char* age = "age") {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  GDALDatasetUniquePtr dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  for (const std::string& name : layers) {
    OGRLayer* layer = dataset->CreateLayer(name.c_str(), nullptr, wkbLineString25D, nullptr);
    const std::map<const char*, OGRFieldType> fields{
        {age, OFTInteger},  {"big", OFTInteger64}, {"built", OFTDate}, {"seen", OFTDateTime},
        {"share", OFTReal}, {"street", OFTString}, {"blob", OFTBinary}};
    for (const auto& [field, type] : fields) {
      OGRFieldDefn definition(field, type);
      ASSERT_EQ(layer->CreateField(&definition), OGRERR_NONE);
    }
    OGRFieldDefn flag("listed", OFTInteger);
    flag.SetSubType(OFSTBoolean);
    ASSERT_EQ(layer->CreateField(&flag), OGRERR_NONE);
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetField(age, 120);
    feature.SetField("big", GIntBig{1} << 40);
    feature.SetField("built", "1904/05/06");
    feature.SetField("seen", "2026/11/24 10:00:00");
    feature.SetField("share", 0.25);
    feature.SetField("street",
                     "Hauptstra\xC3\x9F"
                     "e");
    const GByte bytes[] = {1, 0, 2};
    feature.SetField(feature.GetFieldIndex("blob"), 3, bytes);
    feature.SetField("listed", 1);
    OGRLineString line;
    line.addPoint(0, 0, 1);
    line.addPoint(4, 0, 1);
    feature.SetGeometry(&line);
    ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
  }
}

TEST(AttributesOfGeoPackage, KeepTheirTypes) {
  const TempFolder folder;
  write_typed(folder.file("roads.gpkg"), {"roads"});
  const LineSet set = read_lines(folder.file("roads.gpkg"));
  EXPECT_EQ(type_of(set, "age"), ColumnType::kInteger);
  EXPECT_EQ(type_of(set, "big"), ColumnType::kInteger64);
  EXPECT_EQ(type_of(set, "built"), ColumnType::kDate);
  EXPECT_EQ(type_of(set, "seen"), ColumnType::kDateTime);
  EXPECT_EQ(type_of(set, "share"), ColumnType::kReal);
  EXPECT_EQ(type_of(set, "street"), ColumnType::kText);
  EXPECT_EQ(type_of(set, "listed"), ColumnType::kBoolean);
  EXPECT_EQ(value_of(set, 0, "big"), Value(std::int64_t{1} << 40));
  EXPECT_EQ(value_of(set, 0, "built"), Value("1904/05/06"));
  EXPECT_EQ(value_of(set, 0, "blob"), Value(std::string("\1\0\2", 3)));
  // GeoPackages count their features from 1
  EXPECT_EQ(set.lines[0].id, "1");
  EXPECT_EQ(set.lines[0].source_fid, 1);
}

TEST(AttributesOfGeoPackage, IdsOfSeveralLayersNameTheirLayer) {
  const TempFolder folder;
  write_typed(folder.file("all.gpkg"), {"roads", "roofs"});
  const LineSet set = read_lines(folder.file("all.gpkg"));
  ASSERT_EQ(set.lines.size(), 2U);
  EXPECT_EQ(set.lines[0].id, "roads.1");
  EXPECT_EQ(set.lines[1].id, "roofs.1");
  EXPECT_THAT(set.warnings, IsEmpty());
}

TEST(AttributesOfGeoPackage, OwnIdsThatLayersShareNameTheirLayer) {
  const TempFolder folder;
  write_typed(folder.file("all.gpkg"), {"roads", "roofs"}, "id");
  const LineSet set = read_lines(folder.file("all.gpkg"));
  ASSERT_EQ(set.lines.size(), 2U);
  EXPECT_EQ(set.lines[0].id, "roads.120");
  EXPECT_EQ(set.lines[1].id, "roofs.120");
  EXPECT_THAT(set.warnings,
              ElementsAre("ids repeat across layers; they are prefixed with the layer: roads.120"));
}

TEST(AttributesOfGeoPackage, OfSeveralLayersTheOneCalledLinesIsRead) {
  const TempFolder folder;
  write_typed(folder.file("map.gpkg"), {"vectors", "lines"});
  const LineSet set = read_lines(folder.file("map.gpkg"));
  ASSERT_EQ(set.lines.size(), 1U);
  EXPECT_EQ(set.lines[0].id, "1");
  EXPECT_THAT(set.warnings, ElementsAre("reading layer lines; ignored: vectors"));
}

}  // namespace
}  // namespace ridgeline::io
