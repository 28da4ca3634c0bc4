// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/matching/track_scoring.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

using testing::ElementsAre;

constexpr MatchVerdict kRight = MatchVerdict::kCorrect;
constexpr MatchVerdict kWrong = MatchVerdict::kFalse;
constexpr MatchVerdict kOpen = MatchVerdict::kUnjudged;

/// A horizontal segment from x = 0 to 100 at y.
Segment2 at_y(double y) { return {{0.0, y}, {100.0, y}}; }

/// Three views with horizontal segments at y = 0, 50 and 200. Edge 0 lies at y = 0 in all of them,
/// edge 1, aligned, at y = 50 in the first two. Nothing true lies at 200.
struct TrackScene {
  std::vector<std::vector<Segment2>> segments{3, {at_y(0.5), at_y(50.0), at_y(200.0)}};
  std::vector<TrueEdge> edges{{{{{0, -1}, at_y(0)}, {{1, -1}, at_y(0)}, {{2, -1}, at_y(0)}}, false},
                              {{{{0, -1}, at_y(50)}, {{1, -1}, at_y(50)}}, true}};
};

const TrackCounts& cell(const TracksScore& score,
                        const std::string& line_class,
                        std::optional<std::size_t> group = std::nullopt) {
  for (const TrackCell& c : score.cells) {
    if (c.line_class == line_class && c.group == group) return c.counts;
  }
  throw std::logic_error("no cell " + line_class);
}

TEST(ScoreTracks, CountsEdgesTheirImagesAndObservations) {
  const TrackScene s;
  const std::vector<Track> tracks{{{{0, 0}, {1, 0}, {2, 1}}},   // edge 0, in view 2 something wrong
                                  {{{0, 1}, {1, 1}}},           // edge 1
                                  {{{0, 2}, {1, 2}, {2, 2}}}};  // texture
  const TracksScore score = score_tracks(s.segments, tracks, s.edges);
  EXPECT_THAT(score.verdicts,
              ElementsAre(ElementsAre(kRight, kRight, kWrong), ElementsAre(kRight, kRight),
                          ElementsAre(kOpen, kOpen, kOpen)));
  EXPECT_EQ(score.n_unjudged, 3U);
  const TrackCounts& total = cell(score, "total");
  EXPECT_EQ(total.n_edges, 2U);
  EXPECT_EQ(total.n_edges_found, 2U);
  EXPECT_EQ(total.n_shown, 5U);
  EXPECT_EQ(total.n_shown_found, 4U);
  EXPECT_EQ(total.n_right, 4U);
  EXPECT_EQ(total.n_wrong, 1U);
  EXPECT_DOUBLE_EQ(*total.observation_recall(), 0.8);
  EXPECT_DOUBLE_EQ(*total.observation_precision(), 0.8);
  EXPECT_EQ(cell(score, "aligned").n_right, 2U);
  EXPECT_EQ(cell(score, "not_aligned", image_group(3)).n_wrong, 1U);
  EXPECT_EQ(cell(score, "total", image_group(2)).n_edges, 1U);
  EXPECT_FALSE(cell(score, "total", image_group(4)).edge_recall());
}

TEST(ScoreTracks, FindNoEdgeThatOneImageAloneShowsRight) {
  const TrackScene s;
  const TracksScore score = score_tracks(s.segments, {{{{{0, 0}, {1, 1}}}}}, s.edges);
  EXPECT_EQ(cell(score, "total").n_edges_found, 0U);
  EXPECT_EQ(cell(score, "total").n_right, 1U);
  EXPECT_EQ(cell(score, "total").n_wrong, 1U);
}

TEST(ScoreTracks, LeavesOpenWhatTheReferenceCannotTell) {
  TrackScene s;
  // Edge 1 has no run in view 2; in view 0 a segment continues edge 0.
  s.segments[0].push_back({{110.0, 0.0}, {180.0, 0.0}});
  const std::vector<Track> tracks{{{{0, 1}, {1, 1}, {2, 2}}}, {{{1, 0}, {0, 3}, {2, 0}}}};
  EXPECT_THAT(score_tracks(s.segments, tracks, s.edges).verdicts,
              ElementsAre(ElementsAre(kRight, kRight, kOpen), ElementsAre(kRight, kOpen, kRight)));
}

TEST(ScoreTracks, RefusesWhatDoesNotExist) {
  const TrackScene s;
  EXPECT_THROW(score_tracks(s.segments, {{{{{3, 0}}}}}, s.edges), std::invalid_argument);
  EXPECT_THROW(score_tracks(s.segments, {{{{{0, 3}}}}}, s.edges), std::invalid_argument);
  EXPECT_THROW(score_tracks(s.segments, {}, std::vector<TrueEdge>{{{{{0, -1}, at_y(0)}}, false}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
