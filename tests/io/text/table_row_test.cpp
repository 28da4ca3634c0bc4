// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/table_row.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(TableFields, HoldsSeparatorsWithinQuotes) {
  EXPECT_THAT(table_fields("'a b'  1\t2", ' '), ElementsAre("a b", "1", "2"));
  EXPECT_THAT(table_fields("\"a, b\", 1,,2", ','), ElementsAre("a, b", "1", "", "2"));
  EXPECT_THAT(table_fields("it's;2", ';'), ElementsAre("it's", "2"));
  EXPECT_THAT(table_fields("", ' '), IsEmpty());
}

TEST(SeparatorOf, PrefersSemicolonsAndTabs) {
  EXPECT_EQ(separator_of("a;b,c"), ';');
  EXPECT_EQ(separator_of("a\tb,c"), '\t');
  EXPECT_EQ(separator_of("a, b"), ',');
  EXPECT_EQ(separator_of("a b"), ' ');
}

TEST(SeparatorOf, IsABlankBetweenNumbersWithDecimalCommas) {
  EXPECT_EQ(separator_of("a 1,5 2,5 -3,25"), ' ');
  EXPECT_EQ(separator_of("a, 1, 2, 3"), ',');
  EXPECT_EQ(separator_of("a b,1.5,2.5,3.5"), ',');
}

TEST(TableNumber, TakesACommaWhereItCanOnlyBeADecimalMark) {
  EXPECT_EQ(table_number("1,5"), 1.5);
  EXPECT_EQ(table_number("1,500.0"), std::nullopt);
  EXPECT_EQ(table_number("1,500,000"), std::nullopt);
}

TEST(ColumnName, KnowsUnitsAndOtherNames) {
  EXPECT_EQ(column_name("X [m]"), "x");
  EXPECT_EQ(column_name("Easting"), "x");
  EXPECT_EQ(column_name("omega_deg"), "omega");
  EXPECT_EQ(column_name("Kappa (gon)"), "kappa");
  EXPECT_EQ(column_name("NOM"), "name");
  EXPECT_EQ(column_name("Bildname"), "name");
  EXPECT_EQ(column_name("H\xc3\x96HE"), "z");
  EXPECT_EQ(column_name("Flight"), "flight");
}

TEST(OpkColumns, NeedsPositionAndAngles) {
  EXPECT_THAT(opk_columns("# Label, X, Y, Z, Omega, Phi, Kappa"),
              ElementsAre("name", "x", "y", "z", "omega", "phi", "kappa"));
  EXPECT_THAT(opk_columns("Label X Y Z"), IsEmpty());
  EXPECT_THAT(opk_columns("x1,y1,z1,x2,y2,z2"), IsEmpty());
  EXPECT_THAT(opk_columns("x y z omega phi kappa x"), IsEmpty());
}

}  // namespace
}  // namespace ridgeline::io
