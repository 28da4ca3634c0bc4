// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/cloud_facts.h"

#include "io/cloud/las_writer.h"
#include "io/cloud/occupied_cells.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace ridgeline::io {
namespace {

using testing::ElementsAre;
using testing::Pair;

CloudPoint classified_point(double x, double y, std::uint8_t classification, std::uint8_t flags) {
  return {.x = x,
          .y = y,
          .z = 1.0,
          .intensity = 0,
          .classification = classification,
          .return_number = 1,
          .number_of_returns = 1,
          .flags = flags,
          .source_id = 0};
}

TEST(CloudFacts, CountsAllPoints) {
  const TempFolder folder;
  // Two points in one cell, two in cells of their own.
  const std::vector<CloudPoint> points{
      classified_point(0.2, 0.2, 2, 0), classified_point(0.8, 0.8, 7, 4),
      classified_point(-0.5, 0.5, 2, 0), classified_point(30.5, 0.5, 6, 0)};
  write_las(folder.file("a.las"), points, {.origin_m = {1000, 2000, 0}}, {"EPSG:25832"});
  const CloudFacts facts = cloud_facts(folder.file("a.las"));
  EXPECT_EQ(facts.format, "LAS 1.4, point format 6");
  EXPECT_EQ(facts.n_points, 4U);
  EXPECT_EQ(facts.n_withheld, 1U);
  EXPECT_THAT(facts.n_by_class, ElementsAre(Pair(2, 2U), Pair(6, 1U), Pair(7, 1U)));
  EXPECT_THAT(facts.n_by_return, ElementsAre(Pair(1, 4U)));
  ASSERT_TRUE(facts.density_per_m2.has_value());
  EXPECT_DOUBLE_EQ(*facts.density_per_m2, 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(facts.bounds.min().x(), 999.5);
  EXPECT_DOUBLE_EQ(facts.bounds.max().x(), 1030.5);
  EXPECT_EQ(facts.crs.name, "ETRS89 / UTM zone 32N");
  EXPECT_EQ(facts.scale, Eigen::Vector3d::Constant(0.001));
  EXPECT_EQ(facts.offset, Eigen::Vector3d(1000, 2000, 0));
}

TEST(CloudFacts, DescribesDegreesWithoutADensity) {
  const TempFolder folder;
  const std::vector<CloudPoint> points{classified_point(7, 51, 2, 0)};
  write_las(folder.file("a.las"), points, {}, {"EPSG:4326"});
  const CloudFacts facts = cloud_facts(folder.file("a.las"));
  EXPECT_TRUE(facts.crs.is_geographic);
  EXPECT_FALSE(facts.density_per_m2.has_value());
}

TEST(CloudFacts, DescribesAnEmptyCloud) {
  const TempFolder folder;
  write_las(folder.file("a.las"), {}, {});
  const CloudFacts facts = cloud_facts(folder.file("a.las"));
  EXPECT_EQ(facts.n_points, 0U);
  EXPECT_TRUE(facts.bounds.isEmpty());
  EXPECT_FALSE(facts.density_per_m2.has_value());
}

TEST(OccupiedCells, MergesCellsOfBothSigns) {
  OccupiedCells a;
  OccupiedCells b;
  for (int i = -20; i < 20; ++i) {
    a.add(i + 0.5, -0.5);
    b.add(i + 0.9, i + 0.1);
  }
  EXPECT_EQ(a.count(), 40U);
  a.merge(b);
  EXPECT_EQ(a.count(), 79U);  // the cell (-1, -1) is common
}

TEST(OccupiedCells, LeavesOutDamage) {
  OccupiedCells cells;
  cells.add(1e300, 0.0);
  cells.add(0.0, -1e10);
  EXPECT_EQ(cells.count(), 0U);
}

}  // namespace
}  // namespace ridgeline::io
