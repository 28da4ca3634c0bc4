// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/view_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace ridgeline::simulate {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(ParseViewGroups, KeepsTheOrderOfTheList) {
  const std::vector<ViewGroup> groups = parse_view_groups("cross:2,strip:13,oblique:1");
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].kind, ViewGroupKind::kCross);
  EXPECT_EQ(groups[1].kind, ViewGroupKind::kStrip);
  EXPECT_EQ(groups[2].kind, ViewGroupKind::kOblique);
  EXPECT_EQ(groups[0].num_views, 2);
  EXPECT_EQ(groups[1].num_views, 13);
  EXPECT_EQ(groups[2].num_views, 1);
}

TEST(ParseViewGroups, RefusesWhatIsNoListWithTheGroupAndTheRule) {
  for (const char* text : {"", "strip", "strip:", "strip:x", "strip:2x", "strip:2.5", "strip: 2",
                           "Strip:2", "nadir:2", ":2", "strip:2,", "strip:99999999999"}) {
    EXPECT_THAT(
        [&] { (void)parse_view_groups(text); },
        ThrowsMessage<std::invalid_argument>(HasSubstr("must be strip:N, cross:N or oblique:N")))
        << text;
  }
  EXPECT_THAT([] { (void)parse_view_groups("strip:3,nadir:2"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("'nadir:2'")));
}

TEST(CheckViewGroups, RefusesNumbersThatCannotBeWithTheRule) {
  const auto refusal = [](const char* text, const char* rule) {
    EXPECT_THAT([&] { (void)parse_view_groups(text); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(rule)))
        << text;
  };
  refusal("strip:1", "views in all = 1, must be 2 to 30");
  refusal("strip:20,cross:11", "views in all = 31, must be 2 to 30");
  refusal("strip:2,cross:0", "cross:0, must have 1 to 30 views");
  refusal("strip:-2", "strip:-2, must have 1 to 30 views");
  refusal("strip:2,cross:2,strip:2", "strip is there more than once");
  EXPECT_NO_THROW(parse_view_groups("strip:20,cross:10"));
}

}  // namespace
}  // namespace ridgeline::simulate
