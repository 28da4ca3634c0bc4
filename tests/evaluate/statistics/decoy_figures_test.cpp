// SPDX-License-Identifier: BSD-3-Clause
// What is counted of lines that were moved on purpose, and of lines against themselves elsewhere.
#include "evaluate/statistics/decoy_figures.h"

#include "evaluate/judge/segment_plane.h"
#include "evaluate/statistics/cloud_following.h"
#include "evaluate/tables/decoy_json.h"
#include "evaluate/tables/decoy_table.h"
#include "tests/evaluate/statistics/lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

using testing::HasSubstr;

JudgedDecoy decoy(std::size_t parent, DecoyKind kind, double distance_m, LineEvaluation judged) {
  return {{parent, kind, distance_m, {}}, std::move(judged)};
}

JudgedDecoy at(std::size_t parent, double found_m) {
  return decoy(parent, DecoyKind::kHeight, 1.0, evaluated_line("d", found_m, 0));
}

JudgedDecoy withheld(std::size_t parent) {
  return decoy(parent, DecoyKind::kHeight, 1.0, excluded_line("d", Status::kAmbiguous));
}

TEST(DecoyFigures, HandCheckedCase) {
  const std::vector lines{evaluated_line("a", 0.1, 1), evaluated_line("b", 0.1, 1),
                          evaluated_line("c", 0.1, 2), excluded_line("x", Status::kNoPlane)};
  // Of lines that were evaluated: two of line a, one of b and of c. The one of x does not count.
  const std::vector decoys{at(0, 0.19), at(0, 1.0), withheld(1), at(2, -0.2), at(3, 0.1)};
  const std::vector<DecoyFigure> figures = decoy_figures(decoys, lines, {});
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].kind, DecoyKind::kHeight);
  EXPECT_EQ(figures[0].distance_m, 1.0);
  EXPECT_EQ(figures[0].n_lines, 3U);
  EXPECT_EQ(figures[0].n_decoys, 4U);
  EXPECT_EQ(figures[0].n_passed, 1U) << "0.2 m is not below 0.2 m";
  EXPECT_EQ(figures[0].n_withheld, 1U);
  EXPECT_EQ(figures[0].n_clusters, 2U) << "a and b share a plane";
  EXPECT_EQ(figures[0].share(), 0.25);
  EXPECT_EQ(figures[0].withheld_share(), 0.25);
}

TEST(DecoyFigures, AreByKindAndDistance) {
  const std::vector lines{evaluated_line("a", 0.1, 1)};
  std::vector<JudgedDecoy> decoys;
  for (const DecoyKind kind : kDecoyKinds) {
    for (const double distance_m : kDecoyDistances_m) {
      const double found_m = kind == DecoyKind::kAcross ? 0.0 : distance_m;
      decoys.push_back(decoy(0, kind, distance_m, evaluated_line("d", found_m, 0)));
    }
  }
  decoys.push_back(decoy(0, DecoyKind::kElsewhere, 20.0, evaluated_line("d", 0.0, 0)));
  const std::vector<DecoyFigure> figures = decoy_figures(decoys, lines, {});
  ASSERT_EQ(figures.size(), 12U);
  for (const DecoyFigure& f : figures) {
    EXPECT_EQ(f.n_decoys, 1U);
    EXPECT_EQ(f.share(), f.kind == DecoyKind::kAcross ? 1.0 : 0.0);
  }
  EXPECT_THROW(decoy_figures(decoys, {}, {}), std::invalid_argument);
}

TEST(DecoyFigures, HaveAnIntervalThatIsWiderForClusters) {
  std::vector<LineEvaluation> apart;
  std::vector<LineEvaluation> of_roofs;
  std::vector<JudgedDecoy> decoys;
  for (std::size_t i = 0; i < 200; ++i) {
    const std::string id = std::to_string(i);
    apart.push_back(evaluated_line(id, 0.1, i + 1));
    of_roofs.push_back(evaluated_line(id, 0.1, i / 20 + 1));
    decoys.push_back(at(i, i < 40 ? 0.0 : 1.0));  // those of the first two roofs pass
  }
  const Interval wide = decoy_figures(decoys, of_roofs, {})[0].ci95.value();
  const Interval narrow = decoy_figures(decoys, apart, {})[0].ci95.value();
  // 0.2 with a standard error of sqrt(0.2 * 0.8 / 200) = 0.028, or / 10 = 0.126 for ten roofs
  EXPECT_NEAR(narrow.high - narrow.low, 2 * 1.96 * 0.0283, 0.01);
  EXPECT_NEAR(wide.high - wide.low, 2 * 1.96 * 0.126, 0.12);
}

TEST(DecoyFigures, OfNoneThatPassesHaveTheWilsonInterval) {
  std::vector<LineEvaluation> lines;
  std::vector<JudgedDecoy> decoys;
  for (std::size_t i = 0; i < 189; ++i) {
    lines.push_back(evaluated_line(std::to_string(i), 0.1, i + 1));
    decoys.push_back(at(i, 1.0));
  }
  const Interval interval = decoy_figures(decoys, lines, {})[0].ci95.value();
  EXPECT_EQ(interval.low, 0.0);
  EXPECT_NEAR(interval.high, 3.8415 / (189 + 3.8415), 1e-5);  // z^2 / (n + z^2)
}

TEST(DecoyFigures, ComeBackFromJson) {
  const std::vector lines{evaluated_line("a", 0.1, 1), evaluated_line("b", 0.1, 2)};
  const std::vector<DecoyFigure> figures =
      decoy_figures(std::vector{at(0, 0.1), at(1, 1.0), withheld(1)}, lines, {});
  const Json json = decoys_json(figures);
  EXPECT_EQ(decoys_json(parse_decoys(json)), json);
  EXPECT_EQ(json[0]["kind"], "height");
  EXPECT_THROW(parse_decoys(Json::parse(R"([{"kind": "height"}])")), std::invalid_argument);
  EXPECT_THROW(parse_decoys(Json::parse(R"({"kind": 1})")), std::invalid_argument);
  Json unknown = json;
  unknown[0]["kind"] = "sideways";
  EXPECT_THROW(parse_decoys(unknown), std::invalid_argument);
}

TEST(DecoyTables, HaveEachFigureBesideTheShareThatWasWithheld) {
  const std::vector lines{evaluated_line("a", 0.1, 1), evaluated_line("b", 0.1, 2)};
  Evaluation e;
  e.patch = "1";
  e.method = "joint";
  EXPECT_EQ(decoys_to_terminal(std::vector{e}), "");
  EXPECT_EQ(decoys_to_markdown(e), "");
  e.decoys = decoy_figures(std::vector{at(0, 0.1), at(1, 1.0), withheld(1), at(0, 2.0)}, lines, {});
  EXPECT_THAT(decoys_to_terminal(std::vector{e}), HasSubstr("25.0 (25.0)"));
  EXPECT_THAT(decoys_to_markdown(e), HasSubstr("| height | 1 m |"));
  EXPECT_THAT(decoys_to_csv(std::vector{e}), HasSubstr("1,joint,height,1,2,4,0.250000,"));
}

/// A line of 4 m at the height z, judged by the level plane at `surface_m`.
struct PlacedLine {
  JudgedLine line;
  LineEvaluation judged;
};
PlacedLine placed(double x_m, double z_m, double surface_m, std::uint64_t plane_id) {
  PlacedLine p;
  p.line.segment = {{x_m, 0.0, z_m}, {x_m + 4.0, 0.0, z_m}};
  p.judged = evaluated_line("l", z_m - surface_m, plane_id);
  p.judged.planes.resize(1);
  p.judged.planes[0].plane = Plane3(Eigen::Vector3d::UnitZ(), -surface_m);
  p.judged.planes[0].id = plane_id;
  return p;
}

/// Lines on roofs of their own, each moved to a surface that lies `step_m` lower.
class Following : public testing::Test {
 protected:
  void add(double error_m, double step_m, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      const double x_m = 20.0 * static_cast<double>(lines_.size());
      const PlacedLine here = placed(x_m, 8.0 + error_m, 8.0, lines_.size() + 1);
      const PlacedLine there = placed(x_m + 50.0, 8.0 + error_m, 8.0 - step_m, 0);
      elsewhere_.push_back(
          {{lines_.size(), DecoyKind::kElsewhere, 50.0, there.line}, there.judged});
      lines_.push_back(here.line);
      judged_.push_back(here.judged);
    }
  }
  [[nodiscard]] CloudFollowing result(double shift_up_m = 0.0) const {
    return cloud_following(lines_, judged_, elsewhere_, {0.0, 0.0, shift_up_m}, {});
  }

  std::vector<JudgedLine> lines_;
  std::vector<LineEvaluation> judged_;
  std::vector<JudgedDecoy> elsewhere_;
};

TEST_F(Following, LinesOnTheirRoofsFollow) {
  add(0.05, 5.0, 40);
  const CloudFollowing f = result();
  EXPECT_EQ(f.n_pairs, 40U);
  EXPECT_EQ(f.n_clusters, 40U);
  EXPECT_EQ(f.share, 1.0);
  EXPECT_EQ(f.share_elsewhere, 0.0);
  EXPECT_FALSE(f.is_of_another_place());
  EXPECT_FALSE(f.is_weak());
}

TEST_F(Following, LinesThatFitHereAsOftenAsThereAreOfAnotherPlace) {
  add(2.5, 5.0, 80);
  add(0.0, 5.0, 3);   // fit here
  add(-5.0, 5.0, 3);  // fit there
  const CloudFollowing f = result();
  EXPECT_EQ(f.difference(), 0.0);
  EXPECT_TRUE(f.is_of_another_place());
}

TEST_F(Following, LinesOfWhichTooLittleIsKnownAreWarnedOf) {
  add(2.5, 5.0, 28);
  add(0.0, 5.0, 2);  // 2 of 30 fit: the interval holds 0 and ends above 0.15
  const CloudFollowing f = result();
  EXPECT_TRUE(f.is_weak());
  EXPECT_FALSE(f.is_of_another_place());
}

TEST_F(Following, LevelGroundTellsNothing) {
  add(0.05, 0.3, 100);  // both surfaces are near enough to each other for a line to fit both
  const CloudFollowing f = result();
  EXPECT_EQ(f.n_pairs, 0U);
  EXPECT_FALSE(f.is_known());
  EXPECT_FALSE(f.is_of_another_place());
  EXPECT_FALSE(f.is_weak());
}

TEST_F(Following, FewPairsOrRoofsTellNothing) {
  add(2.5, 5.0, 29);
  EXPECT_FALSE(result().is_known());
  add(2.5, 5.0, 1);
  EXPECT_TRUE(result().is_of_another_place());
  for (LineEvaluation& line : judged_) line.planes[0].id = 1 + line.planes[0].id % 9;
  EXPECT_FALSE(result().is_known());
}

TEST_F(Following, AShiftThatIsKnownIsTakenAway) {
  add(0.5, 5.0, 40);
  EXPECT_TRUE(result().is_of_another_place());
  EXPECT_FALSE(result(0.5).is_weak());
}

TEST_F(Following, LinesThatHardlyFitAreWarnedOf) {
  add(0.0, 5.0, 10);
  add(2.5, 5.0, 30);
  const CloudFollowing f = result();
  EXPECT_EQ(f.difference(), 0.25);
  EXPECT_TRUE(f.is_weak());
  EXPECT_FALSE(f.is_of_another_place()) << "the interval of a quarter of 40 does not hold 0";
  Evaluation e;
  e.elsewhere = f;
  EXPECT_THAT(following_note(e), HasSubstr("25.0 % of the lines"));
  EXPECT_EQ(following_json(parse_following(following_json(f))), following_json(f));
}

TEST_F(Following, LinesThatWereNotJudgedAreLeftOut) {
  add(0.0, 5.0, 3);
  judged_[0].status = Status::kAmbiguous;
  elsewhere_[1].evaluation.status = Status::kNoLidar;
  EXPECT_EQ(result().n_pairs, 1U);
  EXPECT_THROW(cloud_following({}, judged_, elsewhere_, Eigen::Vector3d::Zero(), {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
