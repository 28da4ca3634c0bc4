// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/read_cloud.h"

#include "io/cloud/cloud_files.h"
#include "io/cloud/las_writer.h"
#include "tests/io/cloud/las_bytes.h"
#include "tests/support/random.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace ridgeline::io {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

CloudPoint point_at(double x, double y, double z, std::uint8_t classification = 6) {
  return {.x = x,
          .y = y,
          .z = z,
          .intensity = 0,
          .classification = classification,
          .return_number = 1,
          .number_of_returns = 1,
          .flags = 0,
          .source_id = 0};
}

/// Points on the millimetre grid, so that LAS keeps them exactly.
std::vector<CloudPoint> random_points(std::size_t count, std::uint64_t seed = 1) {
  test::Random random(seed);
  std::vector<CloudPoint> points;
  const auto millimetres = [&] { return std::round(random.uniform(-4e4, 4e4)) * 0.001; };
  for (std::size_t i = 0; i < count; ++i) {
    const double x = millimetres();
    const double y = millimetres();
    points.push_back(point_at(x, y, millimetres(), static_cast<std::uint8_t>(random.bits() % 9)));
  }
  return points;
}

class ReadCloud : public testing::Test {
 protected:
  std::string write(const std::string& name,
                    const std::vector<CloudPoint>& points,
                    const Eigen::Vector3d& origin_m = Eigen::Vector3d::Zero(),
                    const Crs& crs = {"EPSG:25832"}) const {
    write_las(folder_.file(name), points, {.origin_m = origin_m}, crs);
    return folder_.file(name);
  }

  TempFolder folder_;
};

TEST_F(ReadCloud, KeepsFilesAndRecordsInOrder) {
  const std::string b = write("b.las", {point_at(1, 0, 0), point_at(2, 0, 0)});
  const std::string a = write("a.las", {point_at(3, 0, 0)});
  const PointCloud listed = read_cloud({b, a});
  ASSERT_EQ(listed.points.size(), 3U);
  EXPECT_EQ(listed.points[0].x, 1.0);
  EXPECT_EQ(listed.points[2].x, 3.0);
  EXPECT_EQ(listed.n_read, 3U);
  EXPECT_EQ(describe(listed.crs).name, "ETRS89 / UTM zone 32N");
  EXPECT_THAT(listed.warnings, testing::IsEmpty());
  const PointCloud matched = read_cloud({folder_.file("[ab].las")});
  EXPECT_EQ(matched.points[0].x, 3.0);  // a.las comes first by name
}

TEST_F(ReadCloud, PatternWithoutMatchIsAnErrorNamingIt) {
  EXPECT_THAT(io_error_of([&] { read_cloud({folder_.file("*.las")}); }),
              AllOf(HasSubstr("*.las"), HasSubstr("matches no file")));
  EXPECT_THAT(io_error_of([&] { read_cloud({folder_.file("tile.las")}); }),
              HasSubstr("does not exist"));
  EXPECT_THAT(io_error_of([&] { read_cloud({folder_.file("")}); }),
              HasSubstr("is not a regular file"));
}

TEST_F(ReadCloud, AFileMayBeNamedLikeAPattern) {
  EXPECT_EQ(read_cloud({write("tile[1].las", {point_at(0, 0, 0)})}).points.size(), 1U);
}

TEST_F(ReadCloud, RefusesOptionsThatContradict) {
  const std::string path = write("a.las", {point_at(0, 0, 0)});
  ReadOptions options;
  options.near = PlanMask({}, 1.0);
  EXPECT_THROW(read_cloud({path}, options), std::invalid_argument);
  EXPECT_THROW(read_cloud({}), std::invalid_argument);
  options = {};
  options.bounds_in_file = Eigen::AlignedBox3d();
  EXPECT_THROW(read_cloud({path}, options), std::invalid_argument);
}

TEST_F(ReadCloud, DropsNoiseAndWithheldUnlessTold) {
  std::vector<CloudPoint> points{point_at(0, 0, 0, 6), point_at(1, 0, 0, 7), point_at(2, 0, 0, 18),
                                 point_at(3, 0, 0, 2), point_at(4, 0, 0, 7)};
  points[3].flags = 4;
  points[4].flags = 4;
  const std::string path = write("a.las", points);
  const PointCloud cloud = read_cloud({path});
  EXPECT_EQ(cloud.points.size(), 1U);
  EXPECT_EQ(cloud.n_dropped_class, 2U);
  EXPECT_EQ(cloud.n_dropped_withheld, 2U);  // counted once, by the first reason
  ReadOptions options;
  options.exclude_withheld = false;
  EXPECT_EQ(read_cloud({path}, options).points.size(), 2U);
  options.classes = {7};
  const PointCloud noise = read_cloud({path}, options);
  EXPECT_EQ(noise.points.size(), 2U);
  EXPECT_EQ(noise.n_dropped_class, 3U);
}

TEST_F(ReadCloud, KeepsLastReturns) {
  std::vector<CloudPoint> points(4, point_at(0, 0, 0));
  points[0].number_of_returns = 2;
  points[1].number_of_returns = points[1].return_number = 2;
  points[3].return_number = 5;  // above the number of returns: kept
  ReadOptions options;
  options.last_returns = true;
  const PointCloud cloud = read_cloud({write("a.las", points)}, options);
  EXPECT_EQ(cloud.points.size(), 3U);
  EXPECT_EQ(cloud.n_dropped_return, 1U);
}

TEST_F(ReadCloud, KeepsPointsInTheWorldBox) {
  ReadOptions options;
  options.bounds_in_file =
      Eigen::AlignedBox3d(Eigen::Vector3d(1000, 2000, -10), Eigen::Vector3d(1001, 2001, 10));
  const PointCloud cloud = read_cloud(
      {write("a.las", {point_at(1, 1, 0), point_at(2, 1, 0), point_at(1, 1, 11)}, {1000, 2000, 0})},
      options);
  EXPECT_EQ(cloud.points.size(), 1U);
  EXPECT_EQ(cloud.n_dropped_bounds, 2U);
}

TEST_F(ReadCloud, KeepsPointsNearLines) {
  const std::string path = write("a.las", random_points(20000));
  const std::vector<Segment2> lines{{{-5, -5}, {5, 5}}};
  ReadOptions options;
  options.frame = LocalFrame{};
  const PointCloud whole = read_cloud({path}, options);
  options.near = PlanMask(lines, 2.0);
  const PointCloud near = read_cloud({path}, options);
  std::size_t n_within = 0;
  for (const CloudPoint& point : whole.points) {
    if (distance(lines[0], {point.x, point.y}) <= 2.0) ++n_within;
  }
  EXPECT_GE(near.points.size(), n_within);
  EXPECT_LT(near.points.size(), whole.points.size() / 10);
  EXPECT_EQ(near.points.size() + near.n_dropped_bounds + near.n_dropped_class, near.n_read);
}

TEST_F(ReadCloud, OriginIsTheMedianRoundedTo100m) {
  std::vector<CloudPoint> points(101, point_at(40, 60, 251));
  points[0] = point_at(9e5, 0, 0);  // a stray point must not move it
  const PointCloud cloud = read_cloud({write("a.las", points, {513000, 5403000, 0})});
  EXPECT_EQ(cloud.frame.origin_m, Eigen::Vector3d(513000, 5403100, 300));
  EXPECT_EQ(suggest_frame({folder_.file("a.las")}).origin_m, cloud.frame.origin_m);
}

TEST_F(ReadCloud, OriginComesFromTheFirstFileWithPoints) {
  write("a.las", {});
  write("b.las", {point_at(0, 0, 0)}, {700, 800, 900});
  write("c.las", {point_at(0, 0, 0)}, {7000, 8000, 9000});
  const PointCloud cloud = read_cloud({folder_.file("*.las")});
  EXPECT_EQ(cloud.frame.origin_m, Eigen::Vector3d(700, 800, 900));
  EXPECT_EQ(cloud.points[1].x, 6300.0);
  EXPECT_THAT(cloud.warnings, ElementsAre(HasSubstr("a.las: has no points")));
}

TEST_F(ReadCloud, IntegerShiftChangesNothing) {
  constexpr double kToleranceM = 1e-9;  // one unit in the last place of a northing
  const Eigen::Vector3d shift(513000, 5403000, 250);
  const std::vector<CloudPoint> points = random_points(1000);
  ReadOptions options;
  options.frame = LocalFrame{.origin_m = {12, -7, 3}};
  const PointCloud plain = read_cloud({write("a.las", points)}, options);
  options.frame->origin_m += shift;
  const PointCloud shifted = read_cloud({write("b.las", points, shift)}, options);
  ASSERT_EQ(plain.points.size(), shifted.points.size());
  for (std::size_t i = 0; i < plain.points.size(); ++i) {
    EXPECT_NEAR(plain.points[i].x, shifted.points[i].x, kToleranceM);
    EXPECT_NEAR(plain.points[i].y, shifted.points[i].y, kToleranceM);
    EXPECT_NEAR(plain.points[i].z, shifted.points[i].z, kToleranceM);
  }
}

TEST_F(ReadCloud, IsTheSameForAnyNumberOfThreads) {
  const std::string path = write("a.las", random_points(300000));
  const auto bytes = [&](std::size_t n_threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, n_threads);
    const PointCloud cloud = read_cloud({path});
    std::string text(cloud.points.size() * sizeof(CloudPoint), '\0');
    std::memcpy(text.data(), cloud.points.data(), text.size());
    return text;
  };
  EXPECT_EQ(bytes(1), bytes(4));
}

TEST_F(ReadCloud, RefusesMoreThanIsAllowed) {
  const std::string path = write("a.las", {point_at(0, 0, 0), point_at(1, 0, 0, 7)});
  ReadOptions options;
  options.max_points = 1;  // one of the two points is kept
  EXPECT_EQ(read_cloud({path}, options).points.size(), 1U);
  options.classes = {6, 7};
  EXPECT_THAT(io_error_of([&] { read_cloud({path}, options); }),
              AllOf(HasSubstr("2 points to keep"), HasSubstr("64 bytes"), HasSubstr("max_points")));
  options.max_points = 0;
  options.max_memory_bytes = 63;
  EXPECT_NE(io_error_of([&] { read_cloud({path}, options); }), "");
  options.max_memory_bytes = 64;
  EXPECT_EQ(read_cloud({path}, options).points.size(), 2U);
}

TEST_F(ReadCloud, RefusesDifferentReferenceSystemsNamingBoth) {
  write("a.las", {point_at(0, 0, 0)}, {0, 0, 0}, {"EPSG:25832"});
  write("b.las", {point_at(0, 0, 0)}, {0, 0, 0}, {"EPSG:25833"});
  EXPECT_THAT(
      io_error_of([&] { read_cloud({folder_.file("*.las")}); }),
      AllOf(HasSubstr("a.las"), HasSubstr("b.las"), HasSubstr("zone 32N"), HasSubstr("zone 33N")));
  ReadOptions options;
  options.assume_crs = {"EPSG:25832"};
  const PointCloud cloud = read_cloud({folder_.file("*.las")}, options);
  EXPECT_EQ(cloud.points.size(), 2U);
  EXPECT_THAT(cloud.warnings, ElementsAre(AllOf(HasSubstr("b.las"), HasSubstr("overrides"))));
}

TEST_F(ReadCloud, RefusesDegrees) {
  const std::string path = write("a.las", {point_at(7, 51, 0)}, {0, 0, 0}, {"EPSG:4326"});
  EXPECT_THAT(io_error_of([&] { read_cloud({path}); }),
              AllOf(HasSubstr("WGS 84"), HasSubstr("degrees")));
}

TEST_F(ReadCloud, ConvertsFeetByTheStatedFactor) {
  const PointCloud cloud =
      read_cloud({write("a.las", {point_at(1000, 0, 100)}, {0, 0, 0}, {"EPSG:2992+6360"})});
  constexpr double kToleranceM = 1e-9;
  const Eigen::Vector3d world =
      cloud.frame.world_from_local({cloud.points[0].x, cloud.points[0].y, cloud.points[0].z});
  EXPECT_NEAR(world.x(), 304.8, kToleranceM);
  EXPECT_NEAR(world.z(), 100.0 * 1200.0 / 3937.0, kToleranceM);
  EXPECT_EQ(cloud.horizontal_unit_m, 0.3048);
  EXPECT_NEAR(cloud.vertical_unit_m, 1200.0 / 3937.0, 1e-15);
}

TEST_F(ReadCloud, UnknownSystemIsWarnedOf) {
  const std::string path = write("a.las", {point_at(0, 0, 0)}, {0, 0, 0}, {});
  const PointCloud cloud = read_cloud({path});
  EXPECT_FALSE(cloud.crs.known());
  EXPECT_THAT(cloud.warnings, ElementsAre(HasSubstr("has no reference system")));
}

TEST_F(ReadCloud, WarnsOfWrongHeaderBoundsAndNeverUsesThem) {
  const std::string path = folder_.write("a.las", LasBytes(2, 0).add_point({7, 8, 9}).bytes());
  const PointCloud cloud = read_cloud({path});
  EXPECT_EQ(cloud.points.size(), 1U);
  EXPECT_THAT(cloud.warnings, Contains(AllOf(HasSubstr("header bounds are wrong"),
                                             HasSubstr("the points span x 1000.07"))));
}

/// A file of several blocks of points whose header bounds hold all points except a part in the
/// middle: a strip that the scanner left and came back to.
std::string strip_with_narrow_header() {
  constexpr std::int32_t kPoints = 200'000;
  LasBytes las(2, 0);
  for (std::int32_t i = 0; i < kPoints; ++i) {
    const bool is_away = i >= 33'000 && i < 43'000;
    las.add_point({is_away ? 37'000 + i : i % 1000, i % 777, 100});
  }
  const std::array<double, 6> bounds{1010.0, 1000.0, 2008.0, 2000.0, 1.0, 1.0};
  for (std::size_t i = 0; i < bounds.size(); ++i) las.set(179 + 8 * i, bounds[i]);
  return las.bytes();
}

TEST_F(ReadCloud, FindsThePointsThatAHeaderHides) {
  const std::string path = folder_.write("a.las", strip_with_narrow_header());
  ReadOptions options;
  options.frame = LocalFrame{};
  options.bounds_in_file = plan_bounds(std::array{1700.0, 1900.0, 1800.0, 2100.0});
  const PointCloud cloud = read_cloud({path}, options);
  EXPECT_EQ(cloud.points.size(), 10'000U);
  EXPECT_THAT(cloud.warnings, Contains(HasSubstr("header bounds are wrong")));
}

/// A square of points 1 m apart at a place.
std::vector<CloudPoint> square_at(double x, double y) {
  std::vector<CloudPoint> points;
  for (int i = 0; i < 100; ++i) points.push_back(point_at(x + i % 10, y + i / 10, 5.0));
  return points;
}

ReadOptions in_frame_of_zeros() {
  ReadOptions options;
  options.frame = LocalFrame{};
  return options;
}

TEST_F(ReadCloud, PassesOverFilesFarFromTheLinesWhoseHeaderIsRight) {
  const std::string near = write("near.las", square_at(0.0, 0.0));
  const std::string far = write("far.las", square_at(500.0, 0.0));
  CloudFiles files({near, far}, in_frame_of_zeros());
  EXPECT_THAT(files.unread_paths(), ElementsAre(near, far));
  const Segment2 line{{2.0, 2.0}, {6.0, 6.0}};
  const PointCloud cloud = files.read(PlanMask(std::span(&line, 1), 50.0));
  EXPECT_EQ(cloud.points.size(), 100U);
  EXPECT_EQ(cloud.n_read, 200U);
  EXPECT_EQ(cloud.n_dropped_bounds, 100U);
  EXPECT_THAT(files.unread_paths(), ElementsAre(far));
}

TEST_F(ReadCloud, ReadsAFileWhoseHeaderWronglyPlacesItFarAway) {
  LasBytes las(2, 0);
  for (std::int32_t i = 0; i < 10; ++i) las.add_point({100 * i, 0, 0});  // from (1000, 2000) on
  const std::array<double, 6> bounds{9100.0, 9000.0, 9100.0, 9000.0, 10.0, 0.0};
  for (std::size_t i = 0; i < bounds.size(); ++i) las.set(179 + 8 * i, bounds[i]);
  const std::string path = folder_.write("a.las", las.bytes());
  CloudFiles files({path}, in_frame_of_zeros());
  const Segment2 line{{1000.0, 2000.0}, {1010.0, 2000.0}};
  EXPECT_EQ(files.read(PlanMask(std::span(&line, 1), 5.0)).points.size(), 10U);
}

TEST_F(ReadCloud, GivesNothingWhereMorePointsAreKeptThanFit) {
  CloudFiles files({write("a.las", square_at(0.0, 0.0)), write("b.las", square_at(20.0, 0.0))}, {});
  EXPECT_FALSE(files.read_at_most(std::nullopt, 199));
  const auto cloud = files.read_at_most(std::nullopt, 200);
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->points.size(), 200U);
}

TEST_F(ReadCloud, ThinsToAShareThatFits) {
  constexpr std::size_t kMaxPoints = 3000;
  CloudFiles files({write("a.las", random_points(20000))}, {});
  const std::uint64_t n_all = files.read(std::nullopt).points.size();
  const PointCloud thinned = files.read_thinned(std::nullopt, kMaxPoints);
  EXPECT_LE(thinned.points.size(), kMaxPoints);
  EXPECT_EQ(thinned.points.size() + thinned.n_dropped_share, n_all);
  // a sixteenth of 15 600: 974 expected, and 6 sigma of a binomial share are 182
  EXPECT_NEAR(static_cast<double>(thinned.points.size()), static_cast<double>(n_all) / 16.0, 182.0);
  EXPECT_EQ(files.read(std::nullopt).points.size(), n_all);
}

TEST_F(ReadCloud, TellsTheExtentOfTheKeptPoints) {
  CloudFiles files({write("a.las", square_at(3.0, 4.0), {513000.0, 5403000.0, 200.0})}, {});
  const Eigen::AlignedBox3d box = files.extent_in_world();
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(513003.0, 5403004.0, 205.0), 1e-12));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(513012.0, 5403013.0, 205.0), 1e-12));
}

TEST_F(ReadCloud, RefusesCoordinatesBeyondAnyMap) {
  const std::string path =
      folder_.write("a.las", LasBytes(2, 0).add_point({1, 1, 1}).set(131, 1e9).bytes());
  EXPECT_THAT(io_error_of([&] { read_cloud({path}); }), HasSubstr("a point has x = 1000001000 m"));
}

TEST_F(ReadCloud, SalvagesACutFile) {
  const std::string path =
      folder_.write("a.las", LasBytes(2, 0).add_point({}).set<std::uint32_t>(107, 9).bytes());
  EXPECT_NE(io_error_of([&] { read_cloud({path}); }), "");
  ReadOptions options;
  options.salvage = true;
  const PointCloud cloud = read_cloud({path}, options);
  EXPECT_EQ(cloud.points.size(), 1U);
  EXPECT_THAT(cloud.warnings, Contains(HasSubstr("salvaged 1 of 9 declared records")));
}

TEST_F(ReadCloud, CountsPointsThatAreNotFinite) {
  const std::string path = folder_.write("a.xyz", "1 2 3\nnan 0 0\n0 inf 0\n");
  const PointCloud cloud = read_cloud({path});
  EXPECT_EQ(cloud.points.size(), 1U);
  EXPECT_EQ(cloud.n_dropped_non_finite, 2U);
}

TEST(PlanBounds, HoldAllHeightsBetweenTheirCorners) {
  const Eigen::AlignedBox3d box = plan_bounds(std::array{1.0, 2.0, 3.0, 4.0});
  EXPECT_TRUE(box.contains(Eigen::Vector3d(1.0, 4.0, -1e9)));
  EXPECT_FALSE(box.contains(Eigen::Vector3d(0.9, 3.0, 0.0)));
  EXPECT_FALSE(box.contains(Eigen::Vector3d(2.0, 4.1, 0.0)));
}

TEST(PlanBounds, AreFourNumbersInOrder) {
  EXPECT_NO_THROW((void)plan_bounds(std::array{1.0, 2.0, 1.0, 2.0}));
  EXPECT_THROW((void)plan_bounds(std::array{3.0, 2.0, 1.0, 4.0}), std::invalid_argument);
  EXPECT_THROW((void)plan_bounds(std::array{1.0, 4.0, 3.0, 2.0}), std::invalid_argument);
  EXPECT_THROW((void)plan_bounds(std::array<double, 4>{1.0, 2.0, NAN, 4.0}), std::invalid_argument);
  EXPECT_THROW((void)plan_bounds(std::array{1.0, 2.0, 3.0}), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::io
