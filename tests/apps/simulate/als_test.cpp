// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/als.h"

#include "apps/simulate/village.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace ridgeline::simulate {
namespace {

constexpr std::uint8_t kGroundClass = 2;
constexpr std::uint8_t kVegetationClass = 5;
constexpr std::uint8_t kBuildingClass = 6;
constexpr std::uint8_t kOutlierClass = 7;

bool equal_bytes(const io::PointCloud& a, const io::PointCloud& b) {
  return a.points.size() == b.points.size() &&
         std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(io::CloudPoint)) ==
             0;
}

double last_returns_per_m2(const io::PointCloud& cloud, const SyntheticScene& scene) {
  const auto count = std::count_if(cloud.points.begin(), cloud.points.end(), [](const auto& p) {
    return p.return_number == p.number_of_returns;
  });
  return static_cast<double>(count) / scene.extent_m.prod();
}

AlsOptions noise_free() {
  AlsOptions options;
  options.range_sigma_m = 0.0;
  options.cross_sigma_m = 0.0;
  options.outlier_share = 0.0;
  return options;
}

TEST(ScanAls, EqualSeedsGiveEqualBytesForAnyNumberOfThreads) {
  const SyntheticScene scene = make_village({});
  AlsOptions options;
  const io::PointCloud two = scan_als(scene, options);
  ASSERT_GT(two.points.size(), 50000U);
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(equal_bytes(scan_als(scene, options), two));
  }
  options.seed = 2;
  EXPECT_FALSE(equal_bytes(scan_als(scene, options), two));
}

TEST(ScanAls, HoldsTheDensity) {
  const SyntheticScene scene = make_village({});
  for (const double density : {2.0, 5.0, 20.0}) {
    AlsOptions options;
    options.density_per_m2 = density;
    EXPECT_NEAR(last_returns_per_m2(scan_als(scene, options), scene), density, 0.1 * density);
  }
}

TEST(ScanAls, HoldsTheDensityWithManyLowStrips) {
  const SyntheticScene scene = make_village({});
  AlsOptions options;
  options.height_above_ground_m = 100.0;
  options.strip_overlap = 0.5;
  options.strip_azimuth_deg = -70.0;
  const io::PointCloud cloud = scan_als(scene, options);
  EXPECT_NEAR(last_returns_per_m2(cloud, scene), 5.0, 0.5);
  const auto last =
      std::max_element(cloud.points.begin(), cloud.points.end(),
                       [](const auto& a, const auto& b) { return a.source_id < b.source_id; });
  EXPECT_GE(last->source_id, 4);
}

TEST(ScanAls, WithoutNoiseEveryReturnLiesOnTheSurface) {
  const SyntheticScene scene = test::gabled_house(40.0, 20.0);
  const test::TopSurface top(scene);
  std::vector<PlanFunction> sides = half_planes(scene.buildings.front().footprint.front());
  const auto fascia = half_planes(scene.buildings.front().roof_footprint.front());
  sides.insert(sides.end(), fascia.begin(), fascia.end());
  const auto on_side = [&](const Eigen::Vector2d& x) {
    return std::any_of(sides.begin(), sides.end(),
                       [&](const PlanFunction& side) { return std::abs(side(x)) < 1e-9; });
  };
  int roof = 0;
  for (const io::CloudPoint& p : scan_als(scene, noise_free()).points) {
    const test::SurfaceSample expected = top.at({p.x, p.y});
    const bool on_top = std::abs(p.z - expected.x.z()) < 1e-9;
    const bool on_wall = p.classification == kBuildingClass && on_side({p.x, p.y});
    const bool below_overhang = p.classification == kGroundClass && std::abs(p.z) < 1e-9;
    EXPECT_TRUE(on_top || on_wall || below_overhang) << p.x << ' ' << p.y << ' ' << p.z;
    if (on_top && expected.plane_id > 0) {
      EXPECT_EQ(p.classification, kBuildingClass);
      ++roof;
    }
  }
  EXPECT_GT(roof, 300);
}

TEST(ScanAls, NoisePerpendicularToAnyPlaneIsTheRangeNoise) {
  constexpr double kSigmaM = 0.034;
  const SyntheticScene scene = test::gabled_house(45.0);
  const test::TopSurface top(scene);
  AlsOptions options;
  options.density_per_m2 = 40.0;
  options.outlier_share = 0.0;
  std::map<int, std::pair<int, double>> squares;  // per plane: n and sum
  for (const io::CloudPoint& p : scan_als(scene, options).points) {
    const test::SurfaceSample expected = top.at({p.x, p.y});
    const Plane3& plane = scene.planes[static_cast<std::size_t>(expected.plane_id)].plane;
    const double residual_m = plane.signedDistance(Eigen::Vector3d(p.x, p.y, p.z));
    if (std::abs(residual_m) > 0.25) continue;  // a wall, or ground below the overhang
    auto& [n, sum] = squares[expected.plane_id];
    ++n;
    sum += residual_m * residual_m;
  }
  ASSERT_EQ(squares.size(), 3U);
  for (const auto& [plane, moments] : squares) {
    ASSERT_GT(moments.first, 1500);
    EXPECT_NEAR(std::sqrt(moments.second / moments.first), kSigmaM, 0.05 * kSigmaM) << plane;
  }
}

TEST(ScanAls, NoGroundBelowARoofFartherThanTheBeamReaches) {
  const SyntheticScene scene = test::gabled_house(30.0);
  AlsOptions options = noise_free();
  options.density_per_m2 = 20.0;
  const ConvexPolygon walls = scene.buildings.front().footprint.front();
  int shadow = 0;
  for (const io::CloudPoint& p : scan_als(scene, options).points) {
    if (p.classification != kGroundClass) continue;
    EXPECT_FALSE(contains(walls, {p.x, p.y}));
    // beside the eave on the side away from the scanner: strip 2 lies at larger y
    if (p.source_id == 2 && std::abs(p.x - 20.0) < 5.0 && p.y < 16.0 && p.y > 15.4) ++shadow;
  }
  EXPECT_EQ(shadow, 0);
}

TEST(ScanAls, TreesGiveSeveralReturnsInOrder) {
  const SyntheticScene scene = make_village({});
  const io::PointCloud cloud = scan_als(scene, AlsOptions{});
  int first_of_many = 0;
  int ground_below_leaves = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const io::CloudPoint& p = cloud.points[i];
    ASSERT_GE(p.return_number, 1);
    ASSERT_LE(p.return_number, p.number_of_returns);
    ASSERT_LE(p.number_of_returns, 5);
    const bool goes_on = p.return_number < p.number_of_returns;
    EXPECT_TRUE(!goes_on || p.classification == kVegetationClass);
    first_of_many += p.return_number == 1 && p.number_of_returns > 1 ? 1 : 0;
    ground_below_leaves += p.return_number > 1 && p.classification == kGroundClass ? 1 : 0;
  }
  EXPECT_GT(first_of_many, 300);
  EXPECT_GT(ground_below_leaves, 100);
}

TEST(ScanAls, OneReturnAtMostWhereSoAsked) {
  AlsOptions options;
  options.max_returns = 1;
  for (const io::CloudPoint& p : scan_als(make_village({}), options).points) {
    ASSERT_EQ(p.number_of_returns, 1);
  }
}

TEST(AlsScanner, AWindowHoldsTheSameReturnsAsTheWholeScan) {
  const SyntheticScene scene = make_village({});
  AlsOptions options;
  options.outlier_share = 0.01;  // they reach farthest from their pulse
  const io::PointCloud whole = scan_als(scene, options);
  const Eigen::AlignedBox2d window_m(Eigen::Vector2d(30.0, 40.0), Eigen::Vector2d(70.0, 55.0));
  io::PointCloud expected;
  for (const io::CloudPoint& p : whole.points) {
    if (window_m.contains(Eigen::Vector2d(p.x, p.y))) expected.points.push_back(p);
  }
  ASSERT_GT(expected.points.size(), 2000U);
  const AlsScanner scanner(scene, options);
  EXPECT_TRUE(equal_bytes(scanner.scan(window_m), expected));
  EXPECT_TRUE(scanner.scan({}).points.empty());
}

TEST(ScanAls, OutliersAndWithheldReturnsHaveTheirShares) {
  AlsOptions options;
  options.outlier_share = 0.05;
  options.withheld_share = 0.1;
  const io::PointCloud cloud = scan_als(test::flat_house(), options);
  const auto n = static_cast<double>(cloud.points.size());
  const auto outliers = std::count_if(cloud.points.begin(), cloud.points.end(), [](const auto& p) {
    return p.classification == kOutlierClass;
  });
  const auto withheld = std::count_if(cloud.points.begin(), cloud.points.end(),
                                      [](const auto& p) { return (p.flags & 4U) != 0; });
  EXPECT_NEAR(static_cast<double>(outliers) / n, 0.05, 0.01);  // 4 standard deviations
  EXPECT_NEAR(static_cast<double>(withheld) / n, 0.1, 0.014);
}

TEST(ScanAls, StripOffsetsShiftEachStripAsAWhole) {
  const SyntheticScene scene = test::flat_house();
  AlsOptions options = noise_free();
  options.strip_offset_sigma_m = 0.2;
  std::map<int, std::vector<double>> ground;
  for (const io::CloudPoint& p : scan_als(scene, options).points) {
    if (p.classification == kGroundClass) ground[p.source_id].push_back(p.z);
  }
  ASSERT_EQ(ground.size(), 2U);
  for (const auto& [strip, heights] : ground) {
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    EXPECT_LT(*high - *low, 1e-9);
  }
  EXPECT_GT(std::abs(ground[1].front() - ground[2].front()), 0.01);
}

TEST(ScanAls, KeepsFrameAndCrsOfTheScene) {
  const SyntheticScene scene = make_village({});
  const io::PointCloud cloud = scan_als(scene, {});
  EXPECT_EQ(cloud.frame.origin_m, scene.frame.origin_m);
  EXPECT_EQ(cloud.crs.definition, scene.crs.definition);
  EXPECT_EQ(cloud.n_read, cloud.points.size());
}

TEST(ScanAls, RejectsOptionsOutsideTheirRange) {
  const SyntheticScene scene = test::flat_house();
  const auto rejects = [&](auto change) {
    AlsOptions options;
    change(options);
    EXPECT_THROW(scan_als(scene, options), std::invalid_argument);
  };
  rejects([](AlsOptions& o) { o.density_per_m2 = 0.0; });
  rejects([](AlsOptions& o) { o.height_above_ground_m = 50.0; });
  rejects([](AlsOptions& o) { o.half_scan_angle_deg = 60.0; });
  rejects([](AlsOptions& o) { o.strip_overlap = 1.0; });
  rejects([](AlsOptions& o) { o.range_sigma_m = -0.1; });
  rejects([](AlsOptions& o) { o.cross_sigma_m = std::nan(""); });
  rejects([](AlsOptions& o) { o.footprint_m = -0.1; });
  rejects([](AlsOptions& o) { o.max_returns = 0; });
  rejects([](AlsOptions& o) { o.outlier_share = 1.5; });
  rejects([](AlsOptions& o) { o.withheld_share = -1.0; });
}

}  // namespace
}  // namespace ridgeline::simulate
