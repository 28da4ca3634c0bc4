// SPDX-License-Identifier: BSD-3-Clause
#include "io/gdal/geopackage_writer.h"

#include "tests/support/temp_folder.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

namespace ridgeline::io {
namespace {

using testing::HasSubstr;

std::vector<MapLayer> some_map() {
  MapLayer lines{.name = "lines",
                 .description = "some lines",
                 .geometry = MapGeometry::kLine,
                 .columns = {{"n", ColumnType::kInteger64},
                             {"name", ColumnType::kText},
                             {"built", ColumnType::kDate},
                             {"ok", ColumnType::kBoolean}},
                 .features = {},
                 .style = {"by n", "<qgis/>", "<sld/>"}};
  lines.features.push_back({{{1, 2, 3}, {4, 5, 6}},
                            {{0, std::int64_t{7}},
                             {1,
                              "Stra\xDF"
                              "e"},  // Latin-1
                             {2, "1904/05/06"},
                             {3, std::int64_t{1}}}});
  lines.features.push_back({{}, {{1, "no place"}}});
  MapLayer areas{.name = "areas",
                 .description = "",
                 .geometry = MapGeometry::kPolygon,
                 .columns = {},
                 .features = {{{{0, 0, 1}, {4, 0, 1}, {0, 4, 2}}, {}}},
                 .style = {}};
  return {lines, areas};
}

GDALDatasetUniquePtr opened(const std::string& path) {
  GDALAllRegister();
  return GDALDatasetUniquePtr(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
}

TEST(GeopackageWriter, WritesLayersWithTypedColumnsAndHeights) {
  const TempFolder folder;
  write_geopackage(folder.file("map.gpkg"), {"EPSG:25832"}, some_map());
  EXPECT_EQ(folder.num_files(), 1U);
  const auto dataset = opened(folder.file("map.gpkg"));
  ASSERT_TRUE(dataset);
  OGRLayer* lines = dataset->GetLayerByName("lines");
  ASSERT_NE(lines, nullptr);
  EXPECT_STREQ(lines->GetSpatialRef()->GetAuthorityCode(nullptr), "25832");
  EXPECT_EQ(lines->GetLayerDefn()->GetFieldDefn(2)->GetType(), OFTDate);
  EXPECT_EQ(lines->GetLayerDefn()->GetFieldDefn(3)->GetSubType(), OFSTBoolean);
  const OGRFeatureUniquePtr first(lines->GetFeature(1));
  EXPECT_EQ(first->GetFieldAsInteger64("n"), 7);
  EXPECT_STREQ(first->GetFieldAsString("name"),
               "Stra\xC3\x9F"
               "e");
  EXPECT_STREQ(first->GetFieldAsString("built"), "1904/05/06");
  EXPECT_EQ(first->GetGeometryRef()->toLineString()->getZ(1), 6.0);
  const OGRFeatureUniquePtr second(lines->GetFeature(2));
  EXPECT_EQ(second->GetGeometryRef(), nullptr);
  EXPECT_FALSE(second->IsFieldSetAndNotNull(0));
  OGRLayer* areas = dataset->GetLayerByName("areas");
  const OGRFeatureUniquePtr area(areas->GetFeature(1));
  EXPECT_EQ(area->GetGeometryRef()->toPolygon()->getExteriorRing()->getNumPoints(), 4);
  EXPECT_EQ(area->GetGeometryRef()->toPolygon()->get_Area(), 8.0);
}

TEST(GeopackageWriter, WritesTheTableOfStylesThatQgisReads) {
  const TempFolder folder;
  write_geopackage(folder.file("map.gpkg"), {}, some_map());
  const auto dataset = opened(folder.file("map.gpkg"));
  OGRLayer* styles = dataset->GetLayerByName("layer_styles");
  ASSERT_NE(styles, nullptr);
  ASSERT_EQ(styles->GetFeatureCount(), 1);
  const OGRFeatureUniquePtr style(styles->GetFeature(1));
  EXPECT_STREQ(style->GetFieldAsString("f_table_name"), "lines");
  EXPECT_STREQ(style->GetFieldAsString("f_geometry_column"), "geom");
  EXPECT_STREQ(style->GetFieldAsString("styleQML"), "<qgis/>");
  EXPECT_EQ(style->GetFieldAsInteger("useAsDefault"), 1);
  // QGIS asks for these columns by `= ''`
  EXPECT_TRUE(style->IsFieldSetAndNotNull(style->GetFieldIndex("f_table_schema")));
}

TEST(GeopackageWriter, TheSameMapGivesTheSameBytes) {
  const TempFolder folder;
  write_geopackage(folder.file("a.gpkg"), {"EPSG:25832"}, some_map());
  write_geopackage(folder.file("b.gpkg"), {"EPSG:25832"}, some_map());
  EXPECT_EQ(folder.read("a.gpkg"), folder.read("b.gpkg"));
}

TEST(GeopackageWriter, LeavesNothingWhenItFails) {
  const TempFolder folder;
  std::vector<MapLayer> map = some_map();
  map[1].name = "LINES";
  EXPECT_THAT(io_error_of([&] { write_geopackage(folder.file("map.gpkg"), {}, map); }),
              HasSubstr("map.gpkg: cannot be written"));
  EXPECT_EQ(folder.num_files(), 0U);
}

}  // namespace
}  // namespace ridgeline::io
