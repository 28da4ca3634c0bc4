// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/map_lines.h"

#include "io/gdal/geopackage_writer.h"
#include "io/lines/write_lines.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using ::testing::HasSubstr;

std::vector<MapLine> lines_of_map(const std::string& path) {
  std::vector<MapLine> lines;
  for_each_map_line(path, [&](const MapLine& line) { lines.push_back(line); });
  return lines;
}

TEST(MapLines, AreReadWithTheirJudgementInTheirOrder) {
  const TempFolder folder;
  MapLayer layer;
  layer.name = "lines";
  layer.columns = {{"line_id", ColumnType::kText},
                   {"status", ColumnType::kText},
                   {"mean_distance_m", ColumnType::kReal},
                   {"n_images", ColumnType::kInteger}};
  layer.features = {
      {{{1, 2, 3}, {4, 5, 6}},
       {{0, std::string("b")}, {1, std::string("evaluated")}, {2, 0.25}, {3, std::int64_t{4}}}},
      {{}, {{0, std::string("without a place")}}},
      {{{1, 2, 3}, {4, 5, 7}}, {{0, std::string("a")}}}};
  MapLayer planes;
  planes.name = "planes";
  planes.geometry = MapGeometry::kPolygon;
  write_geopackage(folder.file("map.gpkg"), {"EPSG:25832"}, {planes, layer});
  const std::vector<MapLine> lines = lines_of_map(folder.file("map.gpkg"));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].id, "b");
  EXPECT_EQ(lines[0].status, "evaluated");
  EXPECT_EQ(lines[0].mean_distance_m, 0.25);
  EXPECT_EQ(lines[0].n_images, 4);
  EXPECT_EQ(lines[0].segment_in_map.end, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(lines[1].id, "a");
  EXPECT_FALSE(lines[1].mean_distance_m);
}

TEST(MapLines, OfAFileOfLinesHaveNoStatusOfAJudgement) {
  const TempFolder folder;
  LineSet set;
  Line line;
  line.id = "7";
  line.status = "direct";
  line.line_class = "aligned";
  line.segment_in_world = {{1, 2, 3}, {4, 5, 6}};
  set.lines.push_back(line);
  (void)write_lines(folder.file("lines.gpkg"), set, LineFormat::kGeoPackage);
  const std::vector<MapLine> lines = lines_of_map(folder.file("lines.gpkg"));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].id, "7");
  EXPECT_EQ(lines[0].line_class, "aligned");
  EXPECT_EQ(lines[0].status, "");
}

TEST(MapLines, OfAFileThatIsNoMapAreRefused) {
  const TempFolder folder;
  const std::string file = folder.write("map.gpkg", "no map");
  EXPECT_THAT(io_error_of([&] { (void)lines_of_map(file); }), HasSubstr("is not a map of lines"));
  EXPECT_THAT(io_error_of([&] { (void)lines_of_map(folder.file("none.gpkg")); }),
              HasSubstr("none.gpkg"));
}

}  // namespace
}  // namespace ridgeline::io
