// SPDX-License-Identifier: BSD-3-Clause
// What the values of judged lines give away.
#include "evaluate/files/value_warnings.h"

#include "io/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace ridgeline::results {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Seven edges of a house, with every coordinate written in steps of `plan_step_m`, and judged at
/// `distance_m`.
struct Judged {
  io::LineSet set;
  evaluate::Evaluation evaluation;

  explicit Judged(double plan_step_m, double distance_m) {
    set.path = "lines.obj";
    for (int i = 0; i < 7; ++i) {
      io::Line line;
      const auto coarse = [&](double v) { return std::round(v / plan_step_m) * plan_step_m; };
      const double x = 513000.0 + 3.917 * i, y = 5403000.0 + 2.373 * i;
      line.segment_in_world = {{coarse(x), coarse(y), 255.103 + 0.211 * i},
                               {coarse(x + 7.123), coarse(y + 1.777), 256.377 + 0.187 * i}};
      set.lines.push_back(line);
      evaluate::LineEvaluation judged;
      judged.id = std::to_string(i);
      judged.status = evaluate::Status::kEvaluated;
      judged.length_m = 7.0;
      judged.mean_distance_m = distance_m;
      evaluation.lines.push_back(judged);
    }
  }

  [[nodiscard]] std::vector<std::string> warnings(bool strict = false) const {
    std::vector<std::string> warnings;
    add_value_warnings(set, evaluation, strict, warnings);
    return warnings;
  }
};

TEST(ValueWarnings, NameTheAxesAndStepsOfRoundedLines) {
  const Judged judged(10.0, 4.8);
  EXPECT_THAT(judged.warnings(),
              ElementsAre(AllOf(HasSubstr("lines.obj: "), HasSubstr("x in steps of 10 m"),
                                HasSubstr("y in steps of 10 m"))));
  EXPECT_THROW(judged.warnings(true), io::IoError);
}

TEST(ValueWarnings, LeaveFineLinesAndAHouseOnWholeMetresAlone) {
  EXPECT_THAT(Judged(0.001, 0.04).warnings(true), IsEmpty());
  EXPECT_THAT(Judged(0.01, 0.04).warnings(true), IsEmpty());
  EXPECT_THAT(Judged(1.0, 0.02).warnings(true), IsEmpty());
  EXPECT_THAT(Judged(1.0, 0.4).warnings(), ElementsAre(HasSubstr("in steps of 1 m")));
}

TEST(ValueWarnings, NameFloat32HoweverWellTheLinesFit) {
  Judged judged(0.001, 0.03);
  for (io::Line& line : judged.set.lines) {
    for (Eigen::Vector3d* x : {&line.segment_in_world.start, &line.segment_in_world.end}) {
      *x = x->cast<float>().cast<double>();
    }
  }
  EXPECT_THAT(judged.warnings(),
              ElementsAre(HasSubstr("y in steps of 0.5 m, x in steps of 0.0312 m")));
}

TEST(ValueWarnings, NameLinesThatDecideTheRms) {
  Judged judged(0.001, 0.04);
  judged.evaluation.lines[2].mean_distance_m = 40.0;
  EXPECT_THAT(judged.warnings(),
              ElementsAre(AllOf(HasSubstr("1 of 7 lines are more than 20 m from their planes"),
                                HasSubstr("0.040 m without them: 2;"))));
}

TEST(ValueWarnings, LeaveFarErrorsOfAToolToTheStatistics) {
  Judged judged(0.001, 0.04);
  judged.evaluation.lines[2].mean_distance_m = 70.0;
  evaluate::JudgingPlane plane;
  plane.distance.start = -169.6;
  plane.distance.end = 57.1;
  judged.evaluation.lines[2].planes = {plane};
  EXPECT_THAT(judged.warnings(), IsEmpty());
}

TEST(ValueWarnings, NameLinesOfNoHeight) {
  Judged judged(0.001, 0.04);
  for (const std::size_t i : {1U, 4U}) {
    judged.evaluation.lines[i].status = evaluate::Status::kOutOfRange;
  }
  EXPECT_THAT(judged.warnings(),
              ElementsAre(AllOf(HasSubstr("2 of 7 lines"), HasSubstr("(out_of_range): 1, 4;"))));
  judged.evaluation.lines[4].length_m = 0.0;  // it has no place on Earth, as its reason says
  EXPECT_THAT(judged.warnings(), ElementsAre(HasSubstr("1 of 7 lines")));
}

}  // namespace
}  // namespace ridgeline::results
