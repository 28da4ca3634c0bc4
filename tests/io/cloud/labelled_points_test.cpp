// SPDX-License-Identifier: BSD-3-Clause
// Points of planes as PCL and our own reader see them.
#include "io/cloud/labelled_points.h"

#include "io/cloud/read_cloud.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <cstring>

namespace ridgeline::io {
namespace {

using testing::HasSubstr;

constexpr double kFloat_m = 1e-5;  // rounding of PCL's coordinates at 100 m
constexpr double kMillimetre_m = 0.5001e-3;

LabelledPoints some_points() {
  LabelledPoints points{.frame = {{513000.0, 5403000.0, 300.0}},
                        .crs = {"EPSG:25832"},
                        .x_in_local = {{1.25, 2.5, 10.125}, {99.5, -3.75, 11.0}},
                        .labels = {{{0xb9, 0xb1, 0xa7}, 1, -0.02F}, {{1, 2, 3}, 70000, 0.05F}}};
  return points;
}

TEST(LabelledPoints, ArePcdThatPclReads) {
  const TempFolder folder;
  write_labelled_points(folder.file("a.pcd"), some_points());
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  ASSERT_EQ(pcl::io::loadPCDFile(folder.file("a.pcd"), cloud), 0);
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_NEAR(cloud[1].x, 99.5, kFloat_m);
  EXPECT_NEAR(cloud[1].z, 11.0, kFloat_m);
  EXPECT_EQ(cloud[0].r, 0xb9);
  EXPECT_EQ(cloud[0].b, 0xa7);
  EXPECT_THAT(folder.read("a.pcd"), HasSubstr("# origin 513000 5403000 300 m, to be added"));
}

TEST(LabelledPoints, ArePlyThatPclReads) {
  const TempFolder folder;
  write_labelled_points(folder.file("a.ply"), some_points());
  pcl::PCLPointCloud2 cloud;
  ASSERT_EQ(pcl::io::loadPLYFile(folder.file("a.ply"), cloud), 0);
  ASSERT_EQ(cloud.width * cloud.height, 2U);
  std::vector<std::string> names;
  for (const auto& field : cloud.fields) names.push_back(field.name);
  EXPECT_THAT(names, testing::IsSupersetOf({"x", "y", "z", "rgb", "plane_id", "distance_m"}));
  EXPECT_THAT(folder.read("a.ply"), HasSubstr("comment crs EPSG:25832\n"));
}

class LabelledPointsReadBack : public testing::TestWithParam<const char*> {};

TEST_P(LabelledPointsReadBack, KeepTheirPlacesAtMapCoordinates) {
  const TempFolder folder;
  const LabelledPoints points = some_points();
  write_labelled_points(folder.file(GetParam()), points);
  const PointCloud cloud = read_cloud({folder.file(GetParam())}, {});
  ASSERT_EQ(cloud.points.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const CloudPoint& p = cloud.points[i];
    const Eigen::Vector3d x = cloud.frame.world_from_local({p.x, p.y, p.z});
    EXPECT_LT((x - points.frame.world_from_local(points.x_in_local[i])).norm(), kMillimetre_m);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, LabelledPointsReadBack, testing::Values("a.las", "a.ply"));

TEST(LabelledPoints, AreLasWithColoursAndExtraBytes) {
  const TempFolder folder;
  write_labelled_points(folder.file("a.las"), some_points());
  const std::string bytes = folder.read("a.las");
  EXPECT_EQ(bytes[104], 7);
  EXPECT_THAT(bytes, HasSubstr("plane_id"));
  constexpr std::size_t kLength = 44;
  const std::string second = bytes.substr(bytes.size() - kLength);
  std::uint16_t red = 0;
  std::uint32_t plane_id = 0;
  float distance_m = 0.0F;
  std::memcpy(&red, second.data() + 30, sizeof red);
  std::memcpy(&plane_id, second.data() + 36, sizeof plane_id);
  std::memcpy(&distance_m, second.data() + 40, sizeof distance_m);
  EXPECT_EQ(red, 1 << 8);
  EXPECT_EQ(plane_id, 70000U);
  EXPECT_EQ(distance_m, 0.05F);
}

TEST(LabelledPoints, AreInTheUnitsOfTheirSystem) {
  const TempFolder folder;
  LabelledPoints points = some_points();
  points.crs = {"EPSG:2225"};  // US survey feet
  points.unit_m = Eigen::Vector3d::Constant(1200.0 / 3937.0);
  write_labelled_points(folder.file("a.las"), points);
  const PointCloud cloud = read_cloud({folder.file("a.las")}, {});
  const CloudPoint& p = cloud.points[0];
  const Eigen::Vector3d x = cloud.frame.world_from_local({p.x, p.y, p.z});
  EXPECT_LT((x - points.frame.world_from_local(points.x_in_local[0])).norm(), kMillimetre_m);
}

TEST(LabelledPoints, OtherEndingsAreRefused) {
  EXPECT_THROW(require_point_format("a.laz"), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::io
