// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/top_keys.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(TopKeys, OfJsonAreThoseOfTheOutermostObject) {
  const TopKeys keys =
      top_keys(R"( {"type": "Feature", "a": {"b": [1, {"c": 2}]}, "d, \"e": "f:g"})");
  EXPECT_THAT(keys.names, ElementsAre("type", "a", "d, \"e"));
  EXPECT_EQ(keys.type, "Feature");
}

TEST(TopKeys, OfACutTextGoAsFarAsItDoes) {
  EXPECT_THAT(top_keys(R"({"a": [1, 2, {"b": 3}], "type": "Top)").names, ElementsAre("a", "type"));
}

TEST(TopKeys, OfAListAreNone) { EXPECT_THAT(top_keys(R"([{"a": 1}])").names, IsEmpty()); }

TEST(TopKeys, OfYamlStandAtTheBeginningOfARow) {
  const TopKeys keys = top_keys(
      "# a: comment\r\n---\r\nid: \"1\"\r\n\"images\":\r\n  - id: left\r\n- no: "
      "key\r\nurl:x\r\ntype: a\r\n");
  EXPECT_THAT(keys.names, ElementsAre("id", "images", "type"));
  EXPECT_EQ(keys.type, "a");
}

TEST(TopKeys, OfYamlInBracesNeedNoQuotes) {
  EXPECT_THAT(top_keys("{gates: [{metric: rms_m, max: 1}], n_min: 3}").names,
              ElementsAre("gates", "n_min"));
}

TEST(TopKeys, OfProseWithExamplesAreNone) {
  EXPECT_THAT(
      top_keys("# A tool\nIt reads images.\nWrite this:\n```\nimages: []\n```\nThen run it.\n")
          .names,
      IsEmpty());
}

}  // namespace
}  // namespace ridgeline::io
