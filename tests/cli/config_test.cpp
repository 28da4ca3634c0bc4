// SPDX-License-Identifier: BSD-3-Clause
// Parameters: what `config` prints, what `--config` takes, what the presets are.
#include "tests/cli/cli_fixture.h"

#include <yaml-cpp/yaml.h>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Config : public Cli {
 protected:
  static std::vector<std::string> groups_of(const YAML::Node& parameters) {
    std::vector<std::string> groups;
    for (const auto& group : parameters) groups.push_back(group.first.Scalar());
    return groups;
  }
  [[nodiscard]] ProgramResult judge_with(const std::string& parameters) const {
    write(path("p.yaml"), parameters);
    return evaluate("scene/lines.good.geojson", "out", {"--config", "p.yaml", "--no-report"});
  }
};

TEST_F(Config, PrintsEveryGroupWithMeaningAndRange) {
  const ProgramResult printed = run({"config"});
  ASSERT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_THAT(groups_of(YAML::Load(printed.out)),
              ElementsAre("extract", "match", "tracks", "chio", "reconstruct", "judge"));
  EXPECT_THAT(printed.out,
              AllOf(HasSubstr("corridor_half_width_m: 1.5  # half width of the corridor around a "
                              "line, in plan; 0.1 to 100\n"),
                    HasSubstr("sample_consensus: msac")));
}

TEST_F(Config, IsReadBackAsItWasPrinted) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "default", {"--no-report"}).exit_code, 0);
  for (const std::string preset : {"default", "published"}) {
    const std::string printed = run({"config", "--preset", preset}).out;
    ASSERT_EQ(judge_with(printed).exit_code, 0);
    const YAML::Node stated = YAML::Load(printed);
    const nlohmann::json used = read_json(path("out/run.json"))["options"]["judge"];
    EXPECT_EQ(used.size(), stated["judge"].size());
    EXPECT_EQ(used["sample_consensus"], stated["judge"]["sample_consensus"].Scalar());
    if (preset == "published") continue;
    EXPECT_EQ(read(path("out/evaluation.lines.good.json")),
              read(path("default/evaluation.lines.good.json")));
  }
}

TEST_F(Config, PublishedHoldsNothingOfOurs) {
  const YAML::Node published = YAML::Load(run({"config", "--preset", "published"}).out);
  for (const auto& [group, key] :
       {std::pair("extract", "faint_edges"), std::pair("extract", "junction_cuts"),
        std::pair("extract", "separate_edges"), std::pair("extract", "soft_edges"),
        std::pair("match", "matched_radiometry"), std::pair("match", "hidden_walls"),
        std::pair("reconstruct", "consensus"), std::pair("reconstruct", "surface"),
        std::pair("reconstruct", "common_part"), std::pair("reconstruct", "register_profiles")}) {
    EXPECT_EQ(published[group][key].Scalar(), "false") << group << "." << key;
  }
  EXPECT_EQ(published["chio"]["allow_noise"].Scalar(), "false");
  EXPECT_EQ(published["chio"]["by_appearance"].Scalar(), "false");
  EXPECT_EQ(published["judge"]["sample_consensus"].Scalar(), "ransac");
}

TEST_F(Config, LeavesTheDefaultWhereTheFileSaysNothing) {
  ASSERT_EQ(judge_with("judge: {min_points: 12}\n").exit_code, 0);
  const nlohmann::json used = read_json(path("out/run.json"))["options"]["judge"];
  EXPECT_EQ(used["min_points"], 12);
  EXPECT_EQ(used["max_iterations"], 1000);
}

TEST_F(Config, IsAnInputThatIsRecordedAndNeverWrittenOver) {
  ASSERT_EQ(judge_with("judge: {min_points: 12}\n").exit_code, 0);
  const nlohmann::json inputs = read_json(path("out/run.json"))["inputs"];
  EXPECT_EQ(inputs.back()["role"], "config");
  std::filesystem::create_directories(path("in"));
  write(path("in/table2.csv"), "judge: {min_points: 12}\n");
  EXPECT_REFUSED(evaluate("scene/lines.good.geojson", "in", {"--config", "in/table2.csv"}),
                 HasSubstr("would be overwritten"));
}

TEST_F(Config, NamesFileLineAndRuleOfWhatItRefuses) {
  EXPECT_REFUSED(judge_with("judge:\n  min_pointz: 12\n"),
                 HasSubstr("p.yaml: line 2: unknown key 'min_pointz', did you mean 'min_points'?"));
  EXPECT_REFUSED(judge_with("juge: {}\n"), HasSubstr("did you mean 'judge'?"));
  EXPECT_REFUSED(judge_with("judge:\n\n  min_points: 3\n"),
                 HasSubstr("p.yaml: line 3: min_points = 3, must be a whole number in [4, 1e+06]"));
  EXPECT_REFUSED(judge_with("judge: {min_points: 12.5}\n"), HasSubstr("must be a whole number"));
  EXPECT_REFUSED(judge_with("judge: {min_coverage: much}\n"), HasSubstr("much"));
  EXPECT_REFUSED(judge_with("judge: {sample_consensus: magic}\n"),
                 HasSubstr("magic, must be msac, ransac or prosac"));
  EXPECT_REFUSED(judge_with("match: {hidden_walls: maybe}\n"),
                 HasSubstr("maybe, must be true or false"));
  EXPECT_REFUSED(evaluate("scene/lines.good.geojson", "out", {"--config", "none.yaml"}),
                 HasSubstr("none.yaml"));
}

}  // namespace
}  // namespace ridgeline::cli
