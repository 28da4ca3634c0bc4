// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/display_width.h"

#include <gtest/gtest.h>

#include <string>

namespace ridgeline::evaluate {
namespace {

TEST(DisplayWidth, IsThatOfATerminal) {
  EXPECT_EQ(display_width(""), 0U);
  EXPECT_EQ(display_width("RMS <= 0.3"), 10U);
  EXPECT_EQ(display_width("\u2264 3 \u03c3, \u00b1 z\u00b2"), 11U)
      << "less or equal, sigma, plus-minus, square";
  EXPECT_EQ(display_width("H\u00e4user"), 6U);
  EXPECT_EQ(display_width("Ha\u0308user"), 6U) << "the dots as a combining mark";
  EXPECT_EQ(display_width("\u5c4b\u6839"), 4U) << "wide";
  EXPECT_EQ(display_width("\U0001F3E0"), 2U) << "wide, of four bytes";
}

TEST(DisplayWidth, CountsAColumnForAByteThatIsNoUtf8) {
  EXPECT_EQ(display_width("caf\xE9"), 4U);
  EXPECT_EQ(display_width("\x80\x80|"), 3U);
  EXPECT_EQ(display_width("\xE2\x89"), 2U) << "cut short";
  EXPECT_EQ(display_width("\xE2\x89|"), 3U);
}

TEST(Printable, KeepsTextAndTakesOutWhatWouldMoveTheCursor) {
  EXPECT_EQ(printable("H\u00e4user \u2264 \U0001F3E0"), "H\u00e4user \u2264 \U0001F3E0");
  EXPECT_EQ(printable("a\nb\tc\x1B[31m\x7F"), "a b c [31m ");
  EXPECT_EQ(printable("\u009B31m"), " 31m") << "the control sequence of one character";
  EXPECT_EQ(printable("caf\xE9!"), "caf\uFFFD!");
  EXPECT_EQ(printable("\x80|"), "\uFFFD|");
}

TEST(Printable, HasTheWidthThatWasCounted) {
  for (const std::string text : {"caf\xE9", "\xE2\x89", "a\nb", "\u2264\x1B"}) {
    EXPECT_EQ(display_width(printable(text)), display_width(text)) << text;
  }
}

}  // namespace
}  // namespace ridgeline::evaluate
