// SPDX-License-Identifier: BSD-3-Clause
// Small inputs that once made the program fail: ../shared/data/hostile, and such as are made here.
#include "tests/cli/cli_fixture.h"

#include <fmt/format.h>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;

constexpr double kMaxTime_s = test::kIsSanitized ? 60.0 : 5.0;
constexpr double kMaxMemory_mib = test::kIsSanitized ? 4096.0 : 512.0;

class Hostile : public Cli {
 protected:
  void SetUp() override {
    if (!fs::exists(shared_data("hostile"))) GTEST_SKIP() << "../shared/data/hostile is absent";
  }

  static std::string file(std::string_view name) {
    return (shared_data("hostile") / name).string();
  }

  /// Expects an answer or a clear error within the limits.
  static void expect_in_bounds(const ProgramResult& result, const std::string& what) {
    EXPECT_THAT(result.exit_code, AnyOf(0, 1)) << what << ": " << result.err;
    EXPECT_TRUE(result.exit_code == 0 || is_refusal(result)) << what;
    EXPECT_LT(result.processor_s, kMaxTime_s) << what;
    EXPECT_LT(result.peak_memory_mib, kMaxMemory_mib) << what;
  }

  /// A line of the scene and one with an end at (x, y, z).
  [[nodiscard]] std::string lines_with_an_end_at(double x, double y, double z) const {
    const auto good = read_json(path("scene/lines.good.geojson"));
    std::string rows = "id,x1,y1,z1,x2,y2,z2\n";
    for (const auto& feature : good["features"]) {
      if (feature["geometry"].is_null()) continue;
      const auto& v = feature["geometry"]["coordinates"];
      rows += fmt::format("{},{},{},{},{},{},{}\n", feature["properties"]["id"].dump(),
                          v[0][0].get<double>(), v[0][1].get<double>(), v[0][2].get<double>(),
                          v[1][0].get<double>(), v[1][1].get<double>(), v[1][2].get<double>());
    }
    return rows + fmt::format("far,513010,5403010,250,{},{},{}\n", x, y, z);
  }
};

TEST_F(Hostile, EveryFileEndsInAnAnswerOrAClearError) {
  int n_files = 0;
  for (const std::string& name : names_in(shared_data("hostile"))) {
    if (name.ends_with(".md")) continue;
    ++n_files;
    expect_in_bounds(run({"info", file(name)}), "info " + name);
    if (name.ends_with(".tif")) {
      expect_in_bounds(run({"extract", file(name), "--out", "segments.csv"}), "extract " + name);
    } else {
      expect_in_bounds(evaluate(file(name), "out"), "evaluate " + name);
    }
  }
  EXPECT_GE(n_files, 10);
}

TEST_F(Hostile, OneHugeLineDoesNotCostTheOthers) {
  const ProgramResult result = evaluate(file("many_good_one_huge.ply"), "out", {"--no-report"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = read_json(path("out/evaluation.many_good_one_huge.json"));
  const auto& excluded = json["summary"]["total"]["n_excluded"];
  EXPECT_EQ(excluded["out_of_range"], 1);
  EXPECT_GE(json["summary"]["total"]["n_evaluated"], 70);
}

TEST_F(Hostile, HugeLineLeavesTheJudgementOfTheOthersAsItIs) {
  write(path("alone.csv"), lines_with_an_end_at(513015, 5403010, 250));
  ASSERT_EQ(evaluate("alone.csv", "alone", {"--no-report"}).exit_code, 0);
  const auto alone = read_json(path("alone/evaluation.alone.json"))["lines"];
  for (const double far : {1e6, 1e9, 1e30, -1e308}) {
    write(path("far.csv"), lines_with_an_end_at(far, 5403010, 250));
    const ProgramResult result = evaluate("far.csv", "far", {"--no-report"});
    ASSERT_EQ(result.exit_code, 0) << far << ": " << result.err;
    expect_in_bounds(result, fmt::format("{}", far));
    auto lines = read_json(path("far/evaluation.far.json"))["lines"];
    ASSERT_EQ(lines.size(), alone.size());
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      EXPECT_EQ(lines[i]["status"], alone[i]["status"]) << far << ", line " << lines[i]["id"];
      EXPECT_EQ(lines[i]["mean_distance_m"], alone[i]["mean_distance_m"]) << far;
    }
    EXPECT_NE(lines.back()["status"], "evaluated");
  }
}

TEST_F(Hostile, HugeReferenceLineIsNamed) {
  for (const double far : {1e9, 1e308}) {
    write(path("truth.csv"), lines_with_an_end_at(5, far, 0));
    const ProgramResult result =
        evaluate("scene/lines.good.geojson", "out", {"--reference-lines", "truth.csv"});
    EXPECT_REFUSED(result, AllOf(HasSubstr("truth.csv"), HasSubstr("far")));
    expect_in_bounds(result, fmt::format("{}", far));
  }
}

}  // namespace
}  // namespace ridgeline::cli
