// SPDX-License-Identifier: BSD-3-Clause
// The PCD and PLY readers against PCL's writers, in every encoding that PCL writes.

#include "io/cloud/read_cloud.h"
#include "tests/support/random.h"
#include "tests/support/temp_folder.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <functional>
#include <string>

namespace ridgeline::io {
namespace {

using PclCloud = pcl::PointCloud<pcl::PointXYZL>;

PclCloud random_cloud(std::uint32_t n_points) {
  test::Random random(5);
  PclCloud cloud;
  for (std::uint32_t i = 0; i < n_points; ++i) {
    pcl::PointXYZL point;
    point.x = static_cast<float>(random.uniform(-100.0, 100.0));
    point.y = static_cast<float>(random.uniform(-100.0, 100.0));
    point.z = static_cast<float>(random.uniform(0.0, 20.0));
    point.label = i % 7;
    cloud.push_back(point);
  }
  return cloud;
}

struct Case {
  const char* name;
  std::function<int(const std::string&, const PclCloud&)> write;
  double tolerance_m;
};

class PclAgreement : public testing::TestWithParam<Case> {};

TEST_P(PclAgreement, PointsAndLabelsAreEqual) {
  const TempFolder folder;
  const PclCloud written = random_cloud(20000);
  const std::string path = folder.file(GetParam().name);
  ASSERT_EQ(GetParam().write(path, written), 0);
  ReadOptions options;
  options.frame = LocalFrame{};
  const PointCloud read = read_cloud({path}, options);
  ASSERT_EQ(read.points.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i) {
    const CloudPoint& point = read.points[i];
    ASSERT_NEAR(point.x, double{written[i].x}, GetParam().tolerance_m) << i;
    ASSERT_NEAR(point.y, double{written[i].y}, GetParam().tolerance_m) << i;
    ASSERT_NEAR(point.z, double{written[i].z}, GetParam().tolerance_m) << i;
    ASSERT_EQ(point.classification, written[i].label) << i;
  }
}

// PCL prints 8 significant digits: half a unit of the last one below 100 m.
constexpr double kTextToleranceM = 1e-5;

INSTANTIATE_TEST_SUITE_P(Encodings,
                         PclAgreement,
                         testing::Values(Case{"ascii.pcd",
                                              [](const std::string& path, const PclCloud& cloud) {
                                                return pcl::io::savePCDFileASCII(path, cloud);
                                              },
                                              kTextToleranceM},
                                         Case{"binary.pcd",
                                              [](const std::string& path, const PclCloud& cloud) {
                                                return pcl::io::savePCDFileBinary(path, cloud);
                                              },
                                              0.0},
                                         Case{"compressed.pcd",
                                              [](const std::string& path, const PclCloud& cloud) {
                                                return pcl::io::savePCDFileBinaryCompressed(path,
                                                                                            cloud);
                                              },
                                              0.0},
                                         Case{"ascii.ply",
                                              [](const std::string& path, const PclCloud& cloud) {
                                                return pcl::io::savePLYFileASCII(path, cloud);
                                              },
                                              kTextToleranceM},
                                         Case{"binary.ply",
                                              [](const std::string& path, const PclCloud& cloud) {
                                                return pcl::io::savePLYFileBinary(path, cloud);
                                              },
                                              0.0}),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           name[name.find('.')] = '_';
                           return name;
                         });

}  // namespace
}  // namespace ridgeline::io
