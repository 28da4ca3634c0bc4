// SPDX-License-Identifier: BSD-3-Clause
// Lines that are moved on purpose: where they end up, what their images show, and which lines are
// drawn.
#include "evaluate/statistics/decoys.h"

#include "reconstruct/geometry/epipolar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

constexpr double kMovedTol =
    1e-9;  // a few roundings of coordinates of hundreds of metres and of thousands of pixels

/// A camera 500 m above the ground that looks straight down, focal length 1000 px.
ProjectionMatrix camera_above(double x_m, double y_m) {
  constexpr double kHeight_m = 500.0;
  ProjectionMatrix p;
  p << 1000.0, 0.0, -500.0, 0.0, 0.0, -1000.0, -500.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  p.col(3) = -p.leftCols<3>() * Eigen::Vector3d(x_m, y_m, kHeight_m);
  return p;
}

JudgedLine line_from(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  JudgedLine line;
  line.id = "line";
  line.segment = {start, end};
  return line;
}

/// A line that three images show, each beside its projection and the second one from the other end.
JudgedLine seen_line() {
  JudgedLine line = line_from({10.0, 20.0, 8.0}, {16.0, 28.0, 9.0});
  ImageEvidence images{{}, {-10.0, 40.0}};
  for (const double x_m : {-100.0, 0.0, 120.0}) {
    const ProjectionMatrix camera = camera_above(x_m, 5.0);
    images.observations.push_back({camera, project(camera, line.segment)});
  }
  images.base().px.start += Eigen::Vector2d(0.4, -0.1);
  std::swap(images.other().px.start, images.other().px.end);
  images.other().px.start += Eigen::Vector2d(0.7, -0.2);  // beside the line's end
  images.observations[2].px.end += Eigen::Vector2d(-3.0, 1.5);
  line.images = images;
  return line;
}

void expect_near(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), kMovedTol) << a.transpose() << " | " << b.transpose();
}

TEST(MovedLine, InHeightKeepsItsPlanAndItsImages) {
  const JudgedLine line = seen_line();
  const JudgedLine down = moved_line(line, DecoyKind::kHeight, -2.0).value();
  expect_near(down.segment.start, Eigen::Vector3d(10.0, 20.0, 6.0));
  expect_near(down.segment.end, Eigen::Vector3d(16.0, 28.0, 7.0));
  EXPECT_EQ(down.images->observations[2].px.end, line.images->observations[2].px.end);
}

TEST(MovedLine, AcrossGoesToTheLeftWhateverEndComesFirst) {
  // direction (6, 8) in plan, to its left (-0.8, 0.6)
  JudgedLine line = seen_line();
  const JudgedLine left = moved_line(line, DecoyKind::kAcross, 5.0).value();
  expect_near(left.segment.start, Eigen::Vector3d(6.0, 23.0, 8.0));
  expect_near(left.segment.end, Eigen::Vector3d(12.0, 31.0, 9.0));
  std::swap(line.segment.start, line.segment.end);
  const JudgedLine turned = moved_line(line, DecoyKind::kAcross, 5.0).value();
  expect_near(turned.segment.end, left.segment.start);
  EXPECT_FALSE(moved_line(line_from({1, 2, 3}, {1, 2, 9}), DecoyKind::kAcross, 1.0));
}

TEST(MovedLine, OfAFalseMatchStaysOnTheRaysOfTheFirstImage) {
  const JudgedLine line = seen_line();
  const JudgedLine decoy = moved_line(line, DecoyKind::kMatch, 5.0).value();
  EXPECT_NEAR(decoy.segment.start.z(), 13.0, kMovedTol);
  EXPECT_NEAR(decoy.segment.end.z(), 14.0, kMovedTol);
  // 492 m below the camera at x = -100: 5 m up are 5 / 492 of the way to it
  expect_near(decoy.segment.start, Eigen::Vector3d(10.0, 20.0, 8.0) +
                                       5.0 / 492.0 * Eigen::Vector3d(-110.0, -15.0, 492.0));
  const ProjectionMatrix& base = line.images->base().image_from_local;
  expect_near(project(base, decoy.segment.start), project(base, line.segment.start));
  EXPECT_EQ(decoy.images->base().px.start, line.images->base().px.start);
}

TEST(MovedLine, OfAFalseMatchHasTheLinesOwnResidualsInTheOtherImages) {
  const JudgedLine line = seen_line();
  const JudgedLine decoy = moved_line(line, DecoyKind::kMatch, -2.0).value();
  const auto projected = [&](std::size_t image) {
    return project(line.images->observations[image].image_from_local, decoy.segment);
  };
  const std::vector<ImageObservation>& seen = decoy.images->observations;
  expect_near(seen[1].px.start, projected(1).end + Eigen::Vector2d(0.7, -0.2));
  expect_near(seen[1].px.end, projected(1).start);
  expect_near(seen[2].px.start, projected(2).start);
  expect_near(seen[2].px.end, projected(2).end + Eigen::Vector2d(-3.0, 1.5));
}

TEST(MovedLine, OfAFalseMatchNeedsImagesTheirHeightsAndSteepRays) {
  JudgedLine line = seen_line();
  EXPECT_TRUE(moved_line(line, DecoyKind::kMatch, 5.0));
  line.images->height_range_m = {0.0, 12.0};  // 8 and 9 m become 13 and 14 m
  EXPECT_FALSE(moved_line(line, DecoyKind::kMatch, 5.0));
  EXPECT_TRUE(moved_line(line, DecoyKind::kMatch, 2.0));
  line.images->base().image_from_local = camera_above(-6000.0, 5.0);  // 12 m aside per metre down
  EXPECT_FALSE(moved_line(line, DecoyKind::kMatch, 2.0));
  EXPECT_FALSE(moved_line(line_from({0, 0, 1}, {5, 0, 1}), DecoyKind::kMatch, 2.0));
  EXPECT_THROW(moved_line(line, DecoyKind::kElsewhere, 20.0), std::invalid_argument);
}

/// Lines of 3 to 9 m at random places.
std::vector<JudgedLine> random_lines(std::size_t n) {
  std::mt19937_64 rng(5);
  std::uniform_real_distribution<double> place(-200.0, 200.0);
  std::uniform_real_distribution<double> step(2.0, 6.0);
  std::vector<JudgedLine> lines;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d start(place(rng), place(rng), 5.0);
    lines.push_back(line_from(start, start + Eigen::Vector3d(step(rng), step(rng), 0.0)));
    lines.back().id = std::to_string(i);
  }
  return lines;
}

/// The places of the decoys, which say all that geometry decides.
std::multiset<std::string> places_of(const std::vector<Decoy>& decoys) {
  std::multiset<std::string> places;
  for (const Decoy& d : decoys) {
    places.insert(d.line.id + std::to_string(midpoint(d.line.segment).sum()));
  }
  return places;
}

TEST(MakeDecoys, DoNotDependOnIdsAndOrder) {
  std::vector<JudgedLine> lines = random_lines(600);
  const std::multiset<std::string> first = places_of(make_decoys(lines, 250));
  const std::multiset<std::string> far = places_of(move_elsewhere(lines));
  std::ranges::reverse(lines);
  for (JudgedLine& line : lines) {
    line.id += " renamed";
    std::swap(line.segment.start, line.segment.end);
  }
  EXPECT_EQ(places_of(make_decoys(lines, 250)), first);
  EXPECT_EQ(places_of(move_elsewhere(lines)), far);
}

TEST(MakeDecoys, AreSpreadOverKindsAndDistances) {
  const std::vector<JudgedLine> lines = random_lines(4000);
  std::map<std::pair<DecoyKind, double>, int> n;
  const std::vector<Decoy> decoys = make_decoys(lines, default_n_decoys(lines.size()));
  EXPECT_EQ(decoys.size(), 2000U);
  for (const Decoy& d : decoys) ++n[{d.kind, d.distance_m}];
  EXPECT_EQ(n.size(), 8U);  // no line has images
  // 250 expected, standard deviation 15: beyond 5 of them by chance once in a million
  for (const auto& [cell, count] : n) EXPECT_NEAR(count, 250, 75);
}

TEST(MakeDecoys, MoveFewLinesInSeveralWays) {
  const std::vector<JudgedLine> lines = random_lines(100);
  EXPECT_EQ(make_decoys(lines, 500).size(), 500U);  // five ways each
  EXPECT_EQ(make_decoys(lines, 250).size(), 250U);  // half of them two ways, half three
  const std::vector<Decoy> of_few = make_decoys(std::span(lines).first(3), 200);
  EXPECT_EQ(of_few.size(), 48U);  // three lines in every way, 2 kinds x 4 distances x 2 senses
  std::set<std::string> ids;
  for (const Decoy& d : of_few) ids.insert(d.line.id);
  EXPECT_EQ(ids.size(), of_few.size());
  EXPECT_TRUE(make_decoys(lines, 0).empty());
}

TEST(MakeDecoys, LeaveOutLinesThatCannotBeJudgedAndCopies) {
  std::vector<JudgedLine> lines = random_lines(3);
  lines[1].segment = lines[0].segment;
  lines[2].reconstructed = false;
  for (const Decoy& d : make_decoys(lines, 200)) EXPECT_EQ(d.parent, 0U);
}

TEST(DefaultNDecoys, AreHalfWithinLimits) {
  EXPECT_EQ(default_n_decoys(10), 200U);
  EXPECT_EQ(default_n_decoys(3000), 1500U);
  EXPECT_EQ(default_n_decoys(100'000), 2000U);
}

TEST(MoveElsewhere, MovesInPlanWithTheCamerasAndStaysAmongTheLines) {
  std::vector<JudgedLine> lines = random_lines(50);
  lines.push_back(seen_line());
  bool has_moved_seen = false;
  for (const Decoy& d : move_elsewhere(lines)) {
    const Segment3& before = lines[d.parent].segment;
    const Eigen::Vector3d by = d.line.segment.start - before.start;
    EXPECT_NEAR(by.norm(), d.distance_m, kMovedTol);
    EXPECT_EQ(by.z(), 0.0);
    EXPECT_LT(midpoint(d.line.segment).head<2>().cwiseAbs().maxCoeff(), 206.0);
    if (d.parent != 50) continue;
    has_moved_seen = true;
    const ImageObservation& here = lines[50].images->observations[2];
    const ImageObservation& there = d.line.images->observations[2];
    EXPECT_EQ(there.px.start, here.px.start);
    expect_near(project(there.image_from_local, d.line.segment.start),
                project(here.image_from_local, before.start));
  }
  EXPECT_TRUE(has_moved_seen);
}

TEST(MoveElsewhere, LeavesALineThatHasNowhereToGo) {
  EXPECT_TRUE(move_elsewhere(std::vector{seen_line()}).empty());
  EXPECT_TRUE(move_elsewhere({}).empty());
}

}  // namespace
}  // namespace ridgeline::evaluate
