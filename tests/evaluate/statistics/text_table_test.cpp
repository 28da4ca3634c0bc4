// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/text_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace ridgeline::evaluate {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(PrintedTable, AlignsTextLeftAndFiguresRight) {
  PrintedTable table({"patch", "RMS:", "verdict"});
  table.add("1", "0.152", "passed");
  table.add("village", "12.000", "failed");
  EXPECT_EQ(table.text(Markup::kPlain),
            "patch       RMS  verdict\n"
            "1         0.152  passed\n"
            "village  12.000  failed\n");
  EXPECT_EQ(table.text(Markup::kMarkdown),
            "| patch | RMS | verdict |\n|---|--:|---|\n"
            "| 1 | 0.152 | passed |\n| village | 12.000 | failed |\n");
}

TEST(PrintedTable, EscapesForMarkdownAlone) {
  PrintedTable table({"|z| <= 1.96:", "gate"});
  table.add("3", "rms_m <= 0.3 | x");
  EXPECT_THAT(table.text(Markup::kPlain),
              AllOf(HasSubstr("|z| <= 1.96  gate\n"), HasSubstr("rms_m <= 0.3 | x\n")));
  EXPECT_THAT(table.text(Markup::kMarkdown), AllOf(HasSubstr("| \\|z\\| \\<= 1.96 | gate |"),
                                                   HasSubstr("rms_m \\<= 0.3 \\| x |")));
}

TEST(PrintedTable, AlignsWhateverTheWidthOfACharacterIs) {
  PrintedTable table({"patch", "n:"});
  table.add("H\u00e4user \u2264 2 \u03c3", 1);
  table.add("\u5c4b\u6839", 22);
  table.add("caf\xE9\n", 3);
  EXPECT_EQ(table.text(Markup::kPlain),
            "patch          n\n"
            "H\u00e4user \u2264 2 \u03c3   1\n"
            "\u5c4b\u6839          22\n"
            "caf\uFFFD           3\n");
}

TEST(PrintedTable, LeavesOutPlainColumnsWithoutAFigure) {
  PrintedTable table({"gate", "patch"}, {{"baseline:", "n:", "verdict"}});
  table.add("a", "-", "-", 3, "-");
  table.add("b", "-", "-", "-", "-");
  EXPECT_EQ(table.text(Markup::kPlain), "gate  patch  n\na     -      3\nb     -      -\n");
  EXPECT_THAT(table.text(Markup::kMarkdown),
              HasSubstr("| gate | patch | baseline | n | verdict |"));
}

TEST(PrintedTable, KeepsItsTitlesWithoutRows) {
  const PrintedTable table({"class"}, {{"n:", "RMS:"}});
  EXPECT_EQ(table.text(Markup::kPlain), "class  n  RMS\n");
}

/// The longest line of `text`.
std::size_t width_of(const std::string& text) {
  std::istringstream lines(text);
  std::size_t width = 0;
  for (std::string line; std::getline(lines, line);) width = std::max(width, line.size());
  return width;
}

TEST(PrintedTable, HasABlockForEachPartWhereItIsTooWideForATerminal) {
  const std::string long_title(60, 'x');
  PrintedTable table({"class"}, {{long_title + ":", "RMS:"}, {long_title, "p:"}});
  table.add("aligned", 1, 2, 3, 4);
  const std::string text = table.text(Markup::kPlain);
  EXPECT_LE(width_of(text), 100U);
  EXPECT_THAT(text, HasSubstr("RMS\naligned  "));
  EXPECT_THAT(text, HasSubstr("    2\n\nclass    " + long_title + "  p\naligned  3"));
  EXPECT_THAT(table.text(Markup::kMarkdown), HasSubstr("| aligned | 1 | 2 | 3 | 4 |\n"));

  PrintedTable narrow({"class"}, {{"RMS:"}, {"p:"}});
  narrow.add("aligned", 2, 4);
  EXPECT_EQ(narrow.text(Markup::kPlain), "class    RMS  p\naligned    2  4\n");
}

TEST(PrintedTable, WritesTheNoteOfARowBelowItOrInItsLastCell) {
  PrintedTable table({"gate", "n:", "verdict"});
  table.add("a", 3, "failed");
  table.add_note("0.5 is > 0.3");
  table.add("b", 4, "passed");
  EXPECT_EQ(table.text(Markup::kPlain),
            "gate  n  verdict\na     3  failed\n  0.5 is > 0.3\nb     4  passed\n");
  EXPECT_THAT(table.text(Markup::kMarkdown), HasSubstr("| a | 3 | failed: 0.5 is \\> 0.3 |\n"));
  EXPECT_THAT(table.text(Markup::kMarkdown), Not(HasSubstr("passed:")));
}

TEST(Paragraph, IsBrokenBetweenWordsForATerminalAlone) {
  const std::string word(48, 'x');
  const std::string text = word + " " + word + " ab " + word + " " + word;
  EXPECT_EQ(paragraph(text, Markup::kPlain),
            word + " " + word + " ab\n" + word + " " + word + "\n");
  EXPECT_EQ(paragraph(text, Markup::kMarkdown), text + "\n");
  const std::string long_word(150, 'x');
  EXPECT_EQ(paragraph("a " + long_word + " b", Markup::kPlain), "a\n" + long_word + "\nb\n");
  EXPECT_EQ(paragraph("short", Markup::kPlain), "short\n");
}

}  // namespace
}  // namespace ridgeline::evaluate
