// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/read_lines.h"
#include "io/lines/write_lines.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <limits>
#include <random>
#include <tuple>

namespace ridgeline::io {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double kCoordinateToleranceM = 0.5001e-4;  // four decimals are written, rounded
constexpr double kCovarianceTolerance = 1e-5;        // six significant digits are written
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const Eigen::Vector3d kStuttgart{513000.0, 5403000.0, 250.0};

Eigen::Matrix<double, 6, 6> some_covariance(std::mt19937& rng) {
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  const Eigen::Matrix<double, 6, 6> root =
      Eigen::Matrix<double, 6, 6>::NullaryExpr([&] { return uniform(rng); });
  return root * root.transpose();
}

/// Lines at full map coordinates with every attribute set, and text that needs quoting.
LineSet some_lines() {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> uniform(-40.0, 40.0);
  const auto point = [&] {
    return Eigen::Vector3d(kStuttgart + Eigen::Vector3d(uniform(rng), uniform(rng), uniform(rng)));
  };
  LineSet set;
  set.crs.definition = "EPSG:25832";
  for (int i = 0; i < 50; ++i) {
    Line line;
    line.id = i == 7 ? "ridge, \"north\" \xC3\xA4" : "L" + std::to_string(i);
    line.segment_in_world = {point(), point()};
    line.line_class = i % 3 == 0 ? "aligned" : "not_aligned";
    line.method = "joint";
    line.kind = "ridge";
    line.building = "house " + std::to_string(i / 10);
    line.status = "evaluated";
    line.base_id = std::to_string(i);
    line.other_id = std::to_string(2 * i);
    line.epipolar_angle_deg = 0.5 * i;
    line.n_points = i;
    line.n_images = 5;
    line.class_base = i % 2 == 0 ? "aligned" : "not_aligned";
    for (const char* image : {"strip1", "strip 2", "cross_\xC3\xA4"})
      line.observations.push_back({image, {{0.25 * i, 8.5}, {1000.0 - i, 700.125}}});
    line.plane_ids = {i, i + 1};
    line.support = 1.0 - 0.015625 * i;
    line.moved_out_m = 0.0625 * i;
    line.covariance_m2 = some_covariance(rng);
    set.lines.push_back(line);
  }
  return set;
}

bool has_attributes(LineFormat format) {
  return format != LineFormat::kDxf && format != LineFormat::kObj && format != LineFormat::kPly;
}
bool has_covariance(LineFormat format) {
  return has_attributes(format) && format != LineFormat::kShapefile;
}
bool has_crs(LineFormat format) {
  return format == LineFormat::kGeoJson || format == LineFormat::kGeoPackage ||
         format == LineFormat::kShapefile;
}

bool has_lines_of_nowhere(LineFormat format) {
  return has_attributes(format) && format != LineFormat::kCsv;
}

class LineFormats : public ::testing::TestWithParam<LineFormatInfo> {
 protected:
  [[nodiscard]] std::string name(const std::string& stem) const {
    return stem + std::string(GetParam().extension);
  }
  [[nodiscard]] LineSet written_and_read(const LineSet& set) const {
    write_lines(folder_.file(name("lines")), set, GetParam().format);
    return read_lines(folder_.file(name("lines")));
  }
  TempFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(ReadLines,
                         LineFormats,
                         ::testing::ValuesIn(line_formats().begin(), line_formats().end()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(LineFormats, KeepTenthsOfAMillimetreAtMapCoordinates) {
  const LineSet expected = some_lines();
  const LineSet actual = written_and_read(expected);
  ASSERT_EQ(actual.lines.size(), expected.lines.size());
  for (std::size_t i = 0; i < expected.lines.size(); ++i) {
    const Segment3& a = actual.lines[i].segment_in_world;
    const Segment3& b = expected.lines[i].segment_in_world;
    EXPECT_LE((a.start - b.start).cwiseAbs().maxCoeff(), kCoordinateToleranceM) << i;
    EXPECT_LE((a.end - b.end).cwiseAbs().maxCoeff(), kCoordinateToleranceM) << i;
  }
  EXPECT_THAT(actual.warnings, IsEmpty());
}

TEST_P(LineFormats, KeepAttributesWhereTheFormatHasThem) {
  const LineSet expected = some_lines();
  const LineSet actual = written_and_read(expected);
  ASSERT_EQ(actual.lines.size(), expected.lines.size());
  for (std::size_t i = 0; i < expected.lines.size(); ++i) {
    const Line& a = actual.lines[i];
    const Line& b = expected.lines[i];
    if (GetParam().format == LineFormat::kDxf) {
      EXPECT_EQ(a.line_class, b.line_class);
    }
    if (!has_attributes(GetParam().format)) continue;
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.line_class, b.line_class);
    EXPECT_EQ(a.class_base, b.class_base);
    EXPECT_EQ(a.method, b.method);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.building, b.building);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.base_id, b.base_id);
    EXPECT_EQ(a.other_id, b.other_id);
    EXPECT_EQ(a.epipolar_angle_deg, b.epipolar_angle_deg);
    EXPECT_EQ(a.n_points, b.n_points);
    EXPECT_EQ(a.n_images, b.n_images);
    EXPECT_EQ(a.plane_ids, b.plane_ids);
  }
}

TEST_P(LineFormats, KeepTheCovarianceWhereTheFormatHasRoomForIt) {
  const LineSet expected = some_lines();
  const LineSet actual = written_and_read(expected);
  ASSERT_EQ(actual.lines.size(), expected.lines.size());
  for (std::size_t i = 0; i < expected.lines.size(); ++i) {
    ASSERT_EQ(actual.lines[i].covariance_m2.has_value(), has_covariance(GetParam().format));
    if (!has_covariance(GetParam().format)) continue;
    EXPECT_TRUE(actual.lines[i].covariance_m2->isApprox(*expected.lines[i].covariance_m2,
                                                        kCovarianceTolerance));
  }
}

TEST_P(LineFormats, KeepSupportAndShiftOfScanEdgesWhereTheFormatHasRoomForThem) {
  const LineSet expected = some_lines();
  const LineSet actual = written_and_read(expected);
  ASSERT_EQ(actual.lines.size(), expected.lines.size());
  for (std::size_t i = 0; i < expected.lines.size(); ++i) {
    const Line& a = actual.lines[i];
    const Line& b = expected.lines[i];
    ASSERT_EQ(a.support.has_value(), has_covariance(GetParam().format));
    ASSERT_EQ(a.moved_out_m.has_value(), has_covariance(GetParam().format));
    if (!a.support) continue;
    EXPECT_NEAR(*a.support, *b.support, kCoordinateToleranceM);
    EXPECT_NEAR(*a.moved_out_m, *b.moved_out_m, kCoordinateToleranceM);
  }
}

TEST_P(LineFormats, InDxfLinesWithoutAClassAreOnTheLayerOfTheirKind) {
  if (GetParam().format != LineFormat::kDxf) return;
  LineSet set = some_lines();
  for (Line& line : set.lines) line.line_class.clear();
  for (const Line& line : written_and_read(set).lines) EXPECT_EQ(line.line_class, "ridge");
}

TEST_P(LineFormats, KeepTheObservationsWhereTheFormatHasRoomForThem) {
  const LineSet expected = some_lines();
  const LineSet actual = written_and_read(expected);
  ASSERT_EQ(actual.lines.size(), expected.lines.size());
  const bool has_observations =
      GetParam().format == LineFormat::kGeoJson || GetParam().format == LineFormat::kGeoPackage;
  for (std::size_t i = 0; i < expected.lines.size(); ++i) {
    const std::vector<LineObservation>& a = actual.lines[i].observations;
    const std::vector<LineObservation>& b = expected.lines[i].observations;
    ASSERT_EQ(a.size(), has_observations ? b.size() : 0U);
    for (std::size_t s = 0; s < a.size(); ++s) {
      EXPECT_EQ(a[s].image, b[s].image);
      EXPECT_EQ(a[s].px.start, b[s].px.start);  // three decimals hold them exactly
      EXPECT_EQ(a[s].px.end, b[s].px.end);
    }
  }
}

TEST_P(LineFormats, KeepTheCrsWhereTheFormatHasOne) {
  const LineSet expected = some_lines();
  const LineSet actual = written_and_read(expected);
  EXPECT_EQ(actual.crs.known(), has_crs(GetParam().format));
  if (actual.crs.known()) {
    EXPECT_TRUE(compare(actual.crs, expected.crs).compatible) << actual.crs.definition;
  }
}

TEST_P(LineFormats, GiveTheSameBytesForTheSameLines) {
  const LineSet set = some_lines();
  std::filesystem::create_directory(folder_.file("first"));
  std::filesystem::create_directory(folder_.file("second"));
  write_lines(folder_.file(name("first/lines")), set, GetParam().format);
  write_lines(folder_.file(name("second/lines")), set, GetParam().format);
  for (const auto& entry : std::filesystem::directory_iterator(folder_.file("first"))) {
    const std::string file = entry.path().filename().string();
    EXPECT_FALSE(folder_.read("first/" + file).empty()) << file;
    EXPECT_TRUE(folder_.read("first/" + file) == folder_.read("second/" + file)) << file;
  }
}

TEST_P(LineFormats, HoldNoLinesAsAValidResult) {
  LineSet none;
  none.crs.definition = "EPSG:25832";
  const LineSet actual = written_and_read(none);
  EXPECT_THAT(actual.lines, IsEmpty());
  EXPECT_THAT(actual.warnings, Contains(HasSubstr("no lines")));
}

TEST_P(LineFormats, KeepLinesThatAreNotFiniteWhereTheyHaveAPlaceForThem) {
  LineSet set = some_lines();
  set.lines[1].segment_in_world.end.y() = kNaN;
  set.lines[1].status.clear();
  const LineSet actual = written_and_read(set);
  if (!has_lines_of_nowhere(GetParam().format)) {
    EXPECT_EQ(actual.lines.size(), 49U);
    EXPECT_THAT(actual.warnings, Not(Contains(HasSubstr("not finite"))));
    EXPECT_EQ(write_lines(folder_.file(name("again")), set, GetParam().format), 1U);
    EXPECT_THAT(folder_.read(name("again")), Not(HasSubstr("nan")));
    return;
  }
  ASSERT_EQ(actual.lines.size(), set.lines.size());
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    EXPECT_EQ(all_finite(actual.lines[i].segment_in_world), i != 1) << i;
  }
  EXPECT_THAT(actual.warnings, Contains(HasSubstr("1 of 50 lines")));
  EXPECT_EQ(write_lines(folder_.file(name("again")), set, GetParam().format), 0U);
}

TEST(MeshLines, StateTheirSystemAndOriginInComments) {
  const TempFolder folder;
  const LineSet set = some_lines();
  const Eigen::Vector3d first = set.lines[0].segment_in_world.start;
  for (const auto& [format, name, comment] :
       {std::tuple(LineFormat::kObj, "a.obj", "# "), {LineFormat::kPly, "a.ply", "comment "}}) {
    write_lines(folder.file(name), set, format);
    EXPECT_THAT(folder.read(name), HasSubstr(std::string(comment) + "crs EPSG:25832\n"));
    EXPECT_THAT(folder.read(name), Not(HasSubstr("origin")));
    write_lines(folder.file(name), set, format, {.local_origin = true});
    EXPECT_THAT(folder.read(name),
                HasSubstr(std::string(comment) +
                          "origin 512900 5402900 200, to be added to the coordinates\n"));
    const Eigen::Vector3d start = read_lines(folder.file(name)).lines[0].segment_in_world.start;
    EXPECT_LT((start + Eigen::Vector3d(512900, 5402900, 200) - first).norm(),
              2.0 * kCoordinateToleranceM);
  }
}

TEST_P(LineFormats, LeaveNothingBehindWhereTheyCannotBeWritten) {
  const std::string path = folder_.write("file", "x") + "/" + name("lines");
  EXPECT_NE(io_error_of([&] { write_lines(path, some_lines(), GetParam().format); }), "");
  EXPECT_EQ(folder_.num_files(), 1U);
}

TEST_P(LineFormats, MakeMissingFolders) {
  write_lines(folder_.file(name("new/folder/lines")), some_lines(), GetParam().format);
  EXPECT_EQ(read_lines(folder_.file(name("new/folder/lines"))).lines.size(), 50U);
}

TEST_P(LineFormats, ReplaceAnOlderFileWhole) {
  LineSet few = some_lines();
  few.lines.resize(2);
  write_lines(folder_.file(name("lines")), some_lines(), GetParam().format);
  EXPECT_EQ(written_and_read(few).lines.size(), 2U);
}

TEST(LineFormats, GeoJsonWithoutCrsIsNowhereOnEarthForOthersAndWithoutCrsForUs) {
  const TempFolder folder;
  LineSet set = some_lines();
  set.crs = {};
  const std::string path = folder.file("lines.geojson");
  write_lines(path, set, LineFormat::kGeoJson);
  GDALAllRegister();
  const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(file);
  // GDAL takes GeoJSON that states nothing, or null, for degrees
  const OGRSpatialReference* reference = file->GetLayer(0)->GetSpatialRef();
  EXPECT_TRUE(reference == nullptr || reference->IsLocal() != 0);
  const LineSet back = read_lines(path);
  EXPECT_FALSE(back.crs.known());
  EXPECT_THAT(back.warnings, IsEmpty());
}

}  // namespace
}  // namespace ridgeline::io
