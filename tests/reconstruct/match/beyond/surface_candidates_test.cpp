// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/surface_candidates.h"

#include "reconstruct/geometry/orientation.h"
#include "tests/reconstruct/support/stereo_scene.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

constexpr int kCandidateSize_px = 400;
constexpr double kRoof_m = 6.0, kGround_m = 0.0;
constexpr double kUnknownHeight = std::numeric_limits<double>::quiet_NaN();
const double kContradicted = std::log(0.1);
const double kAgreed = std::log(2.0);  // log-odds are at most 2.8
constexpr double kSteep = 0.05;        // tolerance of log-odds, far beyond one sigma

/// A line across the rows of two views, with a surface on either side.
class SurfaceCandidates : public testing::Test {
 protected:
  SurfaceCandidates() {
    test::StereoScene scene(5.0);
    for (ProjectionMatrix& camera : scene.cameras) {
      const Eigen::Vector2d middle = project(camera, Eigen::Vector3d(0.0, 0.0, 0.0));
      camera =
          window_from_world(camera, middle - Eigen::Vector2d::Constant(0.5 * kCandidateSize_px));
    }
    surface.rectification = *rectification(scene.cameras, {kCandidateSize_px, kCandidateSize_px});
    lay({{180.0, 140.0}, {200.0, 240.0}});
  }

  void lay(const Segment2& in_rectified) {
    rectified = in_rectified;
    const Eigen::Matrix3d back = surface.rectification.rectified_from_ideal[0].inverse();
    line = {(back * rectified.start.homogeneous()).hnormalized(),
            (back * rectified.end.homogeneous()).hnormalized()};
  }

  void surfaces_of(double towards_m, double away_m) {
    const Rectification& r = surface.rectification;
    surface.disparity_px = cv::Mat(r.size, CV_32F);
    test::Random random(5);
    for (int row = 0; row < r.size.height; ++row) {
      for (int column = 0; column < r.size.width; ++column) {
        const Eigen::Vector2d x(column, row);
        double z_m = normal(rectified).dot(x - rectified.start) > 0.0 ? towards_m : away_m;
        if (std::isnan(z_m)) z_m = random.uniform(-20.0, 20.0);
        surface.disparity_px.at<float>(row, column) =
            static_cast<float>(r.disparity_at_height_px(x, z_m));
      }
    }
  }

  /// The log-odds of a candidate that gives the line this height over a part of its length.
  [[nodiscard]] double log_odds(double z_m, std::array<double, 2> on_left = {0.0, 1.0}) const {
    Candidate candidate;
    candidate.overlap = {.on_left = on_left, .on_right = on_left, .height_m = {z_m, z_m}};
    Candidates candidates{{candidate}};
    weigh_by_surface(surface, std::span(&line, 1), candidates);
    return candidates[0][0].log_odds;
  }

  Surface surface;
  Segment2 rectified, line;
};

TEST_F(SurfaceCandidates, OnEitherSideAreSpokenFor) {
  surfaces_of(kRoof_m, kGround_m);
  EXPECT_GT(log_odds(kRoof_m), kAgreed);    // an eave
  EXPECT_GT(log_odds(kGround_m), kAgreed);  // the edge of its shadow
}

TEST_F(SurfaceCandidates, OnNeitherSideAreContradicted) {
  surfaces_of(kRoof_m, kGround_m);
  for (const double z_m : {-3.0, 3.0, 9.0}) EXPECT_NEAR(log_odds(z_m), kContradicted, kSteep);
}

TEST_F(SurfaceCandidates, MayLieOnASideThatIsNotTrusted) {
  surfaces_of(kRoof_m, kUnknownHeight);
  EXPECT_EQ(log_odds(kGround_m), 0.0);
  EXPECT_GT(log_odds(kRoof_m), kAgreed);
}

TEST_F(SurfaceCandidates, NearTheRowsAreLessSureOfTheirDisparity) {
  constexpr double kOff_m = 1.0;  // 3 px
  surfaces_of(kRoof_m, kGround_m);
  EXPECT_NEAR(log_odds(kRoof_m + kOff_m), kContradicted, kSteep);
  lay({{140.0, 200.0}, {240.0, 204.0}});
  surfaces_of(kRoof_m, kGround_m);
  EXPECT_GT(log_odds(kRoof_m + kOff_m), kAgreed);
}

TEST_F(SurfaceCandidates, AreComparedAlongTheirOwnPartOfTheLine) {
  surfaces_of(kRoof_m, kGround_m);
  for (int row = 0; row < 190; ++row) {  // the first half is higher
    for (int column = 0; column < surface.disparity_px.cols; ++column) {
      surface.disparity_px.at<float>(row, column) += 8.0F;
    }
  }
  EXPECT_GT(log_odds(kRoof_m, {0.6, 1.0}), kAgreed);
  EXPECT_NEAR(log_odds(kRoof_m, {0.0, 0.4}), kContradicted, kSteep);
}

}  // namespace
}  // namespace ridgeline::reconstruct
