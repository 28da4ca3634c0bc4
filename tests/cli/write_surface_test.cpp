// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/read_cloud.h"
#include "tests/cli/cli_fixture.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace ridgeline::cli {
namespace {

using ::testing::HasSubstr;

class WriteSurface : public SmallPair {
 protected:
  [[nodiscard]] ProgramResult reconstruct(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"reconstruct", "pair/patch.yaml", "--out", "lines.geojson"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  [[nodiscard]] io::PointCloud cloud(const std::string& file) const {
    return io::read_cloud({path(file).string()}, {});
  }
};

TEST_F(WriteSurface, GivesTheHeightsThatLaserPointsHave) {
  ASSERT_EQ(reconstruct({"--write-surface", "s.las"}).exit_code, 0);
  const io::PointCloud surface = cloud("s.las");
  const io::PointCloud laser = cloud("pair/lidar.las");
  constexpr double kBeside_m = 0.15;
  constexpr double kMedian_m = 0.15;  // half a pixel of disparity in height
  const Eigen::Vector3d shift = laser.frame.origin_m - surface.frame.origin_m;
  std::vector<double> apart_m;
  for (std::size_t i = 0; i < laser.points.size(); i += 40) {
    const io::CloudPoint& l = laser.points[i];
    for (const io::CloudPoint& s : surface.points) {
      if (std::hypot(l.x + shift.x() - s.x, l.y + shift.y() - s.y) > kBeside_m) continue;
      apart_m.push_back(std::abs(l.z + shift.z() - s.z));
      break;
    }
  }
  ASSERT_GT(apart_m.size(), 100U);
  std::ranges::sort(apart_m);
  EXPECT_LT(apart_m[apart_m.size() / 2], kMedian_m);
}

TEST_F(WriteSurface, NamesAFileOfPoints) {
  EXPECT_REFUSED(reconstruct({"--write-surface", "s.txt"}), HasSubstr("must end in .las"));
}

TEST_F(WriteSurface, DoesNotNeedALineThatTakesIt) {
  EXPECT_EQ(reconstruct({"--preset", "published", "--write-surface", "s.las"}).exit_code, 0);
  EXPECT_GT(cloud("s.las").points.size(), 10000U);
}

TEST_F(WriteSurface, MethodOfPlanesIsRefusedWithoutASurface) {
  std::ofstream(path("c.yaml"))
      << "match: {surface: false, guided: false}\nreconstruct: {surface: false}\n";
  EXPECT_REFUSED(reconstruct({"--method", "planes", "--config", "c.yaml"}),
                 HasSubstr("patch.yaml: --method planes: there is no surface"));
}

}  // namespace
}  // namespace ridgeline::cli
