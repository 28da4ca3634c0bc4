// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/depth_consensus/surface_depth.h"

#include "reconstruct/geometry/orientation.h"
#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/line_group.h"

#include <gtest/gtest.h>

#include <limits>

namespace ridgeline::reconstruct {
namespace {

using test::segment_of;

constexpr double kSurface_m = 0.1;  // error of the exact surface, by the prior of its slopes
constexpr int kSize_px = 400;

/// A line of 100 px along the epipolar line and what meets it, in images of 400 px around the
/// origin.
test::LineGroup group_of(double z_m, const std::vector<test::NeighbourSpec>& neighbours) {
  test::LineGroup group;
  for (ProjectionMatrix& camera : group.scene.cameras) {
    const Eigen::Vector2d middle = project(camera, Eigen::Vector3d(0.0, 0.0, 0.0));
    camera = window_from_world(camera, middle - Eigen::Vector2d::Constant(0.5 * kSize_px));
  }
  group.truth.push_back(test::make_segment(
      group.scene,
      {.x_left = group.scene.left_centre(), .theta_rad = 0.0, .start_z_m = z_m, .end_z_m = z_m}));
  for (const test::NeighbourSpec& neighbour : neighbours) {
    group.connections.push_back({0, static_cast<int>(group.truth.size())});
    group.truth.push_back(test::make_neighbour(group.scene, group.truth[0], neighbour));
  }
  test::observe(group, {}, nullptr);
  return group;
}

/// Surfaces of these heights on both sides of the first line, NaN for one that is not known.
Surface surface_beside(const test::LineGroup& group, double towards_m, double away_m) {
  Surface surface;
  surface.rectification = *rectification(group.scene.cameras, {kSize_px, kSize_px});
  const Rectification& r = surface.rectification;
  const Segment2 seen = group.scene.images(group.truth[0])[0];
  const Segment2 line{r.rectified(0, seen.start), r.rectified(0, seen.end)};
  surface.disparity_px = cv::Mat(r.size, CV_32F);
  for (int row = 0; row < r.size.height; ++row) {
    for (int column = 0; column < r.size.width; ++column) {
      const Eigen::Vector2d x(column, row);
      const double z_m = normal(line).dot(x - line.start) > 0.0 ? towards_m : away_m;
      surface.disparity_px.at<float>(row, column) =
          static_cast<float>(r.disparity_at_height_px(x, z_m));
    }
  }
  return surface;
}

ReconstructedLine reconstructed(test::LineGroup group,
                                const Surface* surface,
                                const EstimationOptions& options = {}) {
  group.height_range_in_local_m = {-5.0, 15.0};
  return group.reconstruct(options, {}, surface).front();
}

double error_m(const test::LineGroup& group, const ReconstructedLine& line) {
  return std::max(std::abs(segment_of(line).start.z() - group.truth[0].start.z()),
                  std::abs(segment_of(line).end.z() - group.truth[0].end.z()));
}

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

TEST(SurfaceDepth, SwitchedOffSaysNothing) {
  test::LineGroup group = group_of(6.0, {});
  Segment2& right = group.segments[1][0].segment;
  right.end = point_at(right, 1.5);
  const Surface surface = surface_beside(group, 6.0, 0.0);
  EstimationOptions without;
  without.beyond.surface = false;
  EXPECT_STREQ(status_name(reconstructed(group, &surface, without)),
               status_name(reconstructed(group, nullptr, without)));
  EXPECT_STRNE(status_name(reconstructed(group, &surface, without)), "surface");
}

TEST(SurfaceDepth, GivesTheDepthOfAnEaveWhoseCounterpartRunsOn) {
  test::LineGroup group = group_of(6.0, {});
  Segment2& right = group.segments[1][0].segment;
  right.end = point_at(right, 1.5);
  for (const auto& [towards_m, away_m] : {std::pair{6.0, 0.0}, {0.0, 6.0}, {6.0, kNotKnown}}) {
    const Surface surface = surface_beside(group, towards_m, away_m);
    const ReconstructedLine line = reconstructed(group, &surface);
    ASSERT_TRUE(line.segment_in_local) << towards_m << " " << away_m;
    EXPECT_STREQ(status_name(line), "surface");
    EXPECT_LT(error_m(group, line), kSurface_m);
  }
}

TEST(SurfaceDepth, StandsAgainstANetworkWithFewerMeetings) {
  const test::LineGroup group = group_of(6.0, {{0.5, 80}});
  const Surface surface = surface_beside(group, 6.0, 0.0);
  EstimationOptions options;
  options.lines.method = Method::kNetwork;
  const ReconstructedLine line = reconstructed(group, &surface, options);
  ASSERT_TRUE(line.segment_in_local);
  EXPECT_STREQ(status_name(line), "surface");
}

/// Expects that lines that meet keep a line at its height between surfaces of other heights.
void expect_kept_by_meetings(double z_m, double towards_m, double away_m) {
  const test::LineGroup group = group_of(z_m, test::kThreeNeighbours);
  const Surface surface = surface_beside(group, towards_m, away_m);
  const ReconstructedLine line = reconstructed(group, &surface);
  ASSERT_TRUE(line.segment_in_local);
  EXPECT_LT(error_m(group, line), kSurface_m);
}

TEST(SurfaceDepth, ThatIsConfidentNonsenseDoesNotWinOverLinesThatMeet) {
  expect_kept_by_meetings(3.0, 11.0, 10.0);  // as in the deep shadow of a street
}

TEST(SurfaceDepth, DoesNotPullAFenceToTheGround) { expect_kept_by_meetings(1.5, 0.0, 0.0); }

TEST(SurfaceDepth, LikelihoodIsThatOfTheNearerSurface) {
  constexpr double kNonsense = 0.015;
  constexpr double kClose = 0.01;  // the planes beside the line take its slope to be small
  const test::LineGroup group = group_of(6.0, {});
  const Surface surface = surface_beside(group, 6.0, 0.0);
  const std::vector<Track> tracks = tracks_of_pair({0, 1}, group.matches);
  const TrackedSegments tracked{group.scene.cameras, group.segments, tracks, {}};
  const TrackedLines lines = tracked_lines(tracked, extracted(tracked), LineCovariance::kCentroid);
  const SurfaceDepth depth(surface, lines, lines.lines[0]);
  const Segment2 seen = group.scene.images(group.truth[0])[0];
  const auto likelihood_at = [&](double z_m) {
    const auto point = [&](const Eigen::Vector2d& x) {
      return lines.frames.object.conditioned_from_local(group.scene.at_height(x, z_m));
    };
    const DepthLine line{point(seen.start), (point(seen.end) - point(seen.start)).normalized()};
    return std::exp(depth.log_likelihood([&](double) -> const DepthLine& { return line; }));
  };
  EXPECT_NEAR(likelihood_at(6.0), 1.0, kClose);
  EXPECT_NEAR(likelihood_at(0.0), kNonsense, 1e-6);
  EXPECT_NEAR(likelihood_at(9.0), kNonsense, 1e-6);
  // a tenth of a metre is 0.33 px, about the sigma of a line on a surface
  EXPECT_NEAR(likelihood_at(6.1), kNonsense + (1.0 - kNonsense) * std::exp(-0.5), 0.1);
}

TEST(SurfaceDepth, OfNothingChangesNothing) {
  const test::LineGroup group = group_of(3.0, test::kThreeNeighbours);
  const Surface surface = surface_beside(group, kNotKnown, kNotKnown);
  const ReconstructedLine with = reconstructed(group, &surface);
  const ReconstructedLine without = reconstructed(group, nullptr);
  ASSERT_TRUE(with.segment_in_local && without.segment_in_local);
  EXPECT_EQ(segment_of(with).start, segment_of(without).start);
  EXPECT_STREQ(status_name(with), status_name(without));
}

}  // namespace
}  // namespace ridgeline::reconstruct
