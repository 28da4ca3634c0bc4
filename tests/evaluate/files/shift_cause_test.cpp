// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/shift_cause.h"

#include "evaluate/files/judged_lines.h"
#include "reconstruct/geometry/epipolar.h"

#include <gmock/gmock.h>

namespace ridgeline::results {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A significant shift whose axes are known to 1 cm.
evaluate::ConstantShift known_shift(const Eigen::Vector3d& shift_m) {
  evaluate::ConstantShift shift;
  shift.shift_m = shift_m;
  shift.accuracy_m = 0.034;
  shift.least_m = shift_m.norm() - 0.01;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = shift_m[static_cast<Eigen::Index>(i)];
    shift.axes[i] = {x, evaluate::Interval{x - 0.01, x + 0.01}};
  }
  return shift;
}

/// A place near Stuttgart, where the geoid lies 48.5 m above the ellipsoid.
ShiftPlace stuttgart() {
  ShiftPlace place;
  place.frame = {Eigen::Vector3d(513200.0, 5403000.0, 250.0)};
  place.crs = {"EPSG:25832"};
  return place;
}

TEST(LikelyCause, OfAHeightOfTheGeoidSaysWhichHeightsAreWhich) {
  EXPECT_THAT(
      likely_cause(known_shift({0.0, 0.0, 48.1}), stuttgart()),
      AllOf(HasSubstr("above the ellipsoid here (grid egm96_15.gtx)"),
            HasSubstr("lines seem to have heights above the ellipsoid and the cloud heights above "
                      "the geoid")));
  EXPECT_THAT(
      likely_cause(known_shift({0.0, 0.0, -48.1}), stuttgart()),
      HasSubstr("lines seem to have heights above the geoid and the cloud heights above the "
                "ellipsoid"));
}

TEST(LikelyCause, IsNotTheGeoidForAnotherHeight) {
  EXPECT_EQ(likely_cause(known_shift({0.0, 0.0, 40.0}), stuttgart()), "");
  EXPECT_EQ(likely_cause(known_shift({0.0, 0.0, 0.3}), stuttgart()), "");
}

TEST(LikelyCause, NamesTheGridThatWouldTell) {
  ShiftPlace place = stuttgart();
  place.crs = {"EPSG:25832+7837"};
  EXPECT_THAT(likely_cause(known_shift({0.0, 0.0, 40.0}), place),
              AllOf(HasSubstr("PROJ lacks the grid"), HasSubstr("GCG2016"), HasSubstr("`geoid`")));
  place.crs = {};
  EXPECT_THAT(likely_cause(known_shift({0.0, 0.0, 40.0}), place),
              HasSubstr("no reference system is stated"));
}

/// Two vertical cameras, whose pixels are `gsd_m` on the ground. Columns run east, rows south; the
/// second camera is turned by 180 degrees if `turned`.
std::optional<io::Patch> vertical_pair(double gsd_m, bool turned) {
  constexpr double kFocalLength_px = 10000.0;
  io::Patch patch;
  for (const bool is_second : {false, true}) {
    const double sign = is_second && turned ? -1.0 : 1.0;
    ProjectionMatrix camera;
    camera << sign * kFocalLength_px, 0.0, 0.0, 0.0, 0.0, -sign * kFocalLength_px, 0.0, 0.0, 0.0,
        0.0, -1.0, kFocalLength_px * gsd_m;
    io::PatchImage& image = patch.images.emplace_back();
    image.image_from_world =
        image_from_local(camera, Eigen::Vector3d(is_second ? -100.0 : 0.0, 0.0, 0.0));
  }
  return patch;
}

TEST(LikelyCause, OfHalfAPixelInRowsAndColumns) {
  const auto cameras = vertical_pair(0.6, false);
  ShiftPlace place;
  place.patch = &cameras;
  EXPECT_THAT(likely_cause(known_shift({0.3, -0.3, 0.0}), place), HasSubstr("half a pixel"));
  EXPECT_THAT(likely_cause(known_shift({-0.3, 0.3, 0.0}), place), HasSubstr("half a pixel"));
  EXPECT_EQ(likely_cause(known_shift({0.3, 0.3, 0.0}), place), "") << "one half forwards, one back";
  EXPECT_EQ(likely_cause(known_shift({0.3, 0.0, 0.0}), place), "");
  EXPECT_EQ(likely_cause(known_shift({0.3, -0.3, 0.5}), place), "") << "not a height, too";
  const auto turned = vertical_pair(0.6, true);
  place.patch = &turned;
  EXPECT_EQ(likely_cause(known_shift({0.3, -0.3, 0.0}), place), "")
      << "its images contradict each other";
}

TEST(Moved, LinesKeepTheirPlaceInTheirImages) {
  constexpr double kRounding_px = 1e-6;
  evaluate::JudgedLine line;
  line.segment = {{1.0, 2.0, 3.0}, {5.0, 2.0, 4.0}};
  evaluate::ImageEvidence evidence;
  for (std::size_t i = 0; i < 2; ++i)
    evidence.observations.push_back({vertical_pair(0.1, false)->images[i].image_from_world,
                                     {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()}});
  evidence.height_range_m = {0.0, 20.0};
  line.images = evidence;
  const Eigen::Vector3d by_m(0.5, -1.0, 45.0);
  const evaluate::JudgedLine after = moved(std::vector{line}, by_m).front();
  EXPECT_TRUE(after.segment.start.isApprox(line.segment.start + by_m));
  EXPECT_EQ(after.images->height_range_m[1], 65.0);
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector2d before_px =
        project(line.images->observations[i].image_from_local, line.segment.end);
    const Eigen::Vector2d after_px =
        project(after.images->observations[i].image_from_local, after.segment.end);
    EXPECT_LT((before_px - after_px).norm(), kRounding_px);
  }
}

}  // namespace
}  // namespace ridgeline::results
