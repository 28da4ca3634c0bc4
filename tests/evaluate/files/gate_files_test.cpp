// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/gate_files.h"

#include "io/error.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace ridgeline::results {
namespace {

using testing::HasSubstr;

class ReadGates : public testing::Test {
 protected:
  std::vector<evaluate::Gate> read(const std::string& text) {
    std::ofstream(path_) << text;
    return read_gates(path_.string());
  }

  std::string message_of(const std::string& text) {
    try {
      read(text);
    } catch (const io::IoError& error) {
      return error.what();
    }
    return "no error";
  }

  io::TempFolder folder_;
  std::filesystem::path path_ = folder_.file("gates.yaml");
};

TEST_F(ReadGates, ReadsTheContractsExample) {
  const std::vector<evaluate::Gate> gates = read(R"(gates:
  - {class: total, method: joint, metric: rms_m, max: 0.30}
  - {class: aligned, method: joint, metric: rms_m, max_ratio_to: {class: not_aligned}, ratio: 2.5}
  - {class: total, metric: evaluated_share, min: 0.80}
  - {metric: rms_m, class: total, max_increase_over_baseline: 0.02}
)");
  ASSERT_EQ(gates.size(), 4U);
  EXPECT_EQ(gates[0].line_class, "total");
  EXPECT_EQ(gates[0].method, "joint");
  EXPECT_EQ(gates[0].metric, "rms_m");
  EXPECT_EQ(gates[0].max, 0.30);
  EXPECT_FALSE(gates[0].patch);
  EXPECT_FALSE(gates[0].min);
  EXPECT_EQ(gates[1].max_ratio_to_class, "not_aligned");
  EXPECT_EQ(gates[1].ratio, 2.5);
  EXPECT_EQ(gates[2].min, 0.80);
  EXPECT_EQ(gates[3].max_increase_over_baseline->value, 0.02);
  EXPECT_FALSE(gates[3].max_decrease_below_baseline);
}

TEST_F(ReadGates, ReadsPatchNumberOfLinesAndTheDefaultIncrease) {
  const std::vector<evaluate::Gate> gates = read(
      "gates: [{patch: 1, n_min: 30, max_increase_over_baseline: default, "
      "max_decrease_below_baseline: 0.01}]");
  EXPECT_EQ(gates.at(0).patch, "1");
  EXPECT_EQ(gates.at(0).n_min, 30U);
  ASSERT_TRUE(gates.at(0).max_increase_over_baseline);
  EXPECT_FALSE(gates.at(0).max_increase_over_baseline->value);
  EXPECT_EQ(gates.at(0).max_decrease_below_baseline, 0.01);
}

TEST_F(ReadGates, TakesTheFilesNumberOfLinesWhereAGateHasNone) {
  const std::vector<evaluate::Gate> gates =
      read("n_min: 20\ngates: [{max: 1}, {max: 1, n_min: 5}]\n");
  EXPECT_EQ(gates.at(0).n_min, 20U);
  EXPECT_EQ(gates.at(1).n_min, 5U);
  EXPECT_FALSE(read("gates: [{max: 1}]").at(0).n_min);
}

TEST_F(ReadGates, NamesTheLineTheNearestAndTheKnownKeysForAnUnknownOne) {
  const std::string message = message_of("gates:\n  - {class: total, maximum: 0.3}\n");
  EXPECT_THAT(
      message,
      HasSubstr(
          "gates.yaml: line 2: unknown key 'maximum', did you mean 'max'? known keys: patch, "));
  EXPECT_THAT(message, HasSubstr("max_increase_over_baseline"));
  EXPECT_THAT(message_of("gate: []"),
              HasSubstr("unknown key 'gate', did you mean 'gates'? known keys: n_min, gates"));
  EXPECT_THAT(message_of("gates: [{max_increase_over_base: 1}]"),
              HasSubstr("did you mean 'max_increase_over_baseline'?"));
  EXPECT_THAT(message_of("gates: [{max_ratio_to: {clas: aligned}}]"),
              HasSubstr("unknown key 'clas', did you mean 'class'? known keys: class"));
  EXPECT_THAT(message_of("gates: [{max: 1, max: 2}]"), HasSubstr("key 'max' appears twice"));
}

TEST_F(ReadGates, RejectsValuesOfTheWrongType) {
  EXPECT_THAT(message_of("gates: [{max: low}]"), HasSubstr("max = low; must be a finite number"));
  EXPECT_THAT(message_of("gates: [{max: .nan}]"), HasSubstr("must be a finite number"));
  EXPECT_THAT(message_of("gates: [{min: [1]}]"), HasSubstr("min = a list or a mapping; must be"));
  EXPECT_THAT(message_of("gates: [{class: [a]}]"), HasSubstr("class must be a string"));
  EXPECT_THAT(message_of("gates: [{n_min: 2.5}]"), HasSubstr("n_min = 2.5; must be a whole"));
  EXPECT_THAT(message_of("gates: [{n_min: 0}]"), HasSubstr("must be a whole number >= 1"));
  EXPECT_THAT(message_of("gates: [{max_increase_over_baseline: -1}]"),
              HasSubstr("-1; must be >= 0"));
  EXPECT_THAT(message_of("gates: [{max_decrease_below_baseline: default}]"),
              HasSubstr("max_decrease_below_baseline = default; must be a finite number"));
  EXPECT_THAT(message_of("{n_min: few, gates: [{max: 1}]}"), HasSubstr("n_min = few; must be"));
  EXPECT_THAT(message_of("gates: [{max_ratio_to: aligned}]"),
              HasSubstr("a mapping is expected; known keys: class"));
  EXPECT_THAT(message_of("gates: [{max_ratio_to: {}}]"), HasSubstr("key 'class' is missing"));
  EXPECT_THAT(message_of("gates: [{max: 1, ratio: 2}]"), HasSubstr("without max_ratio_to"));
  EXPECT_THAT(message_of("gates: [total]"), HasSubstr("a mapping is expected"));
}

TEST_F(ReadGates, RejectsAFileWithoutGates) {
  EXPECT_THAT(message_of(""), HasSubstr("is empty"));
  EXPECT_THAT(message_of("7"), HasSubstr("a mapping is expected"));
  EXPECT_THAT(message_of("gates: []"), HasSubstr("at least one gate"));
  EXPECT_THAT(message_of("gates: 3"), HasSubstr("at least one gate"));
  EXPECT_THAT(message_of("gates: [{max: 1}"), HasSubstr("not YAML"));
  EXPECT_THROW(read_gates("/nonexistent/gates.yaml"), io::IoError);
}

}  // namespace
}  // namespace ridgeline::results
