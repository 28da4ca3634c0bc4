// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/render.h"

#include "apps/simulate/mesh_builder.h"
#include "apps/simulate/random.h"
#include "apps/simulate/surface_oracle.h"
#include "tests/support/scene.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <numbers>
#include <vector>

namespace ridgeline::simulate {
namespace {

/// Red radiance, bilinear.
double red(const cv::Mat& image, const Eigen::Vector2d& x_px) {
  const int c = static_cast<int>(std::floor(x_px.x()));
  const int r = static_cast<int>(std::floor(x_px.y()));
  const double s = x_px.x() - c;
  const double t = x_px.y() - r;
  const auto at = [&](int column, int row) -> double {
    return image.at<cv::Vec4f>(row, column)[0];
  };
  return (1 - t) * ((1 - s) * at(c, r) + s * at(c + 1, r)) +
         t * ((1 - s) * at(c, r + 1) + s * at(c + 1, r + 1));
}

RenderOptions flat_colours() {
  RenderOptions options;
  options.texture = 0.0;
  return options;
}

/// A white square of 4 m on level lawn, turned by 20 degrees.
SyntheticScene white_square(std::vector<Eigen::Vector3d>& corners) {
  SyntheticScene scene;
  scene.extent_m = {12.0, 12.0};
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.35).toRotationMatrix();
  for (const Eigen::Vector2d& x : rectangle({-2.0, -2.0}, {2.0, 2.0})) {
    const Eigen::Vector2d at = turn * x + Eigen::Vector2d(6.0, 6.0);
    corners.emplace_back(at.x(), at.y(), 0.01);
  }
  add_polygon(corners, {kNone, kNone, Material::kMarking}, scene.mesh);
  return scene;
}

/// Where the step from `inside` to `outside` lies across an edge, in pixels from it, positive
/// outwards: the integral of a step is its position, whatever the blur.
double edge_offset_px(const cv::Mat& image,
                      const Eigen::Vector2d& on_edge,
                      const Eigen::Vector2d& outwards) {
  constexpr double kReachPx = 5.0;
  constexpr double kStepPx = 0.1;
  const double inside = red(image, on_edge - kReachPx * outwards);
  const double outside = red(image, on_edge + kReachPx * outwards);
  double sum_px = 0.0;
  for (double s = -kReachPx + 0.5 * kStepPx; s < kReachPx; s += kStepPx) {
    sum_px += kStepPx * (red(image, on_edge + s * outwards) - outside) / (inside - outside);
  }
  return sum_px - kReachPx;
}

TEST(Radiance, EdgesAndCornersLieWhereTheCameraProjectsThem) {
  // sampling noise: 25 rays a pixel leave about 0.02 px on 10 px of an edge, and a fifth of it in
  // the mean of all
  constexpr double kTolPx = 0.05;
  constexpr double kTolMeanPx = 0.01;
  std::vector<Eigen::Vector3d> corners;
  const SyntheticScene scene = white_square(corners);
  RenderOptions options = flat_colours();
  options.samples_per_side = 5;
  options.sun_elevation_deg = 90.0;  // so that no shadow lies beside the square
  FlightOptions flight;
  flight.seed = 11;
  const Renderer renderer(scene, options);
  double total_px = 0.0;
  for (const AerialView& view : aerial_views(scene, flight)) {
    const cv::Mat image = renderer.radiance(view);
    for (std::size_t i = 0; i < 4; ++i) {
      const Segment2 side{project(view.image_from_local, corners[i]),
                          project(view.image_from_local, corners[(i + 1) % 4])};
      const Eigen::Vector2d u = (side.end - side.start).normalized();
      const Eigen::Vector2d outwards(-u.y(), u.x());  // counter-clockwise, but y runs down
      // both ends of the side: two sides through a corner fix it
      for (const double end : {0.25, 0.75}) {
        double sum_px = 0.0;
        constexpr int kProfiles = 16;
        for (int k = 0; k < kProfiles; ++k) {
          const double t = end + 0.2 * ((k + 0.5) / kProfiles - 0.5);
          sum_px += edge_offset_px(image, side.start + t * (side.end - side.start), outwards);
        }
        EXPECT_NEAR(sum_px / kProfiles, 0.0, kTolPx) << "side " << i << " at " << end;
        total_px += sum_px / kProfiles / 16.0;  // two views, four sides, two places
      }
    }
  }
  EXPECT_NEAR(total_px, 0.0, kTolMeanPx);
}

TEST(Radiance, ShadowEndsWhereTheSunSaysAndHoldsTheLightOfTheSkyOnly) {
  constexpr double kHeightM = 3.0;
  SyntheticScene scene;
  scene.extent_m = {20.0, 20.0};
  add_prism(rectangle({9.0, 9.0}, {11.0, 11.0}), 0.0, kHeightM, {kNone, kNone, Material::kWall},
            scene.mesh);
  RenderOptions options = flat_colours();
  options.sun_azimuth_deg = 180.0;  // from the south: the shadow falls along +y
  options.sun_elevation_deg = 40.0;
  const double tip_y =
      11.0 + kHeightM / std::tan(options.sun_elevation_deg * std::numbers::pi / 180);
  const Renderer renderer(scene, options);
  const AerialView view = aerial_views(scene, {}).front();
  const cv::Mat image = renderer.radiance(view);
  const auto at = [&](double x, double y) {
    return red(image, project(view.image_from_local, Eigen::Vector3d(x, y, 0.0)));
  };
  const double lit = at(5.0, 15.0);
  const double dark = at(10.0, 12.5);
  // level ground: sun sin(e) (1 + backscatter term) against kSkyShare sin(e) 0.75
  const double along = -view.ray(project(view.image_from_local, Eigen::Vector3d(10, 12.5, 0)))
                            .dot(sun_direction(options));
  const double sun = 1.0 + options.backscatter * (along - 0.7);
  const double sky = kSkyShare * 0.75;
  EXPECT_NEAR(dark / lit, sky / (sun + sky), 2e-3);
  constexpr double kBesideM = 0.2;  // 2.5 px, beyond the blur
  EXPECT_NEAR(at(10.0, tip_y - kBesideM), dark, 0.02 * lit);
  EXPECT_NEAR(at(10.0, tip_y + kBesideM), lit, 0.02 * lit);
  EXPECT_NEAR(at(10.0, tip_y), 0.5 * (lit + dark), 0.15 * lit);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(at(10.0 + side * (1.0 - kBesideM), 12.5), dark, 0.02 * lit);
    EXPECT_NEAR(at(10.0 + side * (1.0 + kBesideM), 12.5), lit, 0.02 * lit);
  }
}

TEST(Radiance, BothViewsSeeOneTexture) {
  const SyntheticScene scene = test::gabled_house(35.0, 20.0);
  RenderOptions options;
  options.backscatter = 0.0;
  options.samples_per_side = 2;
  const std::vector<AerialView> views = aerial_views(scene, {});
  const Renderer renderer(scene, options);
  const std::array<cv::Mat, 2> images{renderer.radiance(views[0]), renderer.radiance(views[1])};
  const SurfaceOracle oracle(scene, views);
  Random random({5});
  std::vector<double> differences;
  std::vector<double> elsewhere;
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Vector2d left_px{random.uniform(4.0, views[0].size_px.x() - 5.0),
                                  random.uniform(4.0, views[0].size_px.y() - 5.0)};
    const auto right_px = oracle.counterpart_of(0, 1, left_px);
    if (!right_px || (right_px->array() < 4.0).any() ||
        (right_px->array() > views[1].size_px.cast<double>().array() - 8.0).any()) {
      continue;
    }
    const double left = red(images[0], left_px);
    differences.push_back(std::abs(red(images[1], *right_px) / left - 1.0));
    elsewhere.push_back(
        std::abs(red(images[1], *right_px + Eigen::Vector2d(3.0, 2.0)) / left - 1.0));
  }
  ASSERT_GT(differences.size(), 1500U);
  const auto median = [](std::vector<double>& values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
  };
  const double agreement = median(differences);
  EXPECT_LT(agreement, 0.02);  // interpolation of the finest texture
  EXPECT_GT(median(elsewhere), 3.0 * agreement);
}

TEST(Radiance, IsTheSameForAnyNumberOfThreads) {
  const SyntheticScene scene = test::gabled_house(35.0);
  RenderOptions options;
  options.samples_per_side = 1;
  const Renderer renderer(scene, options);
  const AerialView view = aerial_views(scene, {}).front();
  const cv::Mat parallel = renderer.radiance(view);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const cv::Mat serial = renderer.radiance(view);
  ASSERT_EQ(parallel.total(), serial.total());
  EXPECT_TRUE(std::equal(serial.datastart, serial.dataend, parallel.datastart));
}

TEST(Renderer, RefusesAnOptionOutsideItsRange) {
  RenderOptions options;
  options.samples_per_side = 0;
  EXPECT_THROW(Renderer(test::flat_house(), options), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::simulate
