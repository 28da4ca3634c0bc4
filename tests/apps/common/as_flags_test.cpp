// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/as_flags.h"

#include <gtest/gtest.h>

namespace ridgeline::apps {
namespace {

TEST(AsFlags, OptionsInBackticksBecomeFlags) {
  EXPECT_EQ(as_flags("declare the CRS with `assume_crs`"), "declare the CRS with --assume-crs");
  EXPECT_EQ(as_flags("give it as `cloud` or `lines`; no `patch`"),
            "give it as --cloud or --lines; no --patch");
}

TEST(AsFlags, WhatElseStandsInBackticksStays) {
  EXPECT_EQ(as_flags("ask `ridgeline info` for it, or give `bounds`"),
            "ask `ridgeline info` for it, or give --bounds");
  EXPECT_EQ(as_flags("a`b c.las: is empty"), "a`b c.las: is empty");
  EXPECT_EQ(as_flags("`` ` `x`"), "`` ` --x");
}

}  // namespace
}  // namespace ridgeline::apps
