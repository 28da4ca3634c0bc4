// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/core.h"

#include "tests/reconstruct/match/chio_wang2000/our_extensions.h"
#include "tests/reconstruct/match/ok2011/painted_pair.h"

#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::PaintedPair;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The west eave of a flat roof at 6 m and what is made of it.
class Core : public testing::Test {
 protected:
  static constexpr PaintedPair::Roof kRoof{-6.0, -5.0, 6.0, 5.0, 6.0};
  static constexpr double kFlat = 0.05;

  Core() : pair_({kRoof}) {}

  void add(const Segment3& in_left, const Segment3& in_right) { pair_.add_line(in_left, in_right); }

  [[nodiscard]] CoreCandidates candidates(
      const ChioOptions& options, const ChioExtensions& beyond = test::kOurExtensions) const {
    CandidateOptions wide;
    wide.max_slope_deg = 85.0;
    wide.max_turn_deg = 80.0;
    return core_candidates(pair_.searched(), options, wide, beyond).front();
  }

  PaintedPair pair_;
  const Segment3 eave_{{-6.0, -5.0, 6.0}, {-6.0, 5.0, 6.0}};
};

TEST_F(Core, PassesTheTrueCounterpart) {
  add(eave_, eave_);
  const CoreCandidates found = candidates({});
  ASSERT_EQ(found.list.size(), 1U);
  EXPECT_TRUE(found.list[0].may_begin);
  EXPECT_GT(found.list[0].chain.n_reliable, 60);  // it is 125 px long; some is not seen
  EXPECT_NEAR(found.list[0].chain.mean_height_m, 6.0, 0.2);
  EXPECT_NEAR(found.gsd_m, 0.08, 0.005);
}

TEST_F(Core, RejectsWithTheReason) {
  add(eave_, eave_);
  ChioOptions options;
  options.min_pieces = 500;
  EXPECT_EQ(candidates(options).reason, ChioOutcome::kFewPieces);
  EdgeSegment& counterpart = pair_.views[1].segments[0];
  for (Flank* flank : {&counterpart.left, &counterpart.right}) flank->colour[0] += 30.0F / 255.0F;
  EXPECT_EQ(candidates({}, {}).reason, ChioOutcome::kFlank);
}

TEST_F(Core, RejectsALineOnTextureAlongTheBaseAsUneven) {
  const auto of_line_to = [&](double y_m) {  // on open ground, where its edge pixels scatter
    for (View& view : pair_.views) view.segments.clear();
    pair_.add_line({{-5.0, -7.0, 0.0}, {5.0, y_m, 0.0}});
    return candidates({}, {});
  };
  EXPECT_EQ(of_line_to(-9.0).reason, ChioOutcome::kUneven);  // 7 m/m
  const CoreCandidates across = of_line_to(-15.0);           // 2.7 m/m
  ASSERT_EQ(across.list.size(), 1U);
  EXPECT_TRUE(across.list[0].may_begin);
}

TEST_F(Core, RejectsASteepLineAndATurnedOne) {
  // its counterpart implies a rise of 14 m over 10 m, which also turns it by 0.26 * 1.4: 20 degrees
  pair_.add_segment(0, eave_);
  const Eigen::Vector3d centre(0.0, 0.0, test::StereoPair::kHeight_m);
  const auto along_ray = [&](const Eigen::Vector3d& x, double z) {
    return Eigen::Vector3d(centre + (z - centre.z()) / (x.z() - centre.z()) * (x - centre));
  };
  pair_.add_segment(1, {along_ray(eave_.start, 2.0), along_ray(eave_.end, 16.0)});
  ChioOptions options;
  EXPECT_EQ(candidates(options, {}).reason, ChioOutcome::kAzimuth);
  options.max_azimuth_deg = 90.0;
  EXPECT_EQ(candidates(options).reason, ChioOutcome::kSteep);
}

TEST_F(Core, WithoutARightSegmentThereIsNoCandidate) {
  pair_.add_segment(0, eave_);
  const CoreCandidates found = candidates({});
  EXPECT_THAT(found.list, IsEmpty());
  EXPECT_EQ(found.reason, ChioOutcome::kNoCandidate);
}

TEST_F(Core, LinksFragmentsOfOneEdgeOnly) {
  pair_.add_segment(0, eave_);
  pair_.add_segment(1, {eave_.start, point_at(eave_, 0.45)});
  pair_.add_segment(1, {point_at(eave_, 0.5), eave_.end});
  // this line runs beside it, with the same rate and azimuth
  const Eigen::Vector3d aside(0.6, 0.0, 0.0);
  pair_.add_segment(1, {point_at(eave_, 0.6) + aside, eave_.end + aside});
  ChioOptions options;
  options.min_pieces = 5;
  const CoreCandidates found = candidates(options);
  std::vector<int> order;
  for (const CoreCandidate& c : found.list) order.push_back(c.right);
  const auto index_of = [&](int right) {
    return static_cast<int>(std::find(order.begin(), order.end(), right) - order.begin());
  };
  ASSERT_LT(index_of(0), static_cast<int>(order.size()));
  EXPECT_THAT(linked_fragments(found, index_of(0), pair_.views[1], options, test::kOurExtensions),
              ElementsAre(index_of(1)));
}

}  // namespace
}  // namespace ridgeline::reconstruct
