// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/roof_planes/plane_faces.h"

#include "tests/reconstruct/estimate/beyond/roof_planes/gable_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace ridgeline::reconstruct {
namespace {

constexpr int kCell_px = PlaneFaces::kCell_px;

Surface surface_of(const std::function<double(const Eigen::Vector2d&)>& disparity_at) {
  Surface surface;
  surface.disparity_px = cv::Mat(120, 180, CV_32F);
  for (int row = 0; row < surface.disparity_px.rows; ++row) {
    for (int column = 0; column < surface.disparity_px.cols; ++column) {
      surface.disparity_px.at<float>(row, column) =
          static_cast<float>(disparity_at(Eigen::Vector2d(column, row)));
    }
  }
  return surface;
}

TEST(PlaneFaces, OfAGableAreItsRoofPlanesAndTheGround) {
  constexpr double kOfFloats_px = 1e-4;  // disparities are float
  const test::GableSurface gable(30.0);
  const PlaneFaces found = plane_faces(gable.surface());
  ASSERT_EQ(found.faces.size(), 3U);
  const Rectification& r = gable.rectification();
  for (const Plane3& plane : gable.planes()) {
    // a face that agrees with the plane at three places
    const auto is_plane = [&](const PlaneFace& face) {
      return std::ranges::all_of(std::array{Eigen::Vector2d(180, 200), Eigen::Vector2d(220, 190),
                                            Eigen::Vector2d(200, 230)},
                                 [&](const Eigen::Vector2d& x) {
                                   const Eigen::Vector3d point =
                                       r.point_in_local(x, face.disparity_px(x));
                                   return std::abs(plane.signedDistance(point)) < kOfFloats_px;
                                 });
    };
    EXPECT_EQ(std::ranges::count_if(found.faces, is_plane), 1);
  }
}

TEST(PlaneFaces, AreAsExactFarFromTheFirstPixel) {
  constexpr double kOfFloats_px = 1e-6;  // disparities are float and close to 0 where the face lies
  constexpr int kFar_px = 24000, kSide_px = 48;
  const Eigen::Vector2d middle(kFar_px - 0.5 * kSide_px - 0.5, 0.5 * kSide_px - 0.5);
  const Eigen::Vector2d slope(0.3, -0.2);
  Surface surface;
  surface.disparity_px =
      cv::Mat(kSide_px, kFar_px, CV_32F, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  for (int row = 0; row < kSide_px; ++row) {
    for (int column = kFar_px - kSide_px; column < kFar_px; ++column) {
      surface.disparity_px.at<float>(row, column) =
          static_cast<float>(slope.dot(Eigen::Vector2d(column, row) - middle));
    }
  }
  const PlaneFaces found = plane_faces(surface);
  ASSERT_EQ(found.faces.size(), 1U);
  EXPECT_NEAR(found.faces[0].disparity_px(middle), 0.0, kOfFloats_px);
  EXPECT_LT((found.faces[0].plane.head<2>() - slope).norm(), kOfFloats_px);
  const Eigen::Vector3d x = middle.homogeneous();
  const int n_inner = found.faces[0].n_cells - 4 * (kSide_px / kCell_px - 1);
  constexpr double kSigma_px = 0.05,
                   kTogether = 100.0;  // least sigma that is assumed; pixels that err together
  EXPECT_NEAR(x.dot(found.faces[0].cov * x),
              kTogether * kSigma_px * kSigma_px / (n_inner * kCell_px * kCell_px), 1e-7);
}

TEST(PlaneFaces, HoldTheCellsThatLieOnThem) {
  const double kStep_px = 90.0;
  const PlaneFaces found = plane_faces(
      surface_of([&](const Eigen::Vector2d& x) { return x.x() < kStep_px ? 40.0 : 25.0; }));
  ASSERT_EQ(found.faces.size(), 2U);
  EXPECT_EQ(found.faces[0].n_cells + found.faces[1].n_cells,
            static_cast<int>(found.face_of_cell.total()));
  for (int column = 0; column < found.face_of_cell.cols; ++column) {
    const int face = found.face_of_cell.at<int>(3, column);
    const double expected = PlaneFaces::centre_px(3, column).x() < kStep_px ? 40.0 : 25.0;
    EXPECT_NEAR(found.faces[static_cast<std::size_t>(face)].disparity_px({50.0, 50.0}), expected,
                1e-3);
  }
}

TEST(PlaneFaces, LeaveOutWallsSmallFacesAndWhatIsNotKnown) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(plane_faces(surface_of([](const Eigen::Vector2d& x) {
                return 20.0 + 0.7 * x.x();
              })).faces.empty());
  EXPECT_EQ(plane_faces(surface_of([](const Eigen::Vector2d& x) {
              return 20.0 + 0.5 * x.x();
            })).faces.size(),
            1U);
  const auto known_up_to = [&](int side_px) {
    return plane_faces(surface_of([&](const Eigen::Vector2d& x) {
             return x.x() < side_px && x.y() < side_px ? 30.0 : kNaN;
           }))
        .faces.size();
  };
  EXPECT_EQ(known_up_to(3 * kCell_px), 0U);  // nine cells are too few
  EXPECT_EQ(known_up_to(4 * kCell_px), 1U);
}

TEST(PlaneFaces, AreKnownBetterTheMorePixelsTheyHave) {
  const auto variance_px2 = [](double width_px) {
    const PlaneFaces found = plane_faces(surface_of([&](const Eigen::Vector2d& x) {
      return x.x() < width_px ? 30.0 : std::numeric_limits<double>::quiet_NaN();
    }));
    const Eigen::Vector3d middle(0.5 * (width_px - 1.0), 59.5, 1.0);
    return middle.dot(found.faces.at(0).cov * middle);
  };
  constexpr double kSigma_px = 0.05;  // least sigma of 100 pixels that err together
  // cells on the border do not count
  const auto expected_px2 = [](double width_px) {
    return kSigma_px * kSigma_px * 100.0 / ((width_px - 2 * kCell_px) * (120.0 - 2 * kCell_px));
  };
  EXPECT_NEAR(variance_px2(60.0), expected_px2(60.0), 1e-9);
  EXPECT_NEAR(variance_px2(120.0), expected_px2(120.0), 1e-9);
}

}  // namespace
}  // namespace ridgeline::reconstruct
