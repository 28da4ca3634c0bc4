// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/interruption.h"

#include <gtest/gtest.h>

namespace ridgeline {
namespace {

TEST(Interruption, StandsFromItsRequestUntilItIsCleared) {
  EXPECT_NO_THROW(Interruption::check());
  Interruption::request();
  EXPECT_TRUE(Interruption::is_standing());
  EXPECT_THROW(Interruption::check(), Interrupted);
  Interruption::clear();
  EXPECT_FALSE(Interruption::is_standing());
  EXPECT_NO_THROW(Interruption::check());
}

}  // namespace
}  // namespace ridgeline
