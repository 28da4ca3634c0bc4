// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/block/block_lines.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace ridgeline::apps {
namespace {

using ::testing::ElementsAre;
using ::testing::IsSupersetOf;

/// Lines whose distances grow from 0, each third one not judged.
std::vector<ShownLine> growing(std::size_t n) {
  std::vector<ShownLine> lines(n);
  for (std::size_t i = 0; i < n; ++i)
    if (i % 3 != 0) lines[i].mean_m = 0.001F * static_cast<float>(i);
  return lines;
}

TEST(WorstLines, AreTheJudgedOnesFarthestOff) {
  EXPECT_THAT(worst_lines(growing(10), 3), ElementsAre(8, 7, 5));
  EXPECT_THAT(worst_lines(growing(3), 9), ElementsAre(2, 1));
  EXPECT_TRUE(worst_lines({}, 9).empty());
}

TEST(WorstLines, OfEqualDistanceStandInTheirOrder) {
  std::vector<ShownLine> lines(5);
  for (ShownLine& line : lines) line.mean_m = 1.0F;
  EXPECT_THAT(worst_lines(lines, 3), ElementsAre(0, 1, 2));
}

TEST(ThinnedLines, KeepAllThatHaveRoom) {
  EXPECT_THAT(thinned_lines(growing(4), 4), ElementsAre(0, 1, 2, 3));
}

TEST(ThinnedLines, KeepTheWorstAndSomeFromEverywhere) {
  std::vector<ShownLine> lines = growing(10000);
  std::rotate(lines.begin(), lines.begin() + 5001, lines.end());
  const std::vector<std::size_t> shown = thinned_lines(lines, 1000);
  EXPECT_EQ(shown.size(), 1000U);
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  EXPECT_EQ(std::adjacent_find(shown.begin(), shown.end()), shown.end());
  EXPECT_THAT(shown, IsSupersetOf(worst_lines(lines, 100)));
  for (std::size_t tenth = 0; tenth < 10; ++tenth) {
    const auto n = std::ranges::count_if(shown, [&](std::size_t i) { return i / 1000 == tenth; });
    EXPECT_GE(n, 80) << tenth;
  }
}

TEST(Words, AreCountedOnce) {
  Words words;
  EXPECT_EQ(words.number_of("a"), 0);
  EXPECT_EQ(words.number_of("b"), 1);
  EXPECT_EQ(words.number_of("a"), 0);
  EXPECT_EQ(words[1], "b");
}

}  // namespace
}  // namespace ridgeline::apps
