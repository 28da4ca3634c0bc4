// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/choose_views.h"

#include "reconstruct/geometry/orientation.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

using testing::IsEmpty;

constexpr double kHeight_m = 1000.0;

/// A camera that looks straight down from above a place, with columns to the east. The frame shows
/// 400 m x 400 m.
CandidateView view_above(const std::string& id, double x_m, double y_m) {
  const InteriorOrientation interior{{10000.0, 10000.0}, {2000.0, 2000.0}, {}, {}};
  const ExteriorOrientation exterior{{x_m, y_m, kHeight_m}, Eigen::Matrix3d::Identity()};
  return {id, projection_matrix(interior, exterior), {4000, 4000}};
}

/// Places over a square of 80 m around the origin.
std::vector<Eigen::Vector3d> places() {
  std::vector<Eigen::Vector3d> points;
  for (const double x : {-40.0, 0.0, 40.0})
    for (const double y : {-40.0, 0.0, 40.0}) points.emplace_back(x, y, 0.0);
  return points;
}

std::vector<std::string> chosen(const std::vector<CandidateView>& views, std::size_t most) {
  std::vector<std::string> ids;
  for (const std::size_t i : choose_views(views, places(), 40.0, most)) ids.push_back(views[i].id);
  return ids;
}

/// Three strips to the east of three frames each; names tell row and column.
std::vector<CandidateView> block() {
  std::vector<CandidateView> views;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      views.push_back(
          view_above(std::to_string(10 * row + column), 120.0 * (column - 1), 150.0 * (row - 1)));
  }
  return views;
}

TEST(ChooseViews, BaseIsTheOneThatLooksDownMostSteeplyAndThreeTellLinesOfAllDirections) {
  const std::vector<std::string> three = chosen(block(), 3);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_EQ(three[0], "11");
  // the bases are not on one line, along which no line would be told
  const auto place = [](const std::string& id) {
    return Eigen::Vector2d(id.back() - '1', std::stoi(id) / 10 - 1);
  };
  const Eigen::Vector2d a = place(three[1]);
  const Eigen::Vector2d b = place(three[2]);
  EXPECT_NE(a.x() * b.y() - a.y() * b.x(), 0.0) << three[1] << " " << three[2];
}

TEST(ChooseViews, OrderOfTheCandidatesDoesNotMatter) {
  std::vector<CandidateView> views = block();
  const std::vector<std::string> expected = chosen(views, 5);
  EXPECT_EQ(expected.size(), 5U);
  std::ranges::reverse(views);
  EXPECT_EQ(chosen(views, 5), expected);
}

TEST(ChooseViews, ViewsThatDoNotShowThePlaceAreLeftOut) {
  std::vector<CandidateView> views{view_above("a", 0.0, 0.0), view_above("far", 900.0, 0.0),
                                   view_above("b", 150.0, 0.0)};
  EXPECT_THAT(chosen(views, 5), testing::ElementsAre("a", "b"));
  // a frame that looks up sees the place behind its camera
  CandidateView up = view_above("up", 100.0, 0.0);
  up.image_from_local.leftCols<3>() *= Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  up.image_from_local.col(3) =
      -up.image_from_local.leftCols<3>() * Eigen::Vector3d(100.0, 0.0, kHeight_m);
  views.push_back(up);
  EXPECT_THAT(chosen(views, 5), testing::ElementsAre("a", "b"));
  EXPECT_THAT(chosen({view_above("far", 900.0, 0.0)}, 5), IsEmpty());
}

TEST(ChooseViews, ViewInTheSamePlaceIsNoCounterpart) {
  EXPECT_THAT(chosen({view_above("a", 0.0, 0.0), view_above("again", 5.0, 0.0)}, 2),
              testing::ElementsAre("a"));
}

TEST(ChooseViews, CounterpartIsTheOneWithTheBestBaseThatCanBeMatched) {
  std::vector<CandidateView> views{view_above("a", 0.0, 0.0), view_above("near", 50.0, 0.0),
                                   view_above("good", 150.0, 0.0)};
  EXPECT_THAT(chosen(views, 2), testing::ElementsAre("a", "good"));
  // a wide frame shows the place, but a base of 0.8 of the height is too long unless there is no
  // other
  CandidateView wide = view_above("wide", 800.0, 0.0);
  wide.image_from_local.row(0) += 8000.0 * wide.image_from_local.row(2);
  wide.size_px = {16000, 4000};
  ASSERT_GT(seen_share(wide, places()), 0.9);
  views.push_back(wide);
  EXPECT_THAT(chosen(views, 2), testing::ElementsAre("a", "good"));
  EXPECT_THAT(chosen({views[0], wide}, 2), testing::ElementsAre("a", "wide"));
}

TEST(ChooseViews, CounterpartIsNotChosenForTheFewLinesAlongTheBase) {
  // The base of a and long lies along one of the directions in which lines are looked at, that of a
  // and short does not.
  const std::vector<CandidateView> views{view_above("a", 0.0, 0.0), view_above("long", 150.0, 0.0),
                                         view_above("short", 10.0, 70.0)};
  EXPECT_THAT(chosen(views, 2), testing::ElementsAre("a", "long"));
  EXPECT_THAT(chosen(views, 3), testing::ElementsAre("a", "long", "short"));
}

TEST(ChooseViews, ViewsThatTogetherShowThePlaceAreChosenBeforeMoreOfOnePart) {
  // each frame shows one half of 700 m
  std::vector<Eigen::Vector3d> wide;
  for (int i = 0; i <= 14; ++i) wide.emplace_back(50.0 * (i - 7), 0.0, 0.0);
  std::vector<CandidateView> views;
  for (const double y : {0.0, 150.0, 160.0, 170.0})
    views.push_back(view_above("w" + std::to_string(int(y)), -180.0, y));
  for (const double y : {0.0, 150.0})
    views.push_back(view_above("x" + std::to_string(int(y)), 180.0, y));
  const std::vector<std::size_t> four = choose_views(views, wide, 40.0, 4);
  const auto n_east =
      std::ranges::count_if(four, [&](std::size_t i) { return views[i].id[0] == 'x'; });
  EXPECT_EQ(n_east, 2);
}

}  // namespace
}  // namespace ridgeline::reconstruct
