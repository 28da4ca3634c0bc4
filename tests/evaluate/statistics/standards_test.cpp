// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/standards.h"

#include "evaluate/tables/standards_table.h"
#include "tests/evaluate/statistics/lines.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

namespace ridgeline::evaluate {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kStandardExact = 1e-12;

/// Ridges 3 cm off across and -4 cm in height, whose planes are known to 1 cm, half of that by
/// independent errors.
Evaluation ridges(int n) {
  Evaluation e;
  e.patch = "1";
  e.method = "joint";
  e.options.sigma_sys_m = 0.02;
  for (int i = 0; i < n; ++i) {
    LineEvaluation line = evaluated_line(std::to_string(i), 0.05, i + 1);
    line.planes[0].sigma_m = 0.01;
    line.planes[0].sigma_random_m = 0.006;
    line.sigma_plane_m = 0.01;
    line.displacement = RidgeDisplacement{.horizontal_m = 0.03, .vertical_m = -0.04};
    line.displacement->covariance_m2 << 1e-4, 0.0, 0.0, 4e-4;
    e.lines.push_back(std::move(line));
  }
  return with_summaries(std::move(e));
}

const StandardsBlock& total(const std::vector<StandardsBlock>& blocks) { return blocks.back(); }

std::optional<double> measure(const StandardsBlock& block, int id) {
  for (const IsoMeasure& m : block.iso19157) {
    if (m.id == id) return m.value;
  }
  return std::nullopt;
}

TEST(StandardsBlock, AddsTheErrorOfTheReferenceToTheRmse) {
  const StandardsBlock block = total(standards_blocks(ridges(30)));
  EXPECT_NEAR(*block.asprs.rmse_horizontal_m, std::hypot(0.03, 0.01, 0.02), kStandardExact);
  EXPECT_NEAR(*block.asprs.rmse_vertical_m, std::hypot(0.04, 0.02, 0.02), kStandardExact);
  EXPECT_NEAR(*block.asprs.rmse_3d_m,
              std::hypot(*block.asprs.rmse_horizontal_m, *block.asprs.rmse_vertical_m),
              kStandardExact);
  EXPECT_TRUE(block.asprs.biased);  // all ridges are too low
  EXPECT_NEAR(*block.nssda.horizontal_m, 1.7308 * *block.asprs.rmse_horizontal_m, kStandardExact);
  EXPECT_NEAR(*block.nssda.vertical_m, 1.9600 * *block.asprs.rmse_vertical_m, kStandardExact);
}

TEST(StandardsBlock, SplitsTheUncertaintyOfALine) {
  const UncertaintyBudget budget = total(standards_blocks(ridges(30))).budget;
  EXPECT_NEAR(budget.laser_random_m, 0.006, kStandardExact);
  EXPECT_NEAR(budget.plane_fit_m, 0.008, kStandardExact);
  EXPECT_NEAR(budget.laser_systematic_m, 0.02, kStandardExact);
  EXPECT_NEAR(budget.expanded_m(), 2.0 * std::hypot(0.01, 0.02), kStandardExact);
  EXPECT_TRUE(budget.sampling_m);
}

TEST(StandardsBlock, AveragesTheTwoPlanesOfARidge) {
  Evaluation e = ridges(30);
  for (LineEvaluation& line : e.lines) {
    line.planes.push_back(line.planes[0]);
    line.planes[1].sigma_random_m = 0.008;
    line.sigma_plane_m = 0.013;
  }
  const UncertaintyBudget budget = total(standards_blocks(with_summaries(e))).budget;
  EXPECT_NEAR(budget.laser_random_m, 0.005,
              kStandardExact);  // the mean of 6 and 8 mm that err independently
  EXPECT_NEAR(budget.plane_fit_m, 0.012, kStandardExact);
}

TEST(StandardsBlock, SaysWhereThereAreTooFewCheckpoints) {
  EXPECT_FALSE(total(standards_blocks(ridges(30))).asprs.few_checkpoints);
  const StandardsBlock few = total(standards_blocks(ridges(29)));
  EXPECT_TRUE(few.asprs.few_checkpoints);
  EXPECT_TRUE(few.nssda.vertical_m);
  EXPECT_FALSE(total(standards_blocks(ridges(19))).nssda.vertical_m);
  EXPECT_FALSE(total(standards_blocks(ridges(0))).asprs.rmse_3d_m);
}

TEST(StandardsBlock, HasTheMeasuresOfIso19157) {
  Evaluation e = ridges(9);
  e.lines.push_back(evaluated_line("far", 2.0, 99));
  e = with_summaries(std::move(e));
  ToleranceMeasures against_lines;
  against_lines.tolerance_m = 0.25;
  against_lines.precision = 0.9;
  against_lines.completeness = 0.7;
  const StandardsBlock block = total(standards_blocks(e, against_lines));
  EXPECT_NEAR(*measure(block, 28), (9 * 0.05 + 2.0) / 10, kStandardExact);
  EXPECT_NEAR(*measure(block, 29), 0.05, kStandardExact);
  EXPECT_EQ(measure(block, 30), 1.0);
  EXPECT_NEAR(*measure(block, 31), 0.1, kStandardExact);
  EXPECT_NEAR(*measure(block, 39), std::sqrt((9 * 0.0025 + 4.0) / 10), kStandardExact);
  EXPECT_NEAR(*measure(block, 47), 0.03, kStandardExact);
  EXPECT_NEAR(*measure(block, 3), 0.1, kStandardExact);
  EXPECT_NEAR(*measure(block, 7), 0.3, kStandardExact);
}

TEST(QualityXml, IsWellFormedWithAResultForEachMeasureThatExists) {
  const std::vector<StandardsRow> rows{{"1 & 2", "<joint>", standards_blocks(ridges(3))}};
  std::istringstream stream(measures_to_xml(rows));
  boost::property_tree::ptree tree;
  ASSERT_NO_THROW(boost::property_tree::read_xml(stream, tree));
  const auto& quality = tree.get_child("gmd:DQ_DataQuality");
  EXPECT_EQ(quality.count("gmd:report"), 11U);
  const std::string value = quality.get<std::string>(
      "gmd:report.gmd:DQ_AbsoluteExternalPositionalAccuracy.gmd:result.gmd:DQ_QuantitativeResult."
      "gmd:value.gco:Record");
  EXPECT_EQ(value, "0.0500");
  const std::vector<StandardsRow> none{{"1", "joint", standards_blocks(ridges(0))}};
  EXPECT_THAT(measures_to_xml(none), Not(HasSubstr("measure 39")));
}

TEST(StandardsTable, ClaimsNoConformity) {
  const std::string text = standards_to_markdown(standards_blocks(ridges(3)));
  EXPECT_THAT(text, HasSubstr("no conformity is claimed"));
  EXPECT_THAT(text, HasSubstr("| total | 3 |"));
  EXPECT_THAT(text, HasSubstr("fewer than 30, bias"));
}

}  // namespace
}  // namespace ridgeline::evaluate
