// SPDX-License-Identifier: BSD-3-Clause
// Public files that other programs wrote, good and bad. They are not part of this repository.

#include "io/cloud/cloud_facts.h"
#include "io/cloud/read_cloud.h"
#include "tests/support/paths.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace ridgeline::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

class SharedSamples : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << folder_ << " is absent";
  }

  static std::string path(const std::string& name) { return test::shared_data_dir() + "/" + name; }
  static PointCloud read(const std::string& name) { return read_cloud({path(name)}); }
  static std::string error_of(const std::string& name) {
    return io_error_of([&] { read(name); });
  }

 private:
  std::filesystem::path folder_ = test::shared_data_dir();
};

TEST_F(SharedSamples, IgnTileHasItsPublishedFacts) {
  const CloudFacts facts = cloud_facts(path("ign/test_data_77060_627760_LA93_IGN69.las"));
  EXPECT_EQ(facts.n_points, 59606U);
  EXPECT_THAT(facts.n_by_class, ElementsAre(Pair(1, 3195U), Pair(2, 21975U), Pair(3, 1811U),
                                            Pair(4, 2184U), Pair(5, 12582U), Pair(6, 17859U)));
  EXPECT_EQ(facts.crs.name, "RGF93 v1 / Lambert-93");
  constexpr double kTolerance = 1e-6;  // far below the 0.01 m of the file
  EXPECT_NEAR(facts.bounds.min().z(), 20.39, kTolerance);
  EXPECT_NEAR(facts.bounds.max().z(), 34.94, kTolerance);
  EXPECT_NEAR(facts.bounds.max().y(), 6277600.0, kTolerance);
  EXPECT_NEAR(facts.density_per_m2.value(), 23.8, 0.5);  // nearly all cells are occupied
}

TEST_F(SharedSamples, IgnTileIsReadWithoutAWarning) {
  const PointCloud cloud = read("ign/test_data_77060_627760_LA93_IGN69.las");
  EXPECT_EQ(cloud.points.size(), 59606U);
  EXPECT_EQ(cloud.frame.origin_m, Eigen::Vector3d(770600, 6277600, 0));
  EXPECT_THAT(cloud.warnings, testing::IsEmpty());
}

TEST_F(SharedSamples, GoodFilesHaveTheirPoints) {
  struct Case {
    const char* name;
    std::uint64_t n_points;
  };
  for (const auto& [name, n_points] :
       {Case{"lazperf_point10-1.0.las", 1}, Case{"liblas_1.1_0.las", 1},
        Case{"lazrs_point-time.las", 1065}, Case{"laspy_simple.las", 1065},
        Case{"loadersgl_pdrf4-1.3.las", 1024}, Case{"laspy_1_4_w_evlr.las", 1000},
        Case{"loadersgl_pdrf7-v4-1.4.las", 1024}, Case{"pdal_gps-time-nan.las", 1}}) {
    EXPECT_EQ(read(std::string("las_samples/") + name).n_read, n_points) << name;
  }
  // The coordinates are random bits with a scale of 1. The files are described, though no map has
  // such coordinates.
  for (const char* const name :
       {"loadersgl_pdrf8-1.4.las", "loadersgl_pdrf9-1.4.las", "loadersgl_pdrf10-1.4.las"}) {
    EXPECT_EQ(cloud_facts(path(std::string("las_samples/") + name)).n_points, 1024U);
    EXPECT_THAT(error_of(std::string("las_samples/") + name), HasSubstr("beyond 1"));
  }
}

TEST_F(SharedSamples, CoordinatesAndSystemsAreRight) {
  constexpr double kToleranceM = 1e-9;
  const PointCloud one = read("las_samples/lazperf_point10-1.0.las");
  EXPECT_EQ(Eigen::Vector3d(one.points[0].x, one.points[0].y, one.points[0].z),
            Eigen::Vector3d(1, 2, 3));
  const PointCloud utm = read("las_samples/liblas_1.1_0.las");
  EXPECT_NEAR(utm.points[0].x + utm.frame.origin_m.x(), 470692.44, kToleranceM);
  EXPECT_EQ(describe(utm.crs).name, "NAD83 / UTM zone 15N");
  const PointCloud feet = read("las_samples/laspy_1_4_w_evlr.las");
  EXPECT_NEAR(feet.horizontal_unit_m, 1200.0 / 3937.0, 1e-12);
  EXPECT_THAT(read("las_samples/laspy_simple.las").warnings,
              Contains(HasSubstr("has no reference system")));
}

TEST_F(SharedSamples, BadFilesAreRefusedOrWarnedOf) {
  EXPECT_THAT(error_of("las_samples/pdal_1.2-no-points.las"), HasSubstr("room for 0 records"));
  EXPECT_THAT(error_of("las_samples/pdal_garbage_nVariableLength.las"), HasSubstr("room for 718"));
  ReadOptions options;
  options.salvage = true;
  EXPECT_EQ(read_cloud({path("las_samples/pdal_garbage_nVariableLength.las")}, options).n_read,
            718U);
  const PointCloud cloud = read("las_samples/pdal_bad_vlr_count.las");
  EXPECT_EQ(cloud.points.size(), 10U);
  EXPECT_THAT(cloud.warnings, ElementsAre(HasSubstr("VLR 3 of 3 at byte 429")));
  EXPECT_EQ(describe(cloud.crs).name, "WGS 84 / UTM zone 17N");
}

TEST_F(SharedSamples, TextCloudIsRead) {
  const PointCloud cloud = read("point2roof/roof1/points.xyz");
  EXPECT_EQ(cloud.points.size(), 1024U);
  EXPECT_EQ(cloud.points[0].x, 4.2507829804262025);
}

}  // namespace
}  // namespace ridgeline::io
