// SPDX-License-Identifier: BSD-3-Clause
// A line of 10 m along s over level ground of 5 points/m2, which is the plane chosen for it.
#include "evaluate/judge/doubt.h"

#include "tests/evaluate/judge/nadir_pair.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>

namespace ridgeline::evaluate {
namespace {

using testing::Eq;
using testing::HasSubstr;
using testing::Ne;
using testing::Optional;

constexpr double kLength_m = 10.0;
constexpr double kDensity_per_m2 = 5.0;

class Doubt : public testing::Test {
 protected:
  Doubt() {
    ground_.fit = fit_of_strip(150, 1.5);
    decision_.status = Status::kEvaluated;
    decision_.kind = Kind::kStep;
    decision_.planes = {0};
    constexpr double kHalf_m = 1.5;
    add_ground(-kHalf_m, kHalf_m);
  }

  /// Level ground from `n` points with noise of 3.4 cm, spread evenly over a strip along the whole line that
  /// reaches from the line to `width_m` on its left.
  static PlaneFit fit_of_strip(int n, double width_m) {
    PlaneFit fit;
    fit.plane = Plane3(Eigen::Vector3d::UnitZ(), 0.0);
    fit.centroid = {-0.5 * width_m, 0.5 * kLength_m, 0.0};
    fit.axes << 0.0, 1.0, 1.0, 0.0, 0.0, 0.0;
    // a uniform distribution of width w has the variance w^2 / 12
    fit.spread_m2 = n * Eigen::Vector2d(kLength_m, width_m).cwiseAbs2() / 12.0;
    fit.n = n;
    fit.sigma0_m = 0.034;
    return fit;
  }

  /// Adds a point. The line runs north along s, across the base of the images.
  void add(double s, double t, double z) { zone_.push_back({{-t, s, z}, s, t, 0}); }

  void add_ground(double t_from, double t_to) {
    const auto n = static_cast<int>((t_to - t_from) * kLength_m * kDensity_per_m2);
    for (int i = 0; i < n; ++i) {
      add(random_.uniform(0.0, kLength_m), random_.uniform(t_from, t_to), 0.0);
    }
  }

  [[nodiscard]] std::optional<std::string> reason(
      const std::optional<ImageEvidence>& images = std::nullopt) const {
    const Footprint footprint{{0, 0}, {0, 1}, {-1, 0}, kLength_m};
    return reason_for_doubt(zone_, std::vector{ground_}, decision_, footprint, images, {});
  }

  /// What images show of a line at a height.
  static ImageEvidence seen_at(double z) { return test::seen({{0, 0, z}, {0, kLength_m, z}}); }

  test::Random random_{11};
  std::vector<ZonePoint> zone_;
  CandidatePlane ground_;
  EdgeDecision decision_;
};

TEST_F(Doubt, IsNoneOnOpenGround) { EXPECT_THAT(reason(), Eq(std::nullopt)); }

TEST_F(Doubt, APlaneKnownLessWellThanThreePointsWouldTellGivesOne) {
  // at the border of a strip n points tell as much as n / 4 at the place: 1/n + (w/2)^2 / (n w^2/12) = 4/n
  ground_.fit = fit_of_strip(13, 1.5);
  EXPECT_THAT(reason(), Eq(std::nullopt));
  ground_.fit = fit_of_strip(11, 1.5);
  EXPECT_THAT(reason(), Optional(HasSubstr("known to 0.0205 m at the line")));
}

TEST_F(Doubt, AFenceOfFewPointsInTheLineGivesOne) {
  for (const double s : {1.0, 3.0, 5.0, 7.0, 9.0}) add(s, 0.1, 1.2);
  EXPECT_THAT(reason(), Ne(std::nullopt));
}

TEST_F(Doubt, TwoPointsInTheLineGiveOneIfTheImagesShowItOffTheSurface) {
  zone_.erase(zone_.begin() + zone_.size() / 4, zone_.end());  // as many as beside a line of 2.5 m
  add(1.0, 0.1, 1.2);
  add(2.0, 0.1, 1.2);
  EXPECT_THAT(reason(), Eq(std::nullopt));
  EXPECT_THAT(reason(seen_at(0.0)), Eq(std::nullopt));
  EXPECT_THAT(reason(seen_at(1.2)), Ne(std::nullopt));
}

TEST_F(Doubt, ImagesThatShowDifferentPartsOfALineDoNotShowItOffTheSurface) {
  zone_.erase(zone_.begin() + zone_.size() / 4, zone_.end());
  add(1.0, 0.1, 1.2);
  add(2.0, 0.1, 1.2);
  ImageEvidence images = seen_at(0.0);
  Segment2& other = images.sightings[1].px;
  const Eigen::Vector2d along = other.end - other.start;
  other = {other.start + 0.2 * along, other.end - 0.2 * along};
  EXPECT_THAT(reason(images), Eq(std::nullopt));
}

TEST_F(Doubt, AsFewPointsAsideGiveNone) {
  for (const double s : {1.0, 3.0, 5.0, 7.0, 9.0}) add(s, 0.5, 1.2);
  EXPECT_THAT(reason(), Eq(std::nullopt));
}

TEST_F(Doubt, PointsInTheLineFarAboveItsSurfaceAreACanopy) {
  for (const double s : {1.0, 3.0, 5.0, 7.0, 9.0}) add(s, 0.1, 5.0);
  EXPECT_THAT(reason(), Eq(std::nullopt));
  EXPECT_THAT(reason(seen_at(0.0)), Eq(std::nullopt));
}

TEST_F(Doubt, ALineThatImagesShowMetresOffIsWrongWhereThePlaneExplainsEverything) {
  EXPECT_THAT(reason(seen_at(5.0)), Eq(std::nullopt));
}

TEST_F(Doubt, ALineThatImagesShowMetresOffMayBelongToPointsThatNoPlaneExplains) {
  for (int i = 0; i < 40; ++i) add(random_.uniform(0.0, kLength_m), 1.2, random_.uniform(3.0, 7.0));
  EXPECT_THAT(reason(), Eq(std::nullopt));
  EXPECT_THAT(reason(seen_at(0.0)), Eq(std::nullopt));
  EXPECT_THAT(reason(seen_at(5.0)), Ne(std::nullopt));
}

TEST_F(Doubt, TreesCloseToALineThatImagesShowMetresOffGiveOne) {
  for (int i = 0; i < 20; ++i) {
    add(random_.uniform(0.0, kLength_m), random_.uniform(-0.4, 0.4), random_.uniform(3.0, 7.0));
  }
  EXPECT_THAT(reason(seen_at(5.0)), Ne(std::nullopt));
}

TEST_F(Doubt, AFewPointsOnOneSideDoNotMakeTheOtherOneEmpty) {
  zone_.clear();
  for (const double s : {1.0, 5.0, 9.0}) add(s, 0.8, 0.0);
  EXPECT_THAT(reason(seen_at(5.0)), Eq(std::nullopt));
}

TEST_F(Doubt, ALineThatImagesShowMetresOffMayLieWhereTheCloudIsEmpty) {
  zone_.clear();
  add_ground(0.3, 1.5);
  add(5.0, -0.1, 0.0);  // it straddles the line and is on no side
  EXPECT_THAT(reason(), Eq(std::nullopt));
  EXPECT_THAT(reason(seen_at(0.0)), Eq(std::nullopt));
  EXPECT_THAT(reason(seen_at(5.0)), Ne(std::nullopt));
}

}  // namespace
}  // namespace ridgeline::evaluate
