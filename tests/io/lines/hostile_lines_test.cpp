// SPDX-License-Identifier: BSD-3-Clause
// Small files that would take all memory or never end.
#include "io/files/input_file.h"
#include "io/files/yaml_check.h"
#include "io/lines/read_lines.h"
#include "io/lines/write_lines.h"
#include "tests/support/run_program.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <memory>

namespace ridgeline::io {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string reading_error(const std::string& path) {
  return io_error_of([&] { (void)read_lines(path); });
}

/// A GeoPackage with the layer `lines`, as the program writes it.
std::string write_package(const TempFolder& folder) {
  LineSet set;
  set.crs.definition = "EPSG:25832";
  set.lines.resize(3);
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    set.lines[i].id = std::to_string(i);
    set.lines[i].segment_in_world = {{1.0, 2.0, 3.0}, {4.0, 6.0, 3.0}};
  }
  write_lines(folder.file("lines.gpkg"), set, LineFormat::kGeoPackage);
  return folder.file("lines.gpkg");
}

void execute(const std::string& path, const std::string& sql) {
  sqlite3* raw = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &raw), SQLITE_OK);
  const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> database(raw, sqlite3_close);
  ASSERT_EQ(sqlite3_exec(raw, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(raw);
}

/// Name of the package's layer and of its geometry column.
std::pair<std::string, std::string> layer_of(const std::string& path) {
  sqlite3* raw = nullptr;
  EXPECT_EQ(sqlite3_open(path.c_str(), &raw), SQLITE_OK);
  std::pair<std::string, std::string> names;
  const auto keep = [](void* result, int, char** values, char**) {
    *static_cast<std::pair<std::string, std::string>*>(result) = {values[0], values[1]};
    return 0;
  };
  sqlite3_exec(raw, "SELECT table_name, column_name FROM gpkg_geometry_columns", keep, &names,
               nullptr);
  sqlite3_close(raw);
  return names;
}

TEST(ReadLines, RefusesALayerThatIsAView) {
  const TempFolder folder;
  const std::string path = write_package(folder);
  const auto [layer, geometry] = layer_of(path);
  ASSERT_EQ(reading_error(path), "");
  execute(path,
          fmt::format("ALTER TABLE \"{0}\" RENAME TO old; UPDATE gpkg_contents SET table_name "
                      "= '{0}'; CREATE VIEW \"{0}\" AS WITH RECURSIVE n(i) AS (SELECT 1 UNION "
                      "ALL SELECT i + 1 FROM n) SELECT i AS fid, {1} FROM n, old;",
                      layer, geometry));
  EXPECT_THAT(reading_error(path),
              AllOf(HasSubstr("layer " + layer + " is a view"), HasSubstr("plain table")));
}

TEST(ReadLines, RefusesAGeoPackageWhoseListOfLayersIsAView) {
  const TempFolder folder;
  const std::string path = write_package(folder);
  execute(
      path,
      "ALTER TABLE gpkg_contents RENAME TO old; CREATE VIEW gpkg_contents AS SELECT * FROM old;");
  EXPECT_THAT(reading_error(path), HasSubstr("its table gpkg_contents is a view"));
}

TEST(ReadLines, ReadsThePlainLayerBesideOneThatIsAView) {
  const TempFolder folder;
  const std::string path = write_package(folder);
  const auto [layer, geometry] = layer_of(path);
  execute(
      path,
      fmt::format("CREATE VIEW some AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 "
                  "FROM n) SELECT i AS OGC_FID, {1} FROM n, \"{0}\"; INSERT INTO gpkg_contents "
                  "(table_name, data_type, identifier, srs_id) VALUES ('some', 'features', 'some', "
                  "25832); INSERT INTO gpkg_geometry_columns SELECT 'some', column_name, "
                  "geometry_type_name, srs_id, z, m FROM gpkg_geometry_columns;",
                  layer, geometry));
  const LineSet set = read_lines(path);
  EXPECT_EQ(set.lines.size(), 3U);
  EXPECT_EQ(set.lines[0].id, "0");
  EXPECT_THAT(set.warnings, ::testing::ElementsAre(HasSubstr("ignored: layer some is a view")));
}

TEST(ReadLines, WarnsOfALayerThatIsListedButHasNoTable) {
  const TempFolder folder;
  const std::string path = write_package(folder);
  execute(
      path,
      "INSERT INTO gpkg_contents (table_name, data_type, identifier, srs_id) VALUES ('lost', "
      "'features', 'lost', 25832); INSERT INTO gpkg_geometry_columns SELECT 'lost', column_name, "
      "geometry_type_name, srs_id, z, m FROM gpkg_geometry_columns;");
  const LineSet set = read_lines(path);
  EXPECT_EQ(set.lines.size(), 3U);
  EXPECT_THAT(set.warnings,
              ::testing::ElementsAre(HasSubstr("layer lost is listed, but has no table")));
}

TEST(ReadLines, RefusesALayerWithAGeneratedColumn) {
  const TempFolder folder;
  const std::string path = write_package(folder);
  execute(path, fmt::format("ALTER TABLE \"{}\" ADD COLUMN big BLOB AS (zeroblob(900000000));",
                            layer_of(path).first));
  EXPECT_THAT(reading_error(path), HasSubstr("has the generated column big"));
}

TEST(ReadLines, RefusesPolylinesThatRepeatVerticesWithoutEnd) {
  const TempFolder folder;
  std::string obj = "v 0 0 0\nv 1 0 0\nl";
  for (int i = 0; i < 1'100'000; ++i) obj += " 1 2";
  EXPECT_THAT(reading_error(folder.write("a.obj", obj)), HasSubstr("a row of 4400002 bytes"));
  std::string rows = "v 0 0 0\nv 1 0 0\n";
  for (int i = 0; i < 200'000; ++i) rows += "l 1 2\n";
  EXPECT_THAT(reading_error(folder.write("b.obj", rows)), HasSubstr("too much memory"));
  std::string wkt = "LINESTRING Z (";
  for (int i = 0; i < 1'000'000; ++i) wkt += i % 2 == 0 ? "1 2 3," : "1 9 4,";
  EXPECT_THAT(reading_error(folder.write("a.wkt", wkt + "1 2 4)\n")), HasSubstr("too much memory"));
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty uchar x\nproperty uchar y\n"
      "property uchar z\nelement edge 200000\nproperty uchar vertex1\nproperty uchar vertex2\n"
      "end_header\n";
  EXPECT_THAT(reading_error(folder.write("a.ply", header + std::string(400'006, '\0'))),
              HasSubstr("too much memory"));
}

TEST(ReadLines, TakesAPolylineMadeToDivideAtItsEndsInTime) {
  const TempFolder folder;
  std::string wkt = "LINESTRING Z (0 0 0";
  constexpr int kVertices = test::kIsSanitized ? 30'000 : 300'000;
  for (int i = 1; i < kVertices; ++i)
    wkt += fmt::format(",{}.000000 {}.000000 1.000000", i, i % 2 == 0 ? i : -i);
  EXPECT_EQ(read_lines(folder.write("a.wkt", wkt + ")\n")).lines.size(), kVertices - 1U);
}

TEST(ReadLines, RefusesRowsOfFieldsWithoutEnd) {
  const TempFolder folder;
  EXPECT_THAT(reading_error(folder.write("a.csv", std::string(20'000, ','))),
              HasSubstr("more than 10000 fields"));
}

TEST(ReadLines, RefusesALongAttributeThatEachSegmentOfAPolylineWouldCopy) {
  const TempFolder folder;
  std::string csv = "class,wkt\n" + std::string(1'000'000, 'a') + ",\"LINESTRING Z (";
  for (int i = 0; i < 2000; ++i) csv += i % 2 == 0 ? "1 2 3," : "1 9 4,";
  EXPECT_THAT(reading_error(folder.write("a.csv", csv + "1 2 4)\"\n")),
              HasSubstr("too much memory"));
}

TEST(ReadLines, ReadsAPolylineOfAHundredThousandVertices) {
  constexpr std::size_t kVertices = test::kIsSanitized ? 10'000 : 100'000;
  const TempFolder folder;
  std::string csv = "wkt\n\"LINESTRING Z (";
  for (std::size_t i = 0; i < kVertices; ++i)
    csv += fmt::format("{}.123456 540300{}.1 250.123,", 513'000 + i, i % 2);
  const LineSet set = read_lines(folder.write("a.csv", csv + "1 2 4)\"\n"));
  EXPECT_EQ(set.lines.size(), kVertices);
}

TEST(ReadLines, RefusesWhatIsNoRegularFile) {
  const TempFolder folder;
  for (const char* ending : {"geojson", "gpkg", "shp", "dxf", "csv", "obj", "ply", "txt"}) {
    const std::string zero = folder.file(std::string("zero.") + ending);
    std::filesystem::create_symlink("/dev/zero", zero);
    EXPECT_THAT(reading_error(zero), HasSubstr("is a device, pipe or socket")) << ending;
    const std::string pipe = folder.file(std::string("pipe.") + ending);
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(reading_error(pipe), HasSubstr("is a device, pipe or socket")) << ending;
  }
}

TEST(LoadYaml, RefusesDevicesAndEndlessNesting) {
  const TempFolder folder;
  EXPECT_THAT(io_error_of([] { (void)load_yaml("/dev/zero"); }),
              HasSubstr("a device, pipe or socket"));
  const std::string deep = folder.write("deep.yaml", std::string(1'000'000, '['));
  EXPECT_THAT(io_error_of([&] { (void)load_yaml(deep); }), HasSubstr("deep.yaml"));
  const std::string flat = folder.write("flat.yaml", std::string(1'000'000, ','));
  EXPECT_THAT(io_error_of([&] { (void)load_yaml(flat); }), HasSubstr("1000000 values"));
  std::string blocks;
  for (int i = 0; i < 3000; ++i) blocks += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  const std::string indented = folder.write("indented.yaml", blocks);
  EXPECT_THAT(io_error_of([&] { (void)load_yaml(indented); }), HasSubstr("indented.yaml"));
}

TEST(ReadLines, RefusesDegreesBehindAnAssumedProjectedCrs) {
  const TempFolder folder;
  const std::string path = folder.write("a.csv", "9.17,48.78,250,9.1701,48.78,250\n");
  EXPECT_THAT(io_error_of([&] { (void)read_lines(path, {.assume_crs = {"EPSG:25832"}}); }),
              AllOf(HasSubstr("look like degrees"), HasSubstr("ETRS89 / UTM zone 32N")));
}

TEST(RequireWritable, TakesEveryFormatWhereGdalHasItsData) {
  for (const LineFormatInfo& info : line_formats()) EXPECT_NO_THROW(require_writable(info.format));
}

}  // namespace
}  // namespace ridgeline::io
