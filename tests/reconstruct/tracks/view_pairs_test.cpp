// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/tracks/view_pairs.h"

#include "tests/reconstruct/support/block_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::BlockCamera;
using test::BlockScene;
using ::testing::UnorderedElementsAre;

using PairsById = std::set<std::pair<std::string, std::string>>;

PairsById pairs_by_id(const Scene& scene) {
  PairsById all;
  for (const ViewPair& pair : choose_pairs(scene))
    all.emplace(scene.views[pair.base].id, scene.views[pair.search].id);
  return all;
}

Scene scene_of(const std::vector<BlockCamera>& cameras) { return BlockScene(cameras).scene; }

TEST(CommonPlace, IsTheShareThatBothShowAndTheBaseOverTheHeight) {
  // 160 m aside, 800 m above the middle of the heights
  const Scene scene =
      scene_of({{"a", {0.0, 0.0, 807.5}}, {"b", {160.0, 0.0, 807.5}}, {"far", {9e3, 0.0, 807.5}}});
  const CommonPlace near = common_place(scene, {0, 1});
  constexpr double kTilt = 0.01;  // the cameras are not all at one height
  EXPECT_NEAR(near.base_to_height, 0.2, kTilt);
  EXPECT_GT(near.share, 0.3);
  EXPECT_EQ(common_place(scene, {0, 2}).share, 0.0);
}

TEST(ChoosePairs, OfTwoViewsIsTheOnePairWhateverTheyShow) {
  const Scene scene = scene_of({{"a", {0.0, 0.0, 800.0}}, {"far", {5000.0, 0.0, 800.0}}});
  const std::vector<ViewPair> pairs = choose_pairs(scene);
  ASSERT_EQ(pairs.size(), 1);
  EXPECT_EQ(pairs[0].base, 0);
  EXPECT_EQ(pairs[0].search, 1);
}

TEST(ChoosePairs, BeginsWithTheFirstTwoViewsAndIsATreeOfAll) {
  const Scene scene = BlockScene().scene;
  const std::vector<ViewPair> pairs = choose_pairs(scene);
  ASSERT_EQ(pairs.size(), scene.views.size() - 1);
  EXPECT_EQ(pairs[0].base, 0);
  EXPECT_EQ(pairs[0].search, 1);
  std::set<std::size_t> connected{0};
  for (const ViewPair& pair : pairs) {
    EXPECT_TRUE(connected.contains(pair.base)) << pair.base;
    EXPECT_TRUE(connected.insert(pair.search).second) << pair.search;
  }
  EXPECT_EQ(connected.size(), scene.views.size());
}

TEST(ChoosePairs, TakesTheBaseToHeightRatioNearestToThreeTenths) {
  // From a = (0, 0): b 0.1, c 0.32, d 0.20 of 800 m. d is 0.30 from b on the other side.
  const Scene scene = scene_of({{"a", {0.0, 0.0, 807.5}},
                                {"b", {80.0, 0.0, 807.5}},
                                {"c", {0.0, 256.0, 807.5}},
                                {"d", {-160.0, 0.0, 807.5}}});
  EXPECT_THAT(pairs_by_id(scene),
              UnorderedElementsAre(std::pair("a", "b"), std::pair("a", "c"), std::pair("b", "d")));
}

TEST(ChoosePairs, DoesNotDependOnTheOrderOfTheFurtherViews) {
  const BlockScene block;
  const PairsById expected = pairs_by_id(block.scene);
  std::vector<std::size_t> order{0, 1, 2, 3, 4};
  do {
    EXPECT_EQ(pairs_by_id(test::with_views(block, order).scene), expected);
  } while (std::next_permutation(order.begin() + 2, order.end()));
}

TEST(ChoosePairs, OfEqualRatiosTakesTheSmallestId) {
  // The views are the corners of a square, exactly: the last one is as far from both neighbours.
  const std::vector<BlockCamera> square{{"a", {0.0, 0.0, 800.0}},
                                        {"b", {200.0, 0.0, 800.0}},
                                        {"d", {0.0, 200.0, 800.0}},
                                        {"c", {200.0, 200.0, 800.0}}};
  const BlockScene block(square);
  const PairsById expected = pairs_by_id(block.scene);
  const std::vector<std::size_t> swapped{0, 1, 3, 2};
  EXPECT_EQ(pairs_by_id(test::with_views(block, swapped).scene), expected);
}

TEST(ChoosePairs, LeavesOutAViewThatShowsNothingOfTheOthers) {
  std::vector<BlockCamera> cameras = test::kBlock;
  cameras.insert(cameras.begin() + 2, {"far", {2000.0, 0.0, 800.0}});
  const Scene scene = scene_of(cameras);
  const std::vector<ViewPair> pairs = choose_pairs(scene);
  EXPECT_EQ(pairs.size(), scene.views.size() - 2);
  for (const ViewPair& pair : pairs) {
    EXPECT_NE(pair.base, 2);
    EXPECT_NE(pair.search, 2);
  }
}

TEST(ChoosePairs, NeedsATenthOfBothImages) {
  // A view of a small part of the first one: all of it is shown, but it shows a hundredth.
  Scene zoomed =
      scene_of({{"a", {0.0, 0.0, 807.5}}, {"b", {-100.0, 0.0, 807.5}}, {"c", {50.0, 0.0, 807.5}}});
  EXPECT_EQ(choose_pairs(zoomed).size(), 2);
  zoomed.views[2].image_from_local.topRows<2>() *= 10.0;
  const Eigen::Vector2d middle =
      project(zoomed.views[2].image_from_local, Eigen::Vector3d(50.0, 0.0, 7.5));
  const Eigen::Vector2d by = Eigen::Vector2d::Constant(0.5 * test::kBlockImage_px) - middle;
  zoomed.views[2].image_from_local.topRows<2>() += by * zoomed.views[2].image_from_local.row(2);
  EXPECT_EQ(choose_pairs(zoomed).size(), 1);
}

TEST(ChoosePairs, ConnectsAViewThatShowsLessThanThreeTenthsWithWhatShowsTheMostOfIt) {
  // c is 0.75 of the width away from a and farther from b, whose base-to-height ratio is no better.
  const std::vector<BlockCamera> cameras{
      {"a", {0.0, 0.0, 807.5}}, {"b", {-30.0, 0.0, 807.5}}, {"c", {300.0, 0.0, 807.5}}};
  EXPECT_THAT(pairs_by_id(scene_of(cameras)),
              UnorderedElementsAre(std::pair("a", "b"), std::pair("a", "c")));
  // d shows enough of c: it is connected to c, and not to a with a ratio of 0.3 where little is in
  // common.
  std::vector<BlockCamera> more = cameras;
  more.push_back({"d", {420.0, 0.0, 807.5}});
  EXPECT_THAT(pairs_by_id(scene_of(more)),
              UnorderedElementsAre(std::pair("a", "b"), std::pair("a", "c"), std::pair("c", "d")));
}

TEST(ChoosePairs, TakesCamerasThatLookUp) {
  Scene scene = BlockScene().scene;
  const PairsById expected = pairs_by_id(scene);
  for (View& view : scene.views) view.image_from_local.col(2) *= -1.0;
  scene.height_range_in_local_m = {-scene.height_range_in_local_m[1],
                                   -scene.height_range_in_local_m[0]};
  EXPECT_EQ(pairs_by_id(scene), expected);
}

TEST(ChoosePairs, ThrowsIfTheFirstTwoOfThreeViewsDoNotShowTheSamePlace) {
  const Scene scene = scene_of(
      {{"a", {0.0, 0.0, 800.0}}, {"far", {2000.0, 0.0, 800.0}}, {"c", {200.0, 0.0, 800.0}}});
  EXPECT_THROW(choose_pairs(scene), std::invalid_argument);
  const Scene of_one_place =
      scene_of({{"a", {0.0, 0.0, 800.0}}, {"same", {0.0, 0.0, 800.0}}, {"c", {200.0, 0.0, 800.0}}});
  EXPECT_THROW(choose_pairs(of_one_place), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::reconstruct
