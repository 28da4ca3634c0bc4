// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/accuracy_table.h"
#include "evaluate/tables/evaluation_json.h"
#include "evaluate/tables/format.h"
#include "evaluate/tables/table1.h"
#include "evaluate/tables/table2.h"
#include "evaluate/tables/terminal_table.h"
#include "evaluate/tables/text_table.h"
#include "tests/evaluate/statistics/lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Evaluation small_evaluation(const std::string& method = "direct") {
  Evaluation evaluation;
  evaluation.patch = "1";
  evaluation.method = method;
  evaluation.origin_m = {500'000.0, 5'400'000.0, 250.0};
  evaluation.lines = {evaluated_line("a", 0.3, 1), evaluated_line("b", -0.4, 2),
                      evaluated_line("c", 1.2, 3, "aligned"),
                      excluded_line("d", Status::kNoPlane, "aligned")};
  evaluation.lines[0].sigma_line_m = 0.2;
  evaluation.lines[0].epipolar_angle_deg = 33.0;
  evaluation.lines[1].flags = {"merged", "another_flag"};
  evaluation.lines[2].building = "b 7";
  evaluation.lines[2].surface = JudgingSurface::kLower;
  evaluation.lines[2].surface_other = JudgingSurface::kObject;
  evaluation.lines[2].surface_probability = 0.97;
  evaluation.lines[2].decided_by = DecidedBy::kImages;
  return with_summaries(std::move(evaluation));
}

Evaluation unclassed_evaluation() {
  Evaluation evaluation;
  evaluation.patch = "2";
  evaluation.method = "other_tool";
  evaluation.lines = {excluded_line("d", Status::kNoLidar, "all")};
  return with_summaries(std::move(evaluation));
}

TEST(Fixed, NeverPrintsNegativeZeroNorInventsANumber) {
  EXPECT_EQ(fixed(-0.0001, 3), "0.000");
  EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed(std::nullopt, 3), "-");
  EXPECT_EQ(fixed(std::numeric_limits<double>::infinity(), 3), "-");
  EXPECT_EQ(percent(0.97115), "97.1");
}

TEST(Escapes, KeepEachFormatWellFormed) {
  EXPECT_EQ(escape_csv("a,\"b\""), "\"a,\"\"b\"\"\"");
  EXPECT_EQ(escape_csv("plain"), "plain");
  EXPECT_EQ(escape_markdown("a|b\nc_d"), "a\\|b c_d");
  EXPECT_EQ(escape_latex("50%_a\\{~^"),
            "50\\%\\_a\\textbackslash{}\\{\\textasciitilde{}\\textasciicircum{}");
  EXPECT_EQ(escape_xml("<a b=\"&\">\x01\n"), "&lt;a b=&quot;&amp;&quot;&gt;\xEF\xBF\xBD\n");
}

TEST(Table2Markdown, HasThePublishedFormWithNInEveryCell) {
  const std::vector evaluations{small_evaluation("direct"), small_evaluation("joint")};
  const std::string text = to_markdown(make_table2(evaluations));
  EXPECT_THAT(text, HasSubstr("| patch | direct not_aligned | direct aligned | direct total | "
                              "joint not_aligned | joint aligned | joint total |\n"));
  EXPECT_THAT(text, HasSubstr("| 1 | 0.354 (2/2) | 1.200 (1/2) | 0.751 (3/4) | 0.354 (2/2) |"));
  EXPECT_THAT(text, HasSubstr("no_plane 1"));
  EXPECT_THAT(text, HasSubstr("too few clusters"));
  EXPECT_THAT(text, HasSubstr(std::string(kFixedSentence)));
}

TEST(Table2Markdown, ShowsADashWhereAMethodOrFigureIsMissing) {
  const std::vector evaluations{small_evaluation(), unclassed_evaluation()};
  const std::string text = to_markdown(make_table2(evaluations));
  EXPECT_THAT(text, HasSubstr("| 2 | - | - | - | - | - | - (0/1) |\n"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(Table2Markdown, HasOneColumnPerMethodWhereNothingIsClassed) {
  const std::string text = to_markdown(make_table2(std::vector{unclassed_evaluation()}));
  EXPECT_THAT(text, HasSubstr("| patch | other_tool total |\n|---|--:|\n| 2 | - (0/1) |\n"));
}

TEST(Table2Markdown, OfResultsWithoutLinesHasClassesUnlessOthersHaveNone) {
  Evaluation empty;
  empty.patch = "3";
  empty.method = "none";
  empty = with_summaries(std::move(empty));
  EXPECT_THAT(to_markdown(make_table2(std::vector{empty})),
              HasSubstr("| 3 | - (0/0) | - (0/0) | - (0/0) |\n"));
  EXPECT_THAT(to_markdown(make_table2(std::vector{unclassed_evaluation(), empty})),
              HasSubstr("| patch | other_tool total | none total |\n"));
}

TEST(Table2Footnote, SaysInEveryTextWhyDirectAndJointDiffer) {
  const std::vector evaluations{small_evaluation("direct"), small_evaluation("joint")};
  const Table2 table = make_table2(evaluations, true);
  const std::string note(footnote(table));
  EXPECT_THAT(note, HasSubstr("faces_beside"));
  EXPECT_THAT(note, Not(HasSubstr("\n")));
  EXPECT_THAT(to_markdown(table), HasSubstr(" |\n\n" + note + "\n\n"));
  EXPECT_THAT(to_latex(table), HasSubstr("\n% " + note + "\n\\begin{tabular}"));
  EXPECT_THAT(to_terminal(table), EndsWith("\n" + paragraph(note, Markup::kPlain)));
  EXPECT_EQ(nlohmann::json::parse(to_json(table))["footnote"], note);
}

TEST(Table2Footnote, IsMissingWhereBothAreEqualOrOneIsMissing) {
  const std::vector both{small_evaluation("direct"), small_evaluation("joint")};
  const std::vector joint{small_evaluation("joint"), small_evaluation("network")};
  for (const Table2& table : {make_table2(both), make_table2(joint, true)}) {
    EXPECT_EQ(footnote(table), "");
    EXPECT_THAT(to_markdown(table), AllOf(Not(HasSubstr("faces")), Not(HasSubstr("\n\n\n"))));
    EXPECT_THAT(to_latex(table), AllOf(Not(HasSubstr("faces")), HasSubstr(".\n\\begin")));
    EXPECT_THAT(to_terminal(table), Not(HasSubstr("faces")));
    EXPECT_TRUE(nlohmann::json::parse(to_json(table))["footnote"].is_null());
  }
}

TEST(Table2Csv, HasTheContractsColumnsAndEmptyFieldsForMissingFigures) {
  const std::vector evaluations{small_evaluation(), unclassed_evaluation()};
  const std::string text = to_csv(make_table2(evaluations));
  EXPECT_THAT(text, StartsWith("patch,method,class,n_lines,n_evaluated,rms_m,ci95_low_m,"
                               "ci95_high_m,median_m,nmad_m,q95_m,"));
  EXPECT_THAT(text, HasSubstr("\n1,direct,aligned,2,1,1.200,,,1.200,0.000,1.200,1,1.200,0,\n"));
  EXPECT_THAT(text, HasSubstr("\n2,other_tool,total,1,0,,,,,,,0,,0,\n"));
}

TEST(Table2Renderings, AgreeToThePrintedDigit) {
  const Table2 table = make_table2(std::vector{small_evaluation()});
  const auto json = nlohmann::json::parse(to_json(table));
  ASSERT_EQ(json["rows"].size(), 3U);
  for (const auto& row : json["rows"]) {
    const std::string rms = metres(row["rms_m"].get<double>());
    const std::string n = row["n_lines"].dump() + "," + row["n_evaluated"].dump();
    const std::string line_class = row["class"];
    EXPECT_THAT(to_csv(table), HasSubstr("1,direct," + line_class + "," + n + "," + rms + ","));
    EXPECT_THAT(to_markdown(table), HasSubstr(rms));
    EXPECT_THAT(to_latex(table), HasSubstr(rms));
  }
}

TEST(Table2Latex, IsATabularWithEscapedNames) {
  const std::string text =
      to_latex(make_table2(std::vector{small_evaluation(), unclassed_evaluation()}));
  EXPECT_THAT(text, HasSubstr("\\begin{tabular}{lrrrrrr}"));
  EXPECT_THAT(text, HasSubstr("\\multicolumn{3}{c}{other\\_tool}"));
  EXPECT_THAT(text, HasSubstr(" & not\\_aligned & aligned & total"));
  EXPECT_THAT(text, HasSubstr("1 & 0.354 (2/2) & 1.200 (1/2) & 0.751 (3/4) & - & - & - \\\\\n"));
}

TEST(Table1, IsReadBackAsItWasWritten) {
  const Table1 table{{{"1", "pairwise", {101, 3, 2}, 7}, {"b", "chio", {0, 0, 9}, 0}}};
  EXPECT_EQ(to_json(parse_table1(to_json(table))), to_json(table));
  for (const char* text : {"", "{}", R"({"rows": 3})", R"({"rows": [{"patch": "1"}]})",
                           R"({"rows": [{"patch": "1", "matcher": "m", "correct": -1,
                               "false": 0, "missed": 0, "unjudged": 0}]})"}) {
    EXPECT_THROW((void)parse_table1(text), std::invalid_argument) << text;
  }
}

TEST(Table1, GivesThePublishedPercentages) {
  const Table1 table{{{"1", "pairwise", {101, 3, 2}},
                      {"2", "pairwise", {94, 6, 5}},
                      {"3", "pairwise", {111, 5, 14}},
                      {"4", "chio", {0, 0, 0}}}};
  EXPECT_THAT(to_csv(table), HasSubstr("1,pairwise,101,3,2,0.971,0.981,0.953\n"
                                       "2,pairwise,94,6,5,0.940,0.949,0.895\n"
                                       "3,pairwise,111,5,14,0.957,0.888,0.854\n"
                                       "4,chio,0,0,0,,,\n"));
  EXPECT_THAT(to_markdown(table), HasSubstr("| 1 | pairwise | 101 | 3 | 2 | 97.1 ("));
  EXPECT_THAT(to_markdown(table), HasSubstr("| 4 | chio | 0 | 0 | 0 | - | - | - |"));
  const auto json = nlohmann::json::parse(to_json(table));
  EXPECT_DOUBLE_EQ(json["rows"][0]["correctness"], 101.0 / 104.0);
  EXPECT_TRUE(json["rows"][3]["quality"].is_null());
}

TEST(AccuracyMarkdown, LabelsTheThreeNumbersUnderTheFixedSentence) {
  Evaluation evaluation = small_evaluation();
  evaluation.options.sigma_sys_m = 0.5;
  const std::string text = to_markdown(accuracy_statements(evaluation));
  EXPECT_THAT(text, HasSubstr("| not_aligned | 2 | 0.354 | 0.612 | below reference noise | 0.500 |"
                              " 1 | 0.300 | n_below_30, few_clusters, below_reference_noise |"));
  EXPECT_THAT(text, HasSubstr("| total | 3 | 0.751 | 0.902 | 0.560 | 0.500 |"));
  EXPECT_LT(text.find(kFixedSentence), text.find("ASPRS Edition 2: RMSE 0.902 m"));
  EXPECT_THAT(text, HasSubstr("fewer than the 30"));
  EXPECT_THAT(text, HasSubstr("1.768 m at 95 %"));
}

TEST(StrataMarkdown, HasARowPerStratum) {
  const std::string text = to_markdown(stratify(small_evaluation()));
  EXPECT_THAT(
      text,
      HasSubstr("| 20-45 | 1 / 1 | 0.300 | - | 0.000 | 0.300 | 2.25 | 2.25 | 100.0 | 0.0 |\n"));
  EXPECT_THAT(text, HasSubstr("| unknown | 2 / 3 |"));
  EXPECT_THAT(text, HasSubstr("| 0-2 | 0 / 0 | - | - | - | - | - | - | - | - |\n"));
}

TEST(EvaluationJson, SurvivesARoundTrip) {
  const Evaluation evaluation = small_evaluation();
  const std::string text = to_json(evaluation);
  const Evaluation read = parse_evaluation(text);
  EXPECT_EQ(to_json(read), text);
  ASSERT_EQ(read.lines.size(), 4U);
  EXPECT_EQ(read.lines[1].flags, evaluation.lines[1].flags);
  EXPECT_EQ(read.lines[2].building, "b 7");
  EXPECT_EQ(read.lines[2].surface, JudgingSurface::kLower);
  EXPECT_EQ(read.lines[2].surface_other, JudgingSurface::kObject);
  EXPECT_EQ(read.lines[2].surface_probability, 0.97);
  EXPECT_EQ(read.lines[2].decided_by, DecidedBy::kImages);
  EXPECT_FALSE(read.lines[0].surface || read.lines[0].surface_probability);
  EXPECT_EQ(read.lines[3].status, Status::kNoPlane);
  EXPECT_FALSE(read.lines[3].mean_distance_m || read.lines[3].sigma_plane_m);
  EXPECT_EQ(*read.classes.back().rms_m, *evaluation.classes.back().rms_m);
  EXPECT_NEAR(read.lines[0].planes[0].plane.offset(), 0.0, 1e-9);
}

TEST(EvaluationJson, GivesNoDistanceToALineThatIsNotEvaluated) {
  const auto json = nlohmann::json::parse(to_json(small_evaluation()));
  EXPECT_TRUE(json["lines"][3]["mean_distance_m"].is_null());
  EXPECT_TRUE(json["lines"][3]["kind"].is_null());
  EXPECT_EQ(json["summary"]["aligned"]["n_excluded"]["no_plane"], 1);
  EXPECT_TRUE(json["summary"]["aligned"]["ci95_m"].is_null());
  EXPECT_EQ(json["lines"][0]["planes"][0]["d"], -250.0) << "planes are in the world frame";
}

TEST(EvaluationJson, SurvivesNonFiniteNumbersAndForeignBytes) {
  Evaluation evaluation = small_evaluation();
  evaluation.lines[3].id = "caf\xE9";
  evaluation.lines[3].length_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(parse_evaluation(to_json(with_summaries(evaluation))));
}

TEST(ParseEvaluation, NamesWhatIsWrong) {
  const std::string good = to_json(small_evaluation());
  const auto message_after = [&](const std::string& from, const std::string& to) -> std::string {
    std::string bad = good;
    bad.replace(bad.find(from), from.size(), to);
    try {
      parse_evaluation(bad);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message_after("{", ""), StartsWith("not JSON"));
  EXPECT_THAT(message_after("\"seed\": 1", "\"seed\": 1e400"), StartsWith("not JSON"));
  EXPECT_THAT(message_after("\"patch\"", "\"parch\""), HasSubstr("no key patch"));
  EXPECT_THAT(message_after("\"status\": \"no_plane\"", "\"status\": \"odd\""),
              HasSubstr("line 3: status: odd"));
  EXPECT_THAT(message_after("\"seed\": 1", "\"seed\": -1"), HasSubstr("seed: -1; must be"));
  EXPECT_THAT(message_after("\"kind\": \"step\"", "\"kind\": \"stop\""), HasSubstr("kind: stop"));
  EXPECT_THAT(message_after("\"surface\": \"lower\"", "\"surface\": \"lowest\""),
              HasSubstr("line 2: surface: lowest; must be"));
  EXPECT_THROW(parse_evaluation("[]"), std::invalid_argument);
  EXPECT_THROW(parse_evaluation(""), std::invalid_argument);
}

TEST(LineCsv, HasARowPerLineWithTheDocumentedColumns) {
  const std::string text = to_line_csv(small_evaluation());
  EXPECT_THAT(text, StartsWith("id,patch,class,epipolar_angle_deg,kind,method,length_m,n_inliers"));
  EXPECT_THAT(text, HasSubstr("\nb,1,not_aligned,,step,direct,5.0000,40,0.0000,1.0000,0.0000,"
                              "-0.4000,-0.4000,0.4000,-0.4000,,0.0000,,evaluated,"
                              "merged;another_flag,,,,,,,,,\n"));
  EXPECT_THAT(text,
              HasSubstr("1.2000,1.2000,,0.0000,,evaluated,,,,,,,lower,object,0.9700,images\n"));
  EXPECT_THAT(text, HasSubstr("\nd,1,aligned,,,direct,5.0000,,,,,,,,,,,,no_plane,,,,,,,,,,\n"));
}

/// small_evaluation() with the place deciding on line b, 0.4 m off, as well.
Evaluation evaluation_with_groups() {
  Evaluation evaluation = small_evaluation();
  evaluation.lines[1].decided_by = DecidedBy::kPlace;
  return with_summaries(std::move(evaluation));
}

TEST(Table2, ShowsTheHeadlineFirstAndTheLinesThatThePlaceDecidedOnBesideIt) {
  const Table2 table = make_table2(std::vector{evaluation_with_groups()});
  // 0.875 is the RMS of 0.3 and 1.2
  const std::string cells = "0.300 (1/2) + 0.400 (1/2)";
  EXPECT_THAT(to_markdown(table),
              HasSubstr("| 1 | " + cells + " | 1.200 (1/2) | 0.875 (2/4) + 0.400 (1/4) |\n"));
  EXPECT_THAT(to_markdown(table), HasSubstr("those after the + were decided by points"));
  EXPECT_THAT(to_latex(table), HasSubstr(" & " + cells + " & 1.200"));
  EXPECT_THAT(to_markdown(table),
              AllOf(HasSubstr("| 1 | direct | not_aligned plan_images | 1 | 50.0 | 0.300 |"),
                    HasSubstr("| 1 | direct | not_aligned points_place | 1 | 50.0 | 0.400 |"),
                    HasSubstr("| 1 | direct | not_aligned all | 2 | 100.0 | 0.354 |"),
                    HasSubstr("| 1 | direct | aligned | 1 | 50.0 | 1.200 |")));
  EXPECT_THAT(to_markdown(make_table2(std::vector{small_evaluation()})),
              Not(HasSubstr("plan_images")));
}

TEST(Table2Csv, HasARowAClassWithTheRmsOfEachGroup) {
  const std::string text = to_csv(make_table2(std::vector{evaluation_with_groups()}));
  EXPECT_THAT(
      text,
      HasSubstr(",q95_m,n_plan_images,rms_plan_images_m,n_points_place,rms_points_place_m\n"));
  EXPECT_THAT(text, HasSubstr("\n1,direct,not_aligned,2,2,0.354,"));
  EXPECT_THAT(text, HasSubstr(",1,0.300,1,0.400\n"));
  EXPECT_THAT(text, HasSubstr(",1,1.200,0,\n"));
}

TEST(EvaluationJson, HasTheFiguresOfEachGroup) {
  const auto json = nlohmann::json::parse(to_json(evaluation_with_groups()));
  const auto& not_aligned = json["summary"]["not_aligned"];
  EXPECT_NEAR(not_aligned["decided_by"]["plan_images"]["rms_m"].get<double>(), 0.3, 1e-12);
  EXPECT_NEAR(not_aligned["decided_by"]["points_place"]["rms_m"].get<double>(), 0.4, 1e-12);
  EXPECT_EQ(not_aligned["n_half_of_squares"], 1);
  EXPECT_NEAR(not_aligned["rms_without_half_m"].get<double>(), 0.3, 1e-12);
  const auto& aligned = json["summary"]["aligned"]["decided_by"];
  EXPECT_EQ(aligned["plan_images"]["n_evaluated"], 1);
  EXPECT_EQ(aligned["points_place"]["n_evaluated"], 0);
  EXPECT_TRUE(aligned["points_place"]["rms_m"].is_null());
  EXPECT_EQ(json["strata"]["decided_by"][1]["stratum"], "points_place");
  EXPECT_EQ(json["strata"]["decided_by"][1]["n_evaluated"], 1);
  EXPECT_FALSE(nlohmann::json::parse(to_json(small_evaluation()))["strata"].contains("decided_by"));
}

TEST(Table2Parts, AreOfTheRidgesAlone) {
  Evaluation evaluation = small_evaluation();
  evaluation.lines[0].displacement = RidgeDisplacement{.horizontal_m = 0.3, .vertical_m = -0.1};
  evaluation.lines[1].displacement = RidgeDisplacement{.horizontal_m = -0.4, .vertical_m = 0.3};
  const Table2 table = make_table2(std::vector{with_summaries(evaluation)});
  // 0.354 is the RMS of 0.3 and 0.4, 0.224 that of 0.1 and 0.3
  EXPECT_THAT(parts_to_csv(table), HasSubstr("1,direct,not_aligned,2,0.354,0.224,0.100\n"));
  EXPECT_THAT(parts_to_csv(table), HasSubstr("1,direct,aligned,0,,,\n"));
  EXPECT_THAT(to_markdown(table), HasSubstr("| 1 | direct | total | 2 | 0.354 | 0.224 | 0.100 |"));
  EXPECT_THAT(to_markdown(make_table2(std::vector{small_evaluation()})), Not(HasSubstr("hips")));
}

TEST(LineCsv, HasTheHorizontalAndVerticalPartsOfARidge) {
  Evaluation evaluation = small_evaluation();
  RidgeDisplacement d{.horizontal_m = 0.2, .vertical_m = -0.1, .covariance_m2 = {}};
  d.covariance_m2 << 4e-4, 1e-4, 1e-4, 1e-4;
  evaluation.lines[0].displacement = d;
  evaluation.lines[1].height_if_vertical_m = -0.45;
  const std::string text = to_line_csv(evaluation);
  EXPECT_THAT(text, HasSubstr("flags,horizontal_m,vertical_m,sigma_horizontal_m,sigma_vertical_m,"
                              "height_if_vertical_m,surface,surface_other,surface_probability,"
                              "decided_by\n"));
  EXPECT_THAT(text, HasSubstr(",evaluated,,0.2000,-0.1000,0.0200,0.0100,,,,,\n"));
  EXPECT_THAT(text, HasSubstr("another_flag,,,,,-0.4500,,,,\n"));
}

TEST(ParseEvaluation, TakesBackThePartsOfARidge) {
  Evaluation evaluation = small_evaluation();
  RidgeDisplacement d{.horizontal_m = 0.2, .vertical_m = -0.1, .covariance_m2 = {}};
  d.covariance_m2 << 4e-4, 1e-4, 1e-4, 2e-4;
  evaluation.lines[0].displacement = d;
  evaluation.lines[1].height_if_vertical_m = -0.45;
  const Evaluation again = parse_evaluation(to_json(evaluation));
  ASSERT_TRUE(again.lines[0].displacement);
  EXPECT_EQ(again.lines[0].displacement->horizontal_m, 0.2);
  EXPECT_EQ(again.lines[0].displacement->vertical_m, -0.1);
  EXPECT_EQ(again.lines[0].displacement->covariance_m2, d.covariance_m2);
  EXPECT_FALSE(again.lines[1].displacement);
  EXPECT_EQ(again.lines[1].height_if_vertical_m, -0.45);
}

}  // namespace
}  // namespace ridgeline::evaluate
