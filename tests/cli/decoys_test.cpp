// SPDX-License-Identifier: BSD-3-Clause
// Lines that are moved on purpose and judged again, and lines of another place.
#include "tests/cli/run_fixture.h"

#include <algorithm>

namespace ridgeline::cli {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Decoys : public Cli {
 protected:
  [[nodiscard]] json judged(const std::string& folder) const {
    return read_json(path(folder + "/evaluation.lines.good.json"));
  }
};

/// The figures without the intervals, whose clusters depend on the order of lines.
std::vector<json> shares_of(const json& evaluation) {
  std::vector<json> shares;
  for (json row : evaluation["decoys"]) {
    row.erase("ci95");
    row.erase("n_clusters");
    shares.push_back(row);
  }
  return shares;
}

TEST_F(Decoys, StandInEveryOutputByKindAndDistance) {
  const ProgramResult result = evaluate("scene/lines.good.geojson", "out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("Decoys that pass within 0.2 m"),
                                HasSubstr("not show how many lines are wrong")));
  const json decoys = judged("out")["decoys"];
  ASSERT_EQ(decoys.size(), 8U) << "two kinds by four distances: no images are given";
  for (const json& row : decoys) {
    EXPECT_GT(row["n_decoys"], 10);
    EXPECT_LE(row["ci95"][0], row["share"]);
    EXPECT_GE(row["ci95"][1], row["share"]);
    if (row["kind"] == "height") {
      EXPECT_LT(row["share"], 0.1) << row;
    }
    // a shift of 0.5 m along a roof is not seen
    if (row["kind"] == "across" && row["distance_m"] == 0.5) {
      EXPECT_GT(row["share"], 0.3) << row;
    }
  }
  EXPECT_THAT(read(path("out/decoys.csv")), HasSubstr("lines.good,height,0.5,"));
  EXPECT_THAT(read(path("out/accuracy.lines.good.md")), HasSubstr("| height | 0.5 m |"));
}

TEST_F(Decoys, ChangeNoLine) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "with").exit_code, 0);
  const ProgramResult without = evaluate("scene/lines.good.geojson", "without", {"--decoys", "0"});
  ASSERT_EQ(without.exit_code, 0);
  EXPECT_THAT(without.out, Not(HasSubstr("Decoys")));
  json with = judged("with");
  json none = judged("without");
  EXPECT_TRUE(none["decoys"].empty());
  EXPECT_TRUE(none["elsewhere"].is_null());
  for (const char* key : {"decoys", "elsewhere"}) {
    with.erase(key);
    none.erase(key);
  }
  EXPECT_EQ(with, none);
  EXPECT_FALSE(std::filesystem::exists(path("without/decoys.csv")));
}

TEST_F(Decoys, AreTheSameForAnyOrderOfLinesAndNumberOfThreads) {
  json lines = read_json(path("scene/lines.good.geojson"));
  std::ranges::reverse(lines["features"]);
  write(path("turned/lines.good.geojson"), lines.dump());
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out", {"--jobs", "1"}).exit_code, 0);
  ASSERT_EQ(evaluate("turned/lines.good.geojson", "turned_out", {"--jobs", "3"}).exit_code, 0);
  EXPECT_EQ(shares_of(judged("out")), shares_of(judged("turned_out")));
}

TEST_F(Decoys, AreGated) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out").exit_code, 0);
  const auto gate = [&](const std::string& entry) {
    write(path("gates.yaml"), "gates: [" + entry + "]\n");
    return run({"gate", "out", "--gates", "gates.yaml"});
  };
  EXPECT_EQ(gate("{metric: decoy_share, kind: height, distance_m: 2, max: 0.2}").exit_code, 0);
  const ProgramResult narrow =
      gate("{metric: decoy_share, kind: height, distance_m: 2, max: 0.001}");
  EXPECT_EQ(narrow.exit_code, 3);
  EXPECT_THAT(narrow.out, AllOf(HasSubstr("insufficient"), HasSubstr("wider than the limit")));
  EXPECT_EQ(gate("{metric: decoy_share, kind: match, distance_m: 2, max: 0.2}").exit_code, 3);
  EXPECT_REFUSED(gate("{metric: decoy_share, max: 0.2}"), HasSubstr("line 1: kind: none"));
  EXPECT_REFUSED(gate("{metric: rms_m, max: 0.2, bound: lower95}"),
                 HasSubstr("bound = lower95; must be point or upper95"));
}

TEST_F(Decoys, UpperEndOfTheIntervalIsGated) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out").exit_code, 0);
  const json total = judged("out")["summary"]["total"];
  const double between = 0.5 * (total["rms_m"].get<double>() + total["ci95_m"][1].get<double>());
  const auto gate = [&](const std::string& bound) {
    write(path("gates.yaml"),
          "gates: [{metric: rms_m, max: " + std::to_string(between) + ", bound: " + bound + "}]\n");
    return run({"gate", "out", "--gates", "gates.yaml"});
  };
  EXPECT_EQ(gate("point").exit_code, 0);
  const ProgramResult failed = gate("upper95");
  EXPECT_EQ(failed.exit_code, 3);
  EXPECT_THAT(failed.out, AllOf(HasSubstr("total rms_m upper95 <="),
                                HasSubstr("upper end of the 95 % interval")));
}

TEST_F(Decoys, LinesOfAnotherPlaceAreRefused) {
  for (const char* const seed : {"307", "309"}) {
    ASSERT_EQ(run({"simulate", "--no-images", "--seed", seed, "--out", seed}).exit_code, 0);
  }
  const auto judge = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"evaluate",      "--lines",    "307/lines.good.geojson",
                                       "--out",         "out",        "--cloud",
                                       "309/lidar.las", "--no-report"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  EXPECT_REFUSED(judge({}), AllOf(HasSubstr("the lines do not fit the cloud"),
                                  HasSubstr("--decoys 0 judges them without this check")));
  EXPECT_EQ(judge({"--decoys", "0"}).exit_code, 0);
}

}  // namespace
}  // namespace ridgeline::cli
