// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/edge_tracks.h"

#include "tests/apps/simulate/observed_scene.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace ridgeline::simulate {
namespace {

FlightOptions flight_of(const char* groups) {
  FlightOptions flight;
  flight.groups = parse_view_groups(groups);
  return flight;
}

std::vector<ShownEdge> tracks_of(const test::ObservedScene& o) {
  return edge_tracks(test::measured_edges(o, SurfaceOracle(o.scene, o.views)));
}

/// Largest distance of the ends of two segments, whatever their direction.
double distance_of_ends_px(const Segment2& a, const Segment2& b) {
  const auto between = [&](const Eigen::Vector2d& start, const Eigen::Vector2d& end) {
    return std::max((a.start - start).norm(), (a.end - end).norm());
  };
  return std::min(between(b.start, b.end), between(b.end, b.start));
}

/// Distance of the nearest run in a view from the image of an edge.
double nearest_px(const std::vector<ShownEdge>& tracks,
                  const std::vector<AerialView>& views,
                  std::size_t view,
                  const Segment3& edge) {
  double nearest = std::numeric_limits<double>::infinity();
  const Segment2 image = project(views[view].image_from_local, edge);
  for (const ShownEdge& track : tracks) {
    for (const VisibleRun& s : track.in_view(view)) {
      nearest = std::min(nearest, distance_of_ends_px(s.segment_px, image));
    }
  }
  return nearest;
}

TEST(EdgeTracks, ShowTheEavesOfAFlatRoofWhereTheyAreInAllViews) {
  constexpr double kTolPx = 1.0;  // hidden steps of 0.1 m at the corners
  const test::ObservedScene o =
      test::observed(test::flat_house(20.0), flight_of("strip:3,cross:2,oblique:2"));
  const std::vector<ShownEdge> tracks = tracks_of(o);
  int n_eaves = 0;
  for (const SceneLine& line : o.scene.lines) {
    if (line.kind != LineKind::kEave) continue;
    ++n_eaves;
    for (std::size_t view = 0; view < o.views.size(); ++view) {
      EXPECT_LT(nearest_px(tracks, o.views, view, line.segment), kTolPx) << o.views[view].id;
    }
  }
  EXPECT_EQ(n_eaves, 4);
  for (const ShownEdge& track : tracks) {
    if (track.kind != "eave") continue;
    ASSERT_EQ(track.runs.size(), o.views.size());
    for (const VisibleRun& s : track.runs) EXPECT_NEAR(s.visible_share, 1.0, 0.02);
  }
}

TEST(ShownEdges, LeaveOutTheViewsFromWhichAnEdgeIsHidden) {
  constexpr double kTolPx = 3.0;  // the eaves hide some decimetres near the corners
  constexpr double kElsewherePx = 20.0;
  const SyntheticScene scene = test::flat_house();
  const std::vector<AerialView> views = aerial_views(scene, flight_of("oblique:4"));
  const std::vector<ShownEdge> edges = shown_edges(scene, SurfaceOracle(scene, views));
  const Segment3 south_foot{{14.0, 16.0, 0.0}, {26.0, 16.0, 0.0}};
  for (std::size_t view = 0; view < views.size(); ++view) {
    const double distance_px = nearest_px(edges, views, view, south_foot);
    if (views[view].centre_in_local.y() < 20.0) {
      EXPECT_LT(distance_px, kTolPx) << views[view].id;
    } else {
      EXPECT_GT(distance_px, kElsewherePx) << views[view].id;
    }
  }
}

TEST(EdgeTracks, AreShownByTwoViewsOrMoreInOneDirection) {
  const test::ObservedScene o =
      test::observed(test::gabled_house(35.0, 20.0), flight_of("strip:3,cross:2"));
  const std::vector<ShownEdge> tracks = tracks_of(o);
  ASSERT_GT(tracks.size(), 7U);
  const auto upwards = [](const Segment2& s) { return s.end.y() < s.start.y(); };
  for (const ShownEdge& track : tracks) {
    std::set<std::size_t> views;
    for (const VisibleRun& s : track.runs) {
      views.insert(s.view);
      // views of one strip are not turned to each other
      if (o.views[s.view].id.starts_with("strip") && track.kind == "ridge") {
        EXPECT_EQ(upwards(s.segment_px), upwards(track.runs.front().segment_px));
      }
    }
    EXPECT_GE(views.size(), 2U) << track.kind;
  }
}

TEST(TracksCsv, HasARowForEachRunAndNumbersEdgesFromOne) {
  std::vector<AerialView> views(2);
  views[0].id = "strip1";
  views[1].id = "cross1";
  const Segment2 segment{{1.0, 2.0}, {30.5, 4.25}};
  const std::vector<ShownEdge> tracks{{"eave", 0, {{0, {}, segment, 1.0}, {1, {}, segment, 0.5}}},
                                      {"wall", 2, {}}};
  EXPECT_EQ(tracks_csv(tracks, views),
            "edge,kind,image,x1_px,y1_px,x2_px,y2_px,visible\n"
            "1,eave,strip1,1.000,2.000,30.500,4.250,1.000\n"
            "1,eave,cross1,1.000,2.000,30.500,4.250,0.500\n");
}

TEST(WithoutDuplicates, KeepsWhatAnyViewTellsApart) {
  const Segment2 here{{0.0, 0.0}, {40.0, 0.0}};
  const Segment2 beside{{0.0, 0.5}, {40.0, 0.5}};
  const Segment2 apart{{0.0, 3.0}, {40.0, 3.0}};
  const ShownEdge line{"eave", 0, {{0, {}, here, 1.0}, {1, {}, here, 1.0}, {2, {}, here, 1.0}}};
  const ShownEdge duplicate{"gutter", 2, {{0, {}, beside, 1.0}, {1, {}, beside, 1.0}}};
  const ShownEdge other{
      "wall", 2, {{0, {}, beside, 1.0}, {1, {}, beside, 1.0}, {2, {}, apart, 1.0}}};
  const std::vector<ShownEdge> kept = without_duplicates({duplicate, other, line});
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].kind, "eave");
  EXPECT_EQ(kept[1].kind, "wall");
}

}  // namespace
}  // namespace ridgeline::simulate
