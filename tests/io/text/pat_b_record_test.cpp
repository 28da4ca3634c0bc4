// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/pat_b_record.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;

TEST(FortranNumber, MayHaveAnExponentWithD) {
  EXPECT_EQ(fortran_number("0.5D+02"), 50.0);
  EXPECT_EQ(fortran_number("-1d-1"), -0.1);
  EXPECT_EQ(fortran_number("2.5"), 2.5);
  EXPECT_EQ(fortran_number("Dot"), std::nullopt);
}

TEST(PatBWords, AreThoseBeforeTheFlags) {
  EXPECT_THAT(pat_b_words("7 1.0 2.0 3.0 1 0", 4), ElementsAre("7", "1.0", "2.0", "3.0"));
  EXPECT_THAT(pat_b_words("7 153.0 1.0 2.0 3.0 1", 4),
              ElementsAre("7", "153.0", "1.0", "2.0", "3.0"));
  EXPECT_THAT(pat_b_words("7 1 2 3", 4), ElementsAre("7", "1", "2", "3"));
  EXPECT_THAT(pat_b_words("7 153 512680 5402800 1050", 4),
              ElementsAre("7", "153", "512680", "5402800", "1050"));
}

}  // namespace
}  // namespace ridgeline::io
