// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_writer.h"

#include "io/cloud/las_header.h"
#include "io/cloud/read_cloud.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace ridgeline::io {
namespace {

CloudPoint sample_point() {
  return {.x = 12.345,
          .y = -67.891,
          .z = 2.5,
          .intensity = 40000,
          .classification = 64,
          .return_number = 2,
          .number_of_returns = 3,
          .flags = 9,
          .source_id = 17};
}

const LocalFrame kFrame{.origin_m = {513000, 5403000, 200}};

TEST(WriteLas, KeepsEveryFieldAndTheCrs) {
  const TempFolder folder;
  const CloudPoint point = sample_point();
  write_las(folder.file("a.las"), {&point, 1}, kFrame, {"EPSG:25832+7837"});
  ReadOptions options;
  options.frame = kFrame;
  const PointCloud cloud = read_cloud({folder.file("a.las")}, options);
  ASSERT_EQ(cloud.points.size(), 1U);
  const CloudPoint& read = cloud.points[0];
  EXPECT_EQ(read.x, point.x);
  EXPECT_EQ(read.y, point.y);
  EXPECT_EQ(read.z, point.z);
  EXPECT_EQ(read.intensity, point.intensity);
  EXPECT_EQ(read.classification, point.classification);
  EXPECT_EQ(read.return_number, point.return_number);
  EXPECT_EQ(read.number_of_returns, point.number_of_returns);
  EXPECT_EQ(read.flags, point.flags);
  EXPECT_EQ(read.source_id, point.source_id);
  EXPECT_TRUE(compare(cloud.crs, {"EPSG:25832+7837"}).compatible);
  EXPECT_THAT(cloud.warnings, testing::IsEmpty());
}

TEST(WriteLas, WritesACorrectHeader) {
  const TempFolder folder;
  const CloudPoint point = sample_point();
  write_las(folder.file("a.las"), {&point, 1}, kFrame, {"EPSG:25832"});
  const LasHeader header = read_las_header(folder.file("a.las"));
  EXPECT_EQ(header.version_minor, 4);
  EXPECT_EQ(header.point_format, 6);
  EXPECT_TRUE(header.crs_is_wkt());
  EXPECT_EQ(header.offset, kFrame.origin_m);
  EXPECT_EQ(header.scale, Eigen::Vector3d::Constant(0.001));
  constexpr double kToleranceM = 1e-8;  // ulps of a northing
  EXPECT_NEAR(header.stated_min.x(), 513012.345, kToleranceM);
  EXPECT_NEAR(header.stated_max.y(), 5402932.109, kToleranceM);
  EXPECT_EQ(header.vlrs.size(), 1U);
  const std::string bytes = folder.read("a.las");
  EXPECT_EQ(bytes[255 + 8], 1);  // points of the second return
  EXPECT_EQ(bytes.size(), header.point_offset + 30U);
}

TEST(WriteLas, GivesTheSameBytesAgainAndNoOtherFile) {
  const TempFolder folder;
  const CloudPoint point = sample_point();
  write_las(folder.file("a.las"), {&point, 1}, kFrame);
  write_las(folder.file("b.las"), {&point, 1}, kFrame);
  EXPECT_EQ(folder.read("a.las"), folder.read("b.las"));
  EXPECT_EQ(folder.num_files(), 2U);
}

TEST(WriteLas, RefusesWhatDoesNotFit) {
  const TempFolder folder;
  const auto write = [&](double x, int return_number, const LasWriteOptions& options) {
    CloudPoint point = sample_point();
    point.x = x;
    point.return_number = static_cast<std::uint8_t>(return_number);
    write_las(folder.file("a.las"), {&point, 1}, kFrame, {}, options);
  };
  EXPECT_THROW(write(3e6, 1, {}), std::invalid_argument);
  EXPECT_THROW(write(std::nan(""), 1, {}), std::invalid_argument);
  EXPECT_THROW(write(0.0, 16, {}), std::invalid_argument);
  EXPECT_THROW(write(0.0, 1, {.scale_m = 0.0}), std::invalid_argument);
  EXPECT_EQ(folder.num_files(), 0U);
  EXPECT_NO_THROW(write(3e6, 15, {.scale_m = 0.01}));
}

}  // namespace
}  // namespace ridgeline::io
