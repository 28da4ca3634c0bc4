// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/merge_lines.h"

#include <Eigen/Dense>
#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <random>

namespace ridgeline::reconstruct {
namespace {

const PatchGrid kGrid{100.0};
constexpr double kOverlap_m = 20.0;
constexpr double kSigma_m = 0.02;                           // of an end, per axis
const Eigen::Vector3d kCorner(513000.0, 5403000.0, 250.0);  // of a square

UncertainLine uncertain(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  return {{kCorner + start, kCorner + end},
          kSigma_m * kSigma_m * Eigen::Matrix<double, 6, 6>::Identity()};
}

/// The square that lies so many columns and rows from that of kCorner.
GridCell square_at(std::int64_t columns, std::int64_t rows = 0) {
  const GridCell first = kGrid.cell_of(kCorner.head<2>());
  return {first.column + columns, first.row + rows};
}

FoundLine found(const Eigen::Vector3d& start, const Eigen::Vector3d& end, std::int64_t columns) {
  return {uncertain(start, end), square_at(columns)};
}

std::vector<MergedLine> merged(const std::vector<FoundLine>& lines) {
  return merge_lines(lines, kGrid, {.overlap_m = kOverlap_m});
}

/// Noise of the ends of a line, by its covariance.
class Noise {
 public:
  Eigen::Vector3d operator()() {
    return kSigma_m * Eigen::Vector3d(normal_(r_), normal_(r_), normal_(r_));
  }

 private:
  std::mt19937 r_{7};
  std::normal_distribution<double> normal_;
};

TEST(MergeLines, LineThatTwoPatchesFindIsOneAndBelongsToTheSquareOfItsMidpoint) {
  const auto lines =
      merged({found({90, 50, 0}, {112, 50, 0}, 0), found({90, 50, 0}, {112, 50, 0}, 1)});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].line, 1U);
}

TEST(MergeLines, LineThatItsOwnSquareDoesNotHaveIsLeftOut) {
  EXPECT_TRUE(merged({found({102, 50, 0}, {118, 50, 0}, 0)}).empty());
  EXPECT_EQ(merged({found({102, 50, 0}, {118, 50, 0}, 1)}).size(), 1U);
}

TEST(MergeLines, NoiseOfAMidpointOnTheSeamNeitherLosesNorDoublesALine) {
  Noise noise;
  int n_lines = 0;
  constexpr int kLines = 400;
  for (int i = 0; i < kLines; ++i) {
    const Eigen::Vector3d start(95, 50, 0), end(105, 52, 1);
    n_lines += static_cast<int>(
        merged({found(start + noise(), end + noise(), 0), found(start + noise(), end + noise(), 1)})
            .size());
  }
  // A thousandth of the duplicates is taken for two lines by chance; of these half lose or double
  // one.
  EXPECT_NEAR(n_lines, kLines, 2);
}

TEST(MergeLines, LineOfFivePatchesIsWholeAndOnce) {
  std::vector<FoundLine> lines;
  Noise noise;
  const Eigen::Vector3d start(30, 40, 0), end(470, 62, 4);
  for (std::int64_t k = 0; k < 5; ++k) {
    // Each patch sees what lies within its square and the overlap; every second one runs the other
    // way.
    const auto at = [&](double x) -> Eigen::Vector3d {
      return start + (std::clamp(x, 30.0, 470.0) - 30.0) / 440.0 * (end - start) + noise();
    };
    const double from = 100.0 * static_cast<double>(k) - kOverlap_m;
    const Eigen::Vector3d a = at(from), b = at(from + 100.0 + 2.0 * kOverlap_m);
    lines.push_back(k % 2 == 0 ? found(a, b, k) : found(b, a, k));
  }
  // A fragment that its own square has beside the line, and that no patch but the fourth shows
  // beside the whole.
  const double slope = (end.y() - start.y()) / 440.0;
  lines.push_back(found({402, 40 + 372 * slope, 3.38}, {417, 40 + 387 * slope, 3.52}, 4));
  const auto whole = merged(lines);
  ASSERT_EQ(whole.size(), 1U);
  const Segment3& segment = whole[0].geometry.segment_in_world;
  const bool runs_on = segment.start.x() < segment.end.x();
  constexpr double kTolerance_m = 5.0 * kSigma_m;
  EXPECT_LT(((runs_on ? segment.start : segment.end) - kCorner - start).norm(), kTolerance_m);
  EXPECT_LT(((runs_on ? segment.end : segment.start) - kCorner - end).norm(), kTolerance_m);
  EXPECT_TRUE(whole[0].geometry.covariance_m2.allFinite());
  EXPECT_TRUE((whole[0].geometry.covariance_m2.topRightCorner<3, 3>().isZero()));
}

TEST(MergeLines, EavesAndGuttersBesideEachOtherStayTwo) {
  constexpr double kApart_m = 0.2;
  const auto lines = merged({found({92, 50, 0}, {107, 50, 0}, 0),
                             found({92, 50 + kApart_m, 0}, {107, 50 + kApart_m, 0}, 0),
                             found({92, 50, 0}, {107, 50, 0}, 1),
                             found({92, 50 + kApart_m, 0}, {107, 50 + kApart_m, 0}, 1)});
  EXPECT_EQ(lines.size(), 2U);
}

TEST(MergeLines, LinesThatCrossInTheOverlapStayTwo) {
  // Within the place that both patches show, x = 80 to 120, the short piece of one lies on the
  // other.
  const auto lines =
      merged({found({40, 50, 0}, {80.5, 50, 0}, 0), found({80, 50, 0}, {130, 75, 0}, 1)});
  EXPECT_EQ(lines.size(), 2U);
}

TEST(MergeLines, FragmentsGiveWayToTheWholeLine) {
  const auto lines =
      merged({found({85, 50, 0}, {110, 50, 0}, 0), found({85, 50, 0}, {96, 50, 0}, 1),
              found({98, 50, 0}, {110, 50, 0}, 1)});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].line, 0U);
}

TEST(MergeLines, FragmentsThatHardlyOverlapAreNoDuplicates) {
  EXPECT_EQ(
      merged({found({82, 50, 0}, {101, 50, 0}, 0), found({100, 50, 0}, {118, 50, 0}, 1)}).size(),
      2U);
}

TEST(MergeLines, FragmentsOfOnePatchAreNotMerged) {
  EXPECT_EQ(merged({found({10, 50, 0}, {20, 50, 0}, 0), found({19, 50, 0}, {30, 50, 0}, 0)}).size(),
            2U);
}

TEST(MergeLines, DuplicatesAreRecognisedByTheirCovariances) {
  // A line along the base of its images: its height is known to half a metre only. Each patch has
  // the midpoint of its own.
  FoundLine weak = found({88, 50, 0.7}, {108, 50, 0.7}, 0);
  const FoundLine other = found({92, 50, 0.0}, {112, 50, 0.0}, 1);
  EXPECT_EQ(merged({weak, other}).size(), 2U);
  weak.line.covariance_m2(2, 2) = weak.line.covariance_m2(5, 5) = 0.25;
  EXPECT_EQ(merged({weak, other}).size(), 1U);
}

/// Lines at random over some columns and three rows of squares, as all patches find them that have
/// their midpoint, in the order of the squares.
std::vector<FoundLine> town_of(std::int64_t columns) {
  Noise noise;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x_m(0.0, 100.0 * static_cast<double>(columns));
  std::uniform_real_distribution<double> y_m(0.0, 300.0), way(-30.0, 30.0);
  std::vector<FoundLine> lines;
  for (std::int64_t i = 0; i < 100 * columns; ++i) {
    const Eigen::Vector3d start(x_m(random), y_m(random), 0.0);
    const Eigen::Vector3d end = start + Eigen::Vector3d(way(random), way(random), 1.0);
    const Eigen::Vector3d middle = 0.5 * (start + end);
    for (std::int64_t column = 0; column < columns; ++column) {
      for (std::int64_t row = 0; row < 3; ++row) {
        const Eigen::Vector2d centre(100.0 * static_cast<double>(column) + 50.0,
                                     100.0 * static_cast<double>(row) + 50.0);
        if ((middle.head<2>() - centre).cwiseAbs().maxCoeff() > 50.0 + kOverlap_m) continue;
        lines.push_back({uncertain(start + noise(), end + noise()), square_at(column, row)});
      }
    }
  }
  std::ranges::stable_sort(lines, {}, &FoundLine::cell);
  return lines;
}

TEST(MergeLines, OrderOfThePatchesDoesNotMatter) {
  const std::vector<FoundLine> lines = town_of(3);
  const auto forward = merged(lines);
  std::vector<FoundLine> backward = lines;
  std::ranges::stable_sort(backward, std::greater(), &FoundLine::cell);
  const auto starts_of = [](const std::vector<MergedLine>& merged) {
    std::vector<double> starts;
    for (const MergedLine& line : merged)
      starts.push_back(line.geometry.segment_in_world.start.x());
    return starts;
  };
  EXPECT_GT(forward.size(), 280U);
  EXPECT_LT(forward.size(), 305U);
  EXPECT_EQ(starts_of(forward), starts_of(merged(backward)));
}

/// The lines of each column, in order.
std::vector<std::vector<FoundLine>> strips_of(const std::vector<FoundLine>& lines) {
  std::vector<std::vector<FoundLine>> strips;
  for (const FoundLine& line : lines) {
    if (strips.empty() || strips.back().back().cell.column != line.cell.column)
      strips.emplace_back();
    strips.back().push_back(line);
  }
  return strips;
}

TEST(LineMerger, StripByStripGivesTheLinesOfAllAtOnce) {
  std::vector<FoundLine> lines = town_of(8);
  // One line of all columns, so that what is merged before its end has to wait.
  for (std::int64_t column = 0; column < 8; ++column) {
    const double from = 100.0 * static_cast<double>(column) - kOverlap_m;
    lines.push_back(
        found({std::max(from, 10.0), 60, 0}, {std::min(from + 140.0, 790.0), 60, 0}, column));
  }
  std::ranges::stable_sort(lines, {}, &FoundLine::cell);
  LineMerger merger(kGrid, {.overlap_m = kOverlap_m});
  std::vector<MergedLine> in_strips;
  for (const std::vector<FoundLine>& strip : strips_of(lines))
    std::ranges::move(merger.add(strip), std::back_inserter(in_strips));
  EXPECT_LT(in_strips.size(), 50U);  // the line of all columns holds them back
  std::ranges::move(merger.finish(), std::back_inserter(in_strips));
  const std::vector<MergedLine> at_once = merged(lines);
  ASSERT_EQ(in_strips.size(), at_once.size());
  EXPECT_GT(at_once.size(), 750U);
  double longest_m = 0.0;
  for (std::size_t i = 0; i < at_once.size(); ++i) {
    EXPECT_EQ(in_strips[i].line, at_once[i].line);
    EXPECT_EQ(in_strips[i].cell, lines[at_once[i].line].cell);
    EXPECT_EQ(in_strips[i].geometry.segment_in_world.end, at_once[i].geometry.segment_in_world.end);
    EXPECT_EQ(in_strips[i].geometry.covariance_m2, at_once[i].geometry.covariance_m2);
    longest_m = std::max(longest_m, length(in_strips[i].geometry.segment_in_world));
  }
  EXPECT_NEAR(longest_m, 780.0, 1e-9);
}

TEST(LineMerger, NeedsTheLinesOfTwoColumnsOnly) {
  LineMerger merger(kGrid, {.overlap_m = kOverlap_m});
  std::size_t n_before = 0;  // lines of all columns but the last two
  std::size_t n_last = 0;
  std::size_t n_merged = 0;
  for (const std::vector<FoundLine>& strip : strips_of(town_of(12))) {
    n_merged += merger.add(strip).size();
    EXPECT_GE(merger.first_needed(), n_before);
    n_before += n_last;
    n_last = strip.size();
  }
  EXPECT_GT(n_merged, 900U);  // of about 1200
  n_merged += merger.finish().size();
  EXPECT_EQ(merger.first_needed(), n_before + n_last);
}

TEST(MergeLines, LinesFarApartInPlanAreNoDuplicatesWhateverTheirCovariances) {
  FoundLine weak = found({88, 51.5, 0}, {108, 51.5, 0}, 0);
  weak.line.covariance_m2 *= 2500.0;
  EXPECT_EQ(merged({weak, found({92, 50, 0}, {112, 50, 0}, 1)}).size(), 2U);
  weak.line.segment_in_world.start.y() -= 0.6;
  weak.line.segment_in_world.end.y() -= 0.6;
  EXPECT_EQ(merged({weak, found({92, 50, 0}, {112, 50, 0}, 1)}).size(), 1U);
}

TEST(MergeLines, NothingGivesNothing) { EXPECT_TRUE(merged({}).empty()); }

TEST(PatchGrid, SquaresLieAtMultiplesOfTheirSize) {
  EXPECT_EQ(kGrid.cell_of({-0.1, 199.9}), (GridCell{-1, 1}));
  EXPECT_EQ(kGrid.cell_of({100.0, 200.0}), (GridCell{1, 2}));
  EXPECT_EQ(kGrid.square({-1, 1}).min(), Eigen::Vector2d(-100.0, 100.0));
}

TEST(PatchGrid, SliversJoinTheirNeighbours) {
  using Box = Eigen::AlignedBox2d;
  using Eigen::Vector2d;
  constexpr double kOverlap_m = 1.0;  // slivers up to 2 m all the same
  const PatchGrid grid(100.0, Box(Vector2d(98.0, 98.5), Vector2d(302.0, 302.5)), kOverlap_m);
  EXPECT_EQ(grid.cell_of({98.0, 98.5}), (GridCell{1, 1}));
  EXPECT_EQ(grid.cell_of({302.0, 302.5}), (GridCell{2, 3}));  // 2.5 m are a row of their own
  EXPECT_EQ(grid.square({1, 1}).min(), Vector2d(0.0, 0.0));
  EXPECT_EQ(grid.square({2, 2}).max(), Vector2d(400.0, 300.0));
  EXPECT_EQ(grid.square({2, 3}).max(), Vector2d(400.0, 400.0));
  const PatchGrid wide(100.0, Box(Vector2d(98.0, 98.5), Vector2d(302.0, 302.5)), 20.0);
  EXPECT_EQ(wide.cell_of({302.0, 302.5}), (GridCell{2, 2}));
  const PatchGrid small(100.0, Box(Vector2d(99.0, 99.0), Vector2d(99.5, 99.5)), 20.0);
  EXPECT_EQ(small.cell_of({99.2, 99.2}), (GridCell{0, 0}));  // there is no neighbour
}

}  // namespace
}  // namespace ridgeline::reconstruct
