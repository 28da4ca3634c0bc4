// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/tolerance_table.h"

#include <gmock/gmock.h>

namespace ridgeline::evaluate {
namespace {

using ::testing::HasSubstr;

std::vector<ToleranceRow> rows() {
  ToleranceMeasures m;
  m.tolerance_m = 0.25;
  m.precision = 0.5;
  m.limap_r_m = 12.3456;
  return {{"1", "a,b|c", "planes", m}};
}

TEST(TolerancesToCsv, LeavesAFigureThatDoesNotExistEmpty) {
  EXPECT_THAT(tolerances_to_csv(rows()), HasSubstr("1,\"a,b|c\",planes,0.250,0.500,,,,12.346,\n"));
}

TEST(TolerancesToMarkdown, PrintsPercentAndADash) {
  EXPECT_THAT(tolerances_to_markdown(rows()),
              HasSubstr("| planes | 0.250 | 50.0 | - | - | - | 12.346 | - |"));
}

}  // namespace
}  // namespace ridgeline::evaluate
