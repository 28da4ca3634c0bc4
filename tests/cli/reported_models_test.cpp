// SPDX-License-Identifier: BSD-3-Clause
// Models of buildings as users have them, which were reported as misread.
#include "tests/cli/cli_fixture.h"
#include "tests/support/csv_rows.h"

#include <fmt/format.h>

#include <cstring>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double kMaxRms_m = 0.06;  // the noise of the scan is 0.03 m

int n_times(std::string_view part, std::string_view text) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

class ReportedModels : public Cli {
 protected:
  void SetUp() override {
    if (!fs::exists(folder_)) GTEST_SKIP() << folder_ << " is not there";
  }

  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }

  [[nodiscard]] ProgramResult judge(const std::string& model,
                                    const std::string& cloud,
                                    const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"evaluate", "--lines", model,         "--cloud",    cloud,
                                   "--out",    "out",     "--no-report", "--overwrite"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  /// The rows of a table in `out`.
  [[nodiscard]] auto rows(const std::string& name) const {
    return test::read_csv(path("out") / name);
  }

  /// Expects both houses right, like those of base/model.city.json.
  void expect_both_right() const {
    const auto buildings = rows("buildings.csv");
    ASSERT_THAT(buildings, SizeIs(2));
    for (const auto& row : buildings) {
      EXPECT_EQ(row.at("verdict"), "right") << row.at("id");
      EXPECT_EQ(row.at("n_faces"), "2") << row.at("id");
      EXPECT_LT(std::stod(row.at("rms_m")), kMaxRms_m) << row.at("id");
    }
  }

  fs::path folder_ = shared_data("reported_2");
  std::string scan_ = file("base/scan.las");
};

TEST_F(ReportedModels, AsObjHaveTwoBuildingsWhateverTheGroups) {
  for (const char* const name :
       {"by_kind", "two_names", "material", "negative", "continued", "one_name"}) {
    SCOPED_TRACE(name);
    const ProgramResult result = judge(file(fmt::format("24-obj-groups/{}.obj", name)), scan_);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    expect_both_right();
  }
}

TEST_F(ReportedModels, AsObjWithColoursAreReadAlsoWithoutComments) {
  for (const char* const name : {"colours", "eight_bit"}) {
    SCOPED_TRACE(name);
    const std::string obj = file(fmt::format("37-obj-with-colours/{}.obj", name));
    const std::string text = read(obj);
    write(path("bare.obj"), text.substr(text.find("v 5")));
    for (const std::string& model : {obj, std::string("bare.obj")}) {
      const ProgramResult result = judge(model, scan_);
      ASSERT_EQ(result.exit_code, 0) << result.err;
      expect_both_right();
    }
  }
}

TEST_F(ReportedModels, WithYUpAreRefusedNamingTheAxes) {
  EXPECT_REFUSED(judge(file("23-obj-y-up/y_up.obj"), scan_),
                 AllOf(HasSubstr("y and z look exchanged"), HasSubstr("export them with z up")));
}

TEST_F(ReportedModels, PartsInALowerLevelAreJudged) {
  for (const char* const name : {"parts.city.json", "parts.gml"}) {
    SCOPED_TRACE(name);
    const ProgramResult result =
        judge(file(fmt::format("20-part-in-lower-lod/{}", name)), file("base/scan_annex.las"));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr("1 of 3 buildings and parts is read in LoD 1"),
                                  HasSubstr(": NL.1-1")));
    int n_flat = 0;
    for (const auto& row : rows("faces.csv")) {
      EXPECT_EQ(row.at("verdict"), "right") << row.at("face");
      n_flat += row.at("building") == "NL.1" && std::stod(row.at("area_m2")) == 36.0 ? 1 : 0;
    }
    EXPECT_EQ(n_flat, 1);
    for (const auto& row : rows("buildings.csv")) EXPECT_EQ(row.at("verdict"), "right");
  }
}

TEST_F(ReportedModels, HaveEachAttributeOnceWhenJudgedTwice) {
  constexpr double kRaised_m = 0.3;
  // The offset, the largest and the smallest z of a LAS header; points are relative to the offset.
  std::string raised = read(file("base/scan.las"));
  for (const std::size_t at : {171U, 211U, 219U}) {
    double z = 0.0;
    std::memcpy(&z, raised.data() + at, sizeof z);
    z += kRaised_m;
    std::memcpy(raised.data() + at, &z, sizeof z);
  }
  write(path("raised.las"), raised);
  const std::string own = "<gen:stringAttribute name=\"owner\"><gen:value>kept</gen:value>";
  for (const std::string ending : {"gml", "city.json"}) {
    SCOPED_TRACE(ending);
    const std::string once = "once." + ending;
    const std::string twice = "twice." + ending;
    ASSERT_EQ(judge(file("base/model." + ending), scan_, {"--write-attributes", once}).exit_code,
              0);
    const std::string text = read(path(once));
    const std::size_t at = text.find("<gen:stringAttribute name=\"ridgeline_verdict");
    if (ending == "gml")
      write(path(once), std::string(text).insert(at, own + "</gen:stringAttribute>"));
    ASSERT_EQ(judge(once, "raised.las", {"--write-attributes", twice}).exit_code, 0);
    const std::string again = read(path(twice));
    EXPECT_EQ(n_times("ridgeline_verdict\"", again), 2);
    EXPECT_EQ(n_times("ridgeline_rms_m\"", again), 2);
    EXPECT_EQ(n_times("too low", again), 2);
    EXPECT_EQ(n_times(own, again), ending == "gml" ? 1 : 0);
  }
}

TEST_F(ReportedModels, InABlockAreRefusedWithTheWayToJudgeThem) {
  const std::string block =
      fmt::format("lines: {}\nlidar: {}\n", file("base/model.city.json"), file("base/scan.las"));
  write(path("block.yaml"), block);
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"info", "block.yaml"},
           {"block", "block.yaml", "--out", "b"},
           {"run", "block.yaml", "--out", "b"},
           {"evaluate", "--lines", "block.yaml", "--cloud", file("base/scan.las"), "--out", "b"}}) {
    EXPECT_REFUSED(run(words), AllOf(HasSubstr("block.yaml"), HasSubstr("a list of lines to judge"),
                                     HasSubstr("--area"), HasSubstr("pool")));
  }
}

}  // namespace
}  // namespace ridgeline::cli
