// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/tracked_lines.h"

#include "tests/reconstruct/support/block_scene.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

constexpr double kTrackedTol = 1e-9;  // conditioned, of 1; F and its cameras are in double

/// Two lines that all five views show, the second one broken in view 1.
struct TwoTrackedLines {
  test::BlockScene block;
  std::vector<ProjectionMatrix> cameras;
  std::vector<std::vector<UncertainSegment2>> segments;
  std::vector<Track> tracks{{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}},
                            {{{3, 1}, {1, 1}, {1, 2}, {0, 1}}}};

  TwoTrackedLines() {
    block.add({{-8.0, -6.0, 4.0}, {8.0, 6.0, 5.0}});
    const int broken = block.add({{-8.0, 6.0, 2.0}, {8.0, -6.0, 3.0}}, {1});
    block.show(1, broken, 0.0, 0.4);
    block.show(1, broken, 0.6, 1.0);
    cameras = block.cameras();
    for (const View& view : block.scene.views)
      segments.push_back(transformed(view.segments, &EdgeSegment::line));
  }
  [[nodiscard]] TrackedSegments tracked() const { return {cameras, segments, tracks, {}}; }
  [[nodiscard]] TrackedLines lines() const {
    return tracked_lines(tracked(), extracted(tracked()), LineCovariance::kCentroid);
  }
};

TEST(TrackedLines, AreInTheOrderOfTheirObservations) {
  const TwoTrackedLines two;
  const std::vector<TrackSegments> seen = extracted(two.tracked());
  const TrackedLines lines = two.lines();
  ASSERT_EQ(lines.lines.size(), two.tracks.size());
  for (std::size_t i = 0; i < two.tracks.size(); ++i) {
    ASSERT_EQ(lines.lines[i].observations.size(), two.tracks[i].observations.size());
    for (std::size_t s = 0; s < two.tracks[i].observations.size(); ++s) {
      const Observation& observation = two.tracks[i].observations[s];
      const auto number = static_cast<std::size_t>(observation.segment);
      const Segment2& expected = two.segments[observation.view][number].segment;
      EXPECT_EQ(seen[i][s].segment.start, expected.start);
      EXPECT_EQ(lines.lines[i].observations[s].view, observation.view);
      const ImageConditioning& image = lines.frames.views[observation.view].image;
      EXPECT_LT(
          (lines.lines[i].observations[s].segment.end - image.conditioned_from_image(expected.end))
              .norm(),
          kTrackedTol);
    }
  }
}

TEST(TrackedLines, OfABaseInTwoTracksEachHasThePartOfItsPartner) {
  TwoTrackedLines two;
  two.tracks = {{{{3, 1}, {1, 1}}}, {{{3, 1}, {1, 2}}}};
  const TrackedLines lines = two.lines();
  const Segment2 whole = two.segments[3][1].segment;
  const ImageConditioning& image = lines.frames.views[3].image;
  const auto parameter = [&](const Eigen::Vector2d& x) {
    return parameter_along(whole, image.image_from_conditioned(x));
  };
  constexpr double kShare = 1e-3;  // the scale along a line changes with its height
  EXPECT_NEAR(parameter(lines.lines[0].base().segment.start), 0.0, kShare);
  EXPECT_NEAR(parameter(lines.lines[0].base().segment.end), 0.4, kShare);
  EXPECT_NEAR(parameter(lines.lines[1].base().segment.start), 0.6, kShare);
  EXPECT_NEAR(parameter(lines.lines[1].base().segment.end), 1.0, kShare);
}

TEST(SeenTogether, HasEachViewOfBothOnceInTheOrderOfTheFirst) {
  const TrackedLines lines = TwoTrackedLines().lines();
  std::vector<std::size_t> of_first;
  for (const SeenTogether& view : seen_together(lines.lines[0], lines.lines[1]))
    of_first.push_back(view.line.view);
  EXPECT_EQ(of_first, (std::vector<std::size_t>{0, 1, 3}));
  std::vector<std::size_t> of_second;
  for (const SeenTogether& view : seen_together(lines.lines[1], lines.lines[0])) {
    EXPECT_EQ(view.line.view, view.other.view);
    of_second.push_back(view.line.view);
  }
  EXPECT_EQ(of_second, (std::vector<std::size_t>{3, 1, 0}));
}

TEST(Registered, MovesEachObservationByItsOwnRegistration) {
  TwoTrackedLines two;
  const std::vector<Registrations> registrations{{{}, {}, {2.0, 3.0}, {}, {}}, Registrations(4)};
  TrackedSegments tracked = two.tracked();
  tracked.registrations = registrations;
  const std::vector<TrackSegments> plain = extracted(tracked);
  const std::vector<TrackSegments> moved = registered(tracked);
  for (std::size_t s = 0; s < plain[0].size(); ++s) {
    const double by_px = s == 2 ? 2.0 : 0.0;
    const double scale = s == 2 ? 3.0 : 1.0;
    const Eigen::Vector2d expected = plain[0][s].centroid_px + by_px * normal(plain[0][s].segment);
    EXPECT_LT((moved[0][s].centroid_px - expected).norm(), kTrackedTol) << s;
    EXPECT_EQ(moved[0][s].sigma_q_px, scale * plain[0][s].sigma_q_px) << s;
  }
}

TEST(Extracted, RejectsObservationsThatAreNotThere) {
  TwoTrackedLines two;
  two.tracks = {{{{0, 0}, {5, 0}}}};
  EXPECT_THROW(extracted(two.tracked()), std::invalid_argument);
  two.tracks = {{{{0, 0}, {1, 3}}}};
  EXPECT_THROW(extracted(two.tracked()), std::invalid_argument);
  two.tracks = {{{{1, 1}, {1, 2}, {0, 1}}}};
  EXPECT_THROW(extracted(two.tracked()), std::invalid_argument);
  two.tracks = {{{{0, 0}}}};
  EXPECT_THROW(extracted(two.tracked()), std::invalid_argument);
}

TEST(ConditionedViews, OfManyViewsHaveTheirEpipolarGeometry) {
  const TwoTrackedLines two;
  const TrackedLines lines = two.lines();
  const Segment3& truth = two.block.lines[0];
  const Eigen::Vector3d x = lines.frames.object.conditioned_from_local(truth.start);
  for (std::size_t v = 0; v < two.cameras.size(); ++v) {
    const Eigen::Vector2d in_v = lines.lines[0].observations[v].segment.start;
    EXPECT_LT((project(lines.frames.views[v].image_from_object, x) - in_v).norm(), kTrackedTol);
    EXPECT_LE(in_v.norm(), 1.0 + kTrackedTol);
    for (std::size_t w = 0; w < two.cameras.size(); ++w) {
      if (w == v) continue;
      const Eigen::Vector2d in_w = lines.lines[0].observations[w].segment.start;
      const Eigen::Matrix3d f = lines.frames.fundamental(v, w);
      EXPECT_NEAR(in_w.homogeneous().dot(f * in_v.homogeneous()), 0.0, kTrackedTol) << v << w;
      EXPECT_EQ(f, lines.frames.fundamental(w, v).transpose());
    }
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
