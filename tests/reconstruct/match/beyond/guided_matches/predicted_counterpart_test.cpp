// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/guided_matches/predicted_counterpart.h"

#include "tests/reconstruct/support/painted_roofs.h"

#include <gtest/gtest.h>

#include <limits>

namespace ridgeline::reconstruct {
namespace {

const Eigen::AlignedBox2d kPredictedHouse(Eigen::Vector2d(-6.0, -5.0), Eigen::Vector2d(6.0, 5.0));
constexpr double kPredictedHeight_m = 6.0;
/// An edge of the roof across the base, and one along it.
const Segment3 kAcross{{-6.0, -4.0, kPredictedHeight_m}, {-6.0, 4.0, kPredictedHeight_m}};
const Segment3 kAlong{{-5.0, 5.0, kPredictedHeight_m}, {5.0, 5.0, kPredictedHeight_m}};

/// A flat roof over the ground, and its exact surface.
struct FlatRoof {
  FlatRoof() {
    const Rectification r = *rectification(pair.cameras(), pair.views[0].image.size());
    surface = {r, cv::Mat(r.size, CV_32F)};
    const Eigen::Matrix3d back = r.rectified_from_ideal[0].inverse();
    for (int row = 0; row < r.size.height; ++row) {
      for (int column = 0; column < r.size.width; ++column) {
        const Eigen::Vector3d x = back * Eigen::Vector3d(column, row, 1.0);
        surface.disparity_px.at<float>(row, column) = static_cast<float>(
            r.disparity_px(roofs.seen(pair.views[0].image_from_local, x.hnormalized())));
      }
    }
  }

  test::PaintedRoofs roofs{.faces = {{.plan = kPredictedHouse, .height_m = kPredictedHeight_m}}};
  test::OwnedPair pair = roofs.pair();
  Surface surface;
};

class PredictedCounterpartTest : public testing::Test {
 protected:
  [[nodiscard]] Segment2 seen(const Segment3& line, std::size_t view) const {
    const ProjectionMatrix& camera = pair.views[view].image_from_local;
    return {project(camera, line.start), project(camera, line.end)};
  }

  /// Made once, since it takes most of the time.
  static const FlatRoof& roof() {
    static const FlatRoof roof;
    return roof;
  }
  const test::OwnedPair& pair = roof().pair;
  const Surface& surface = roof().surface;
};

TEST_F(PredictedCounterpartTest, IsWhereTheOtherViewShowsTheNearerSurface) {
  constexpr double kLeft_px = 0.1;   // pixels beside the edge show some of the ground
  constexpr double kRight_px = 0.6;  // the surface of the right view lies on whole pixels
  for (const std::size_t from : {0U, 1U}) {
    const auto counterpart = PredictedCounterpart(surface, from).of(seen(kAcross, from));
    ASSERT_TRUE(counterpart) << from;
    const Segment2 truth = seen(kAcross, 1 - from);
    const double most_px = from == 0 ? kLeft_px : kRight_px;
    EXPECT_LT((counterpart->start - truth.start).norm(), most_px) << from;
    EXPECT_LT((counterpart->end - truth.end).norm(), most_px) << from;
  }
}

TEST_F(PredictedCounterpartTest, IsNoneAlongTheBase) {
  EXPECT_FALSE(PredictedCounterpart(surface, 0).of(seen(kAlong, 0)));
}

TEST_F(PredictedCounterpartTest, IsNoneWhereNothingIsKnown) {
  Surface unknown = surface;
  unknown.disparity_px = cv::Mat(surface.disparity_px.size(), CV_32F,
                                 cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_FALSE(PredictedCounterpart(unknown, 0).of(seen(kAcross, 0)));
  EXPECT_FALSE(PredictedCounterpart(unknown, 1).of(seen(kAcross, 1)));
}

}  // namespace
}  // namespace ridgeline::reconstruct
