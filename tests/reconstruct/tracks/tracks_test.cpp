// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/tracks/tracks.h"

#include "tests/reconstruct/support/block_scene.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::BlockScene;

/// Expects that all observations of each track show one line, and that each segment is in one track
/// at most.
void expect_true_tracks(const BlockScene& block, const std::vector<Track>& tracks) {
  std::set<Observation> taken;
  for (const Track& track : tracks) {
    ASSERT_GE(track.observations.size(), 2);
    EXPECT_NE(track.base().view, track.other().view);
    for (const Observation& s : track.observations) {
      EXPECT_EQ(block.line_at(s), block.line_at(track.base()));
      EXPECT_TRUE(taken.insert(s).second) << s.view << " " << s.segment;
    }
  }
}

/// The number of observations in the tracks of each line.
std::vector<std::vector<std::size_t>> sizes_by_line(const BlockScene& block,
                                                    const std::vector<Track>& tracks) {
  std::vector<std::vector<std::size_t>> sizes(block.lines.size());
  for (const Track& track : tracks)
    sizes[static_cast<std::size_t>(block.line_at(track.base()))].push_back(
        track.observations.size());
  return sizes;
}

using Sizes = std::vector<std::size_t>;

TEST(TracksOf, EveryLineIsOneTrackOfAllViews) {
  const BlockScene block = test::block_of_lines();
  const std::vector<Track> tracks = tracks_of(block.scene, {});
  expect_true_tracks(block, tracks);
  for (const Sizes& sizes : sizes_by_line(block, tracks)) EXPECT_EQ(sizes, Sizes{5});
}

TEST(TracksOf, AViewThatHidesALineIsNotInItsTrack) {
  BlockScene block = test::block_of_lines();
  const int line = block.add({{-24.0, 8.0, 5.0}, {-16.0, 8.5, 5.0}}, {3});
  const std::vector<Track> tracks = tracks_of(block.scene, {});
  expect_true_tracks(block, tracks);
  EXPECT_EQ(sizes_by_line(block, tracks)[static_cast<std::size_t>(line)], Sizes{4});
}

TEST(TracksOf, ALineInPiecesIsOneTrackWithAllPieces) {
  BlockScene block;
  const int line = block.add({{-8.0, -6.0, 4.0}, {8.0, 6.0, 5.0}}, {1});
  block.show(1, line, 0.0, 0.25);
  block.show(1, line, 0.35, 0.6);
  block.show(1, line, 0.7, 1.0);
  const std::vector<Track> tracks = tracks_of(block.scene, {});
  expect_true_tracks(block, tracks);
  ASSERT_EQ(tracks.size(), 1);
  EXPECT_EQ(tracks[0].observations.size(), 4 + 3);
}

TEST(TracksOf, PiecesBesideEachOtherAreNotOneTrack) {
  // A double edge: the second one is 1 px beside the first one in one view, where it covers the
  // same part.
  BlockScene block;
  const int line = block.add({{-8.0, -6.0, 4.0}, {8.0, 6.0, 5.0}});
  block.show(1, line, 0.2, 0.8);
  const std::vector<Track> tracks = tracks_of(block.scene, {});
  ASSERT_EQ(tracks.size(), 1);
  EXPECT_EQ(tracks[0].observations.size(), 5);
}

/// Equal lines across a strip, 2 m apart. A height that is wrong by 2 m x 800 / 208 moves the image
/// of each to the next one in both other views.
BlockScene repeated_lines() {
  BlockScene block(test::kStrip);
  for (int i = -6; i <= 6; ++i) block.add({{2.0 * i, -5.0, 7.5}, {2.0 * i, 5.0, 7.5}});
  block.mix();
  return block;
}

constexpr double kInterior_m = 5.0;  // lines with several neighbours on both sides

TEST(TracksOf, RepeatedLinesAreUndecidedByGeometryAlone) {
  const BlockScene block = repeated_lines();
  const auto sizes = sizes_by_line(block, tracks_of(block.scene, {}));
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (std::abs(block.lines[i].start.x()) > kInterior_m) continue;
    EXPECT_TRUE(sizes[i].empty()) << i;
  }
}

TEST(TracksOf, RepeatedLinesAreDecidedByTheirAppearance) {
  const BlockScene block = repeated_lines();
  using Chain = std::array<ViewPair, 2>;
  for (const auto& [first, second] :
       {Chain{{{0, 1}, {0, 2}}}, Chain{{{0, 1}, {1, 2}}}, Chain{{{0, 1}, {2, 1}}}}) {
    const std::vector<MatchedPair> pairs{block.matches(first), block.matches(second)};
    const std::vector<Track> tracks = tracks_of(block.scene, pairs);
    expect_true_tracks(block, tracks);
    for (const Sizes& sizes : sizes_by_line(block, tracks)) EXPECT_EQ(sizes, Sizes{3});
  }
}

/// Lines along a strip, so that no pair of its views tells their heights.
BlockScene aligned_lines() {
  BlockScene block(test::kStrip);
  for (const double y : {-8.0, 0.0, 8.0}) block.add({{-6.0, y, 5.0}, {6.0, y, 5.0}});
  block.mix();
  return block;
}

TEST(TracksOf, AlignedLinesHaveNoTrackByGeometryAlone) {
  EXPECT_TRUE(tracks_of(aligned_lines().scene, {}).empty());
}

TEST(TracksOf, AlignedLinesAreChainedByTheirAppearance) {
  const BlockScene block = aligned_lines();
  using Chain = std::array<ViewPair, 2>;
  for (const auto& [first, second] :
       {Chain{{{0, 1}, {0, 2}}}, Chain{{{0, 1}, {1, 2}}}, Chain{{{0, 1}, {2, 1}}}}) {
    const std::vector<MatchedPair> pairs{block.matches(first), block.matches(second)};
    const std::vector<Track> tracks = tracks_of(block.scene, pairs);
    expect_true_tracks(block, tracks);
    for (const Sizes& sizes : sizes_by_line(block, tracks)) EXPECT_EQ(sizes, Sizes{3});
  }
}

TEST(TracksOf, AMatchByAppearanceWithoutAThirdViewIsATrackOfTwo) {
  BlockScene block;
  block.add({{-8.0, -6.0, 4.0}, {8.0, 6.0, 5.0}}, {2, 3, 4});
  EXPECT_TRUE(tracks_of(block.scene, {}).empty());
  const std::vector<MatchedPair> pairs{block.matches({0, 1})};
  const std::vector<Track> tracks = tracks_of(block.scene, pairs);
  ASSERT_EQ(tracks.size(), 1);
  EXPECT_EQ(tracks[0].observations, (std::vector<Observation>{{0, 0}, {1, 0}}));
}

TEST(TracksOf, BeginsWithTheBaseAndTheSearchViewOfAMatchedPair) {
  const BlockScene block = test::block_of_lines();
  const std::vector<MatchedPair> pairs{{{3, 1}, {}}, {{0, 1}, {}}};
  for (const Track& track : tracks_of(block.scene, pairs)) {
    std::vector<std::size_t> views;
    for (const Observation& s : track.observations) views.push_back(s.view);
    EXPECT_EQ(views, (std::vector<std::size_t>{3, 1, 0, 2, 4}));
  }
}

using TracksById = std::set<std::set<std::pair<std::string, int>>>;

TracksById tracks_by_id(const BlockScene& block) {
  TracksById all;
  for (const Track& track : tracks_of(block.scene, {})) all.insert(block.observations_by_id(track));
  return all;
}

TEST(TracksOf, DoesNotDependOnTheOrderOfTheViews) {
  const BlockScene block = test::block_of_lines();
  const TracksById expected = tracks_by_id(block);
  for (const std::vector<std::size_t>& order :
       {std::vector<std::size_t>{0, 1, 4, 2, 3}, {0, 1, 3, 4, 2}, {4, 3, 2, 1, 0}}) {
    EXPECT_EQ(tracks_by_id(test::with_views(block, order)), expected);
  }
}

TEST(TracksOf, DoesNotDependOnTheNumberOfThreads) {
  const BlockScene block = test::block_of_lines();
  const auto with_threads = [&](std::size_t n) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, n);
    return tracks_of(block.scene, {});
  };
  const std::vector<Track> of_one = with_threads(1);
  const std::vector<Track> of_four = with_threads(4);
  ASSERT_EQ(of_four.size(), of_one.size());
  for (std::size_t i = 0; i < of_one.size(); ++i)
    EXPECT_EQ(of_four[i].observations, of_one[i].observations);
}

TEST(TracksOf, OfLinesInDisorderHasEachSegmentOnce) {
  // Segments at random: what few tracks there are by chance must not share a segment.
  BlockScene block;
  test::Random random(202);
  for (std::size_t v = 0; v < block.scene.views.size(); ++v) {
    for (int i = 0; i < 150; ++i) {
      const Eigen::Vector3d start = random.vector(-15.0, 15.0);
      const Eigen::Vector3d by = random.vector(-6.0, 6.0);
      block.lines.push_back({start, start + Eigen::Vector3d(by.x(), by.y(), 0.1 * by.z())});
      block.show(v, static_cast<int>(block.lines.size()) - 1, 0.0, 1.0);
    }
  }
  std::vector<MatchedPair> pairs{{{0, 1}, {}}, {{0, 2}, {}}, {{1, 3}, {}}};
  for (MatchedPair& pair : pairs) {
    for (int i = 0; i < 60; ++i) pair.matches.push_back({i, (7 * i + 3) % 60});
  }
  TrackOptions eager;
  eager.min_log_odds = -100.0;
  eager.min_margin = 0.0;
  const std::vector<Track> tracks = tracks_of(block.scene, pairs, {}, eager);
  EXPECT_GT(tracks.size(), 20);
  std::set<Observation> taken;
  for (const Track& track : tracks) {
    for (const Observation& s : track.observations) EXPECT_TRUE(taken.insert(s).second);
  }
}

TEST(TracksOf, RejectsOptionsOutOfRange) {
  TrackOptions options;
  options.sigma_edge_px = 0.0;
  EXPECT_THROW(tracks_of(aligned_lines().scene, {}, {}, options), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::reconstruct
