// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/straight_pieces.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kPieceRounding = 1e-12;

TEST(PrincipalAxes, OfPointsOnALineAreTheLine) {
  Points points;
  for (int i = 0; i < 20; ++i) points.emplace_back(3.0 + 0.6 * i, 5.0 + 0.8 * i);
  const PrincipalAxes axes = principal_axes(points);
  EXPECT_NEAR((axes.along - Eigen::Vector2d(0.6, 0.8)).norm(), 0.0, kPieceRounding);
  EXPECT_NEAR(axes.lambda_min, 0.0, kPieceRounding);
  EXPECT_NEAR(axes.max_distance, 0.0, 1e-9);
}

TEST(PrincipalAxes, LambdaMinIsTheVarianceAcross) {
  Points points;
  for (int i = 0; i < 1000; ++i) points.emplace_back(i, i % 2 == 0 ? 0.3 : -0.3);
  const PrincipalAxes axes = principal_axes(points);
  EXPECT_NEAR(axes.lambda_min, 0.09, 1e-6);
  EXPECT_NEAR(axes.max_distance, 0.3, 1e-3);
}

TEST(PrincipalAxes, OfOnePointHaveADirection) {
  const Points points{{4.0, 2.0}};
  const PrincipalAxes axes = principal_axes(points);
  EXPECT_EQ(axes.along.norm(), 1.0);
  EXPECT_EQ(axes.lambda_min, 0.0);
}

TEST(StraightPieces, AStraightRunIsOnePiece) {
  Points points;
  for (int i = 0; i < 40; ++i) points.emplace_back(i, 0.3 * std::sin(i));
  const std::vector<Piece> pieces = straight_pieces(points, {});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].first, 0);
  EXPECT_EQ(pieces[0].last, 40);
}

TEST(StraightPieces, ACornerIsCutAtTheCorner) {
  Points points;
  for (int i = 0; i <= 30; ++i) points.emplace_back(i, 0.0);
  for (int i = 1; i <= 20; ++i) points.emplace_back(30.0, i);
  const std::vector<Piece> pieces = straight_pieces(points, {});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].last, 31);
  EXPECT_EQ(pieces[1].first, 30);
}

TEST(StraightPieces, ACircleBecomesPiecesThatKeepTheLimits) {
  Points points;
  for (int i = 0; i < 628; ++i) {
    points.emplace_back(100.0 * std::cos(0.01 * i), 100.0 * std::sin(0.01 * i));
  }
  const ExtractOptions options;
  const std::vector<Piece> pieces = straight_pieces(points, options);
  // an arc of sagitta 1 px at radius 100 px is 28 px long: about 22 of them
  EXPECT_GT(pieces.size(), 12U);
  EXPECT_LT(pieces.size(), 40U);
  for (const Piece& piece : pieces) {
    const PrincipalAxes axes =
        principal_axes(std::span(points).subspan(piece.first, piece.last - piece.first));
    EXPECT_LE(axes.lambda_min, kMaxLambdaMinPx2);
    EXPECT_LE(axes.max_distance, options.max_deviation_px);
  }
}

TEST(StraightPieces, ShortRunsAreLeftOut) {
  Points points;
  for (int i = 0; i < 9; ++i) points.emplace_back(i, 0.0);
  EXPECT_TRUE(straight_pieces(points, {}).empty());
  EXPECT_TRUE(straight_pieces({}, {}).empty());
}

TEST(StraightPieces, AClosedCurveIsCutThoughItsEndsMeet) {
  Points points;
  for (int i = 0; i <= 30; ++i) points.emplace_back(i, 0.0);
  for (int i = 1; i <= 30; ++i) points.emplace_back(30.0, i);
  for (int i = 1; i <= 30; ++i) points.emplace_back(30.0 - i, 30.0);
  for (int i = 1; i <= 30; ++i) points.emplace_back(0.0, 30.0 - i);
  EXPECT_EQ(straight_pieces(points, {}).size(), 4U);
}

}  // namespace
}  // namespace ridgeline::reconstruct
