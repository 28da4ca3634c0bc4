// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/utf8.h"

#include <gtest/gtest.h>

namespace ridgeline::io {
namespace {

TEST(IsUtf8, TakesWhatRfc3629Allows) {
  for (const char* const text : {"", "plain", "Stra\xC3\x9F", "\xE2\x82\xAC", "\xF0\x9F\x8F\xA0"}) {
    EXPECT_TRUE(is_utf8(text)) << text;
    EXPECT_EQ(as_utf8(text), text);
  }
  // cut short, a tail alone, overlong, a surrogate, beyond the last character
  for (const char* const bytes :
       {"\xC3", "\x80", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80"}) {
    EXPECT_FALSE(is_utf8(bytes));
    EXPECT_TRUE(is_utf8(as_utf8(bytes)));
  }
}

TEST(AsUtf8, TakesOtherBytesAsLatin1AndLeavesTheRest) {
  EXPECT_EQ(as_utf8("na\xEFve"), "na\xC3\xAFve");
  EXPECT_EQ(as_utf8("\xC3\x9F and \xDF"), "\xC3\x9F and \xC3\x9F");
}

}  // namespace
}  // namespace ridgeline::io
