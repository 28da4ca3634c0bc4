// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/matches_file.h"

#include "io/error.h"
#include "io/files/text_file.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using ::testing::HasSubstr;

constexpr double kWritten_px = 5e-4;  // half of the last digit

template <typename Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const IoError& error) {
    return error.what();
  }
  return "no error";
}

TEST(WriteMatches, GivesTheColumnsOfTheContract) {
  const TempFolder folder;
  const std::vector<Correspondence> matches = {{0, 7, 0.98765, 3.25, "pairwise"},
                                               {4, 2, 0.5, 0.0, "pairwise+chio"}};
  write_matches(folder.file("m.csv"), matches);
  EXPECT_EQ(read_text_file(folder.file("m.csv")),
            "left_id,right_id,score,votes,matcher\n"
            "0,7,0.9877,3.250,pairwise\n"
            "4,2,0.5000,0.000,pairwise+chio\n");
}

TEST(ReadMatches, ReadsWhatWasWritten) {
  const TempFolder folder;
  write_matches(folder.file("m.csv"), std::vector<Correspondence>{{3, 5, 0.75, 1.5, "pairwise"}});
  const std::vector<Correspondence> rows = read_matches(folder.file("m.csv"));
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].base, 3);
  EXPECT_EQ(rows[0].other, 5);
  EXPECT_EQ(rows[0].score, 0.75);
  EXPECT_EQ(rows[0].votes, 1.5);
  EXPECT_EQ(rows[0].matcher, "pairwise");
}

TEST(ReadMatches, TakesOtherToolsColumnsInAnyOrder) {
  const TempFolder folder;
  (void)folder.write("m.csv", "right_id, note ,left_id\r\n8,x,1\r\n9,\"a, \"\"b\"\"\",2\r\n");
  const std::vector<Correspondence> rows = read_matches(folder.file("m.csv"));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].base, 1);
  EXPECT_EQ(rows[0].other, 8);
  EXPECT_EQ(rows[1].base, 2);
}

TEST(ReadMatches, NamesRowAndRuleOfWhatIsWrong) {
  const TempFolder folder;
  const auto message = [&](const std::string& content) {
    (void)folder.write("m.csv", content);
    return message_of([&] { (void)read_matches(folder.file("m.csv")); });
  };
  EXPECT_THAT(message(""), HasSubstr("empty"));
  EXPECT_THAT(message("left_id,score\n1,2\n"), HasSubstr("no column right_id"));
  EXPECT_THAT(message("left_id,right_id\n1\n"), HasSubstr("m.csv:2: 1 fields, the header has 2"));
  EXPECT_THAT(message("left_id,right_id\n1,2\n-1,2\n"), HasSubstr("m.csv:3: left_id = '-1'"));
  EXPECT_THAT(message("left_id,right_id\n1,2.5\n"), HasSubstr("right_id = '2.5'"));
  EXPECT_THAT(message("left_id,right_id,score\n1,2,nan\n"), HasSubstr("score = 'nan'"));
  EXPECT_THAT(message("left_id,right_id\n1,2\n1,2\n"),
              HasSubstr("m.csv:3: the match 1, 2 appears twice"));
}

TEST(ReadReferenceMatches, ReadsTheEdgesThatWereWritten) {
  const TempFolder folder;
  const std::vector<ReferenceEdge> edges = {
      {{{1.5, 2.0}, {3.25, 4.0}}, {{-0.125, 6.0}, {7.0, 8.875}}, false, "e1", "eave"}};
  write_reference_edges(folder.file("r.csv"), edges);
  const ReferenceMatches read = read_reference_matches(folder.file("r.csv"));
  ASSERT_TRUE(std::holds_alternative<std::vector<ReferenceEdge>>(read));
  const ReferenceEdge edge = std::get<std::vector<ReferenceEdge>>(read).at(0);
  EXPECT_EQ(edge.id, "e1");
  EXPECT_EQ(edge.kind, "eave");
  EXPECT_LT((edge.base.end - edges[0].base.end).norm(), kWritten_px);
  EXPECT_LT((edge.other.start - edges[0].other.start).norm(), kWritten_px);
}

TEST(ReadReferenceMatches, ReadsPairsOfIds) {
  const TempFolder folder;
  (void)folder.write("r.csv", "left_id,right_id\n5,6\n");
  const ReferenceMatches read = read_reference_matches(folder.file("r.csv"));
  ASSERT_TRUE(std::holds_alternative<std::vector<Correspondence>>(read));
  EXPECT_EQ(std::get<std::vector<Correspondence>>(read).at(0).other, 6);
}

TEST(ReadReferenceMatches, ReadsTheVerdictsOfAReview) {
  const TempFolder folder;
  const std::string header =
      "id,verdict,left_x1_px,left_y1_px,left_x2_px,left_y2_px,"
      "right_x1_px,right_y1_px,right_x2_px,right_y2_px\n";
  const std::string ends = ",1,2,3,4,5,6,7,8\n";
  (void)folder.write("r.csv",
                     header + "0-0,correct" + ends + "1-1,false" + ends + "2-2,missed" + ends);
  const auto edges =
      std::get<std::vector<ReferenceEdge>>(read_reference_matches(folder.file("r.csv")));
  ASSERT_EQ(edges.size(), 3U);
  EXPECT_FALSE(edges[0].is_wrong_pair);
  EXPECT_TRUE(edges[1].is_wrong_pair);
  EXPECT_FALSE(edges[2].is_wrong_pair);
  (void)folder.write("r.csv", header + "0-0,maybe" + ends);
  EXPECT_THAT(message_of([&] { (void)read_reference_matches(folder.file("r.csv")); }),
              HasSubstr("r.csv:2: verdict 'maybe'; must be correct, missed or false"));
}

}  // namespace
}  // namespace ridgeline::io
