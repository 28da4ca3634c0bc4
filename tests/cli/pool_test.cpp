// SPDX-License-Identifier: BSD-3-Clause
// Lines that are judged area by area and pooled have the figures of one run.
#include "tests/cli/cli_fixture.h"
#include "tests/support/cut_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace ridgeline::cli {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A town of more houses than `scene/`, with its cloud in tiles, and one run of all lines; made
/// once.
class Pool : public Cli {
 protected:
  static void SetUpTestSuite() {
    Cli::SetUpTestSuite();
    town_ = new Town;
  }
  static void TearDownTestSuite() {
    delete town_;
    town_ = nullptr;
    Cli::TearDownTestSuite();
  }

  void SetUp() override {
    std::filesystem::copy(town_->folder, path("town"), std::filesystem::copy_options::recursive);
  }

  /// Judges the lines of an area of the town, or all without one.
  [[nodiscard]] ProgramResult judge(const std::string& area,
                                    const std::string& out,
                                    const std::vector<std::string>& more = {}) const {
    return run(judging(area, out, more));
  }

  /// Judges n x n areas that cover the town, with seams at odd places, into OUT/0, OUT/1, ...
  [[nodiscard]] std::vector<std::string> judge_areas(int n, const std::string& out) const {
    constexpr double kLow_m = -2000.0, kHigh_m = 8000.0, kFirstSeam_m = 21.7, kStep_m = 19.3;
    const auto side = [&](int i) {
      if (i == 0) return kLow_m;
      return i == n ? kHigh_m : kFirstSeam_m + kStep_m * (i - 1);
    };
    std::vector<std::string> folders;
    for (int x = 0; x < n; ++x) {
      for (int y = 0; y < n; ++y) {
        folders.push_back(fmt::format("{}/{}", out, folders.size()));
        const ProgramResult result =
            judge(fmt::format("{},{},{},{}", 513000.0 + side(x), 5403000.0 + side(y),
                              513000.0 + side(x + 1), 5403000.0 + side(y + 1)),
                  folders.back());
        EXPECT_EQ(result.exit_code, 0) << result.err;
      }
    }
    return folders;
  }

  [[nodiscard]] ProgramResult pool(std::vector<std::string> folders, const std::string& out) const {
    folders.insert(folders.begin(), "pool");
    for (const char* word : {"--out", out.c_str(), "--no-report"}) folders.emplace_back(word);
    return run(folders);
  }

 private:
  static std::vector<std::string> judging(const std::string& area,
                                          const std::string& out,
                                          const std::vector<std::string>& more) {
    std::vector<std::string> words{"evaluate",
                                   "--lines",
                                   "town/truth.geojson",
                                   "town/lines.fair.geojson",
                                   "town/odd.csv",
                                   "--cloud",
                                   "town/tiles/*.las",
                                   "--out",
                                   out,
                                   "--no-report"};
    if (!area.empty()) words.insert(words.end(), {"--area", area});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  struct Town {
    Town() {
      const std::filesystem::path base = std::filesystem::temp_directory_path();
      std::string pattern = (base / "ridgeline-pool-XXXXXX").string();
      folder = std::filesystem::path(mkdtemp(pattern.data())) / "town";
      const auto program = [&](const std::vector<std::string>& words) {
        const ProgramResult result =
            test::run_program(test::program(), words, folder.parent_path());
        EXPECT_EQ(result.exit_code, 0) << result.err;
      };
      program({"simulate", "--out", "town", "--seed", "3", "--extent-m", "90,90", "--no-images"});
      test::cut_cloud(folder / "lidar.las", folder / "tiles", 37.0);
      write(folder / "odd.csv",
            "id,x1,y1,z1,x2,y2,z2\n"
            "a,513030,5403030,251,513035,5403032,251\n"
            "a,513060,5403060,251,513065,5403062,251\n"
            "b,nan,5403030,251,513035,5403032,251\n"
            "c,513030,5403030,-9999,513035,5403032,-9999\n"
            "d,513010,5403010,251,513010,5403010,251\n"
            "e,519010,5403010,251,519020,5403010,251\n");
      program(judging("", "town/whole", {}));
    }
    Town(const Town&) = delete;
    Town& operator=(const Town&) = delete;
    ~Town() { std::filesystem::remove_all(folder.parent_path()); }
    std::filesystem::path folder;
  };
  static inline Town* town_ = nullptr;
};

/// Numbers to a nanometre: coordinates of files are not those of the local frame to the last digit.
json without_last_digits(json values) {
  if (values.is_number_float()) return std::round(values.get<double>() * 1e9) / 1e9;
  if (!values.is_structured()) return values;
  for (json& value : values) value = without_last_digits(value);
  return values;
}

class PoolOfAreas : public Pool, public testing::WithParamInterface<int> {};

TEST_P(PoolOfAreas, HasTheFiguresOfOneRun) {
  const std::vector<std::string> folders = judge_areas(GetParam(), "areas");
  const ProgramResult result = pool(folders, "pooled");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const char* stem : {"truth", "lines.fair", "odd"}) {
    SCOPED_TRACE(stem);
    const std::string name = fmt::format("evaluation.{}.json", stem);
    const json whole = read_json(path("town/whole/" + name));
    const json pooled = read_json(path("pooled/" + name));
    for (const char* key : {"patch", "method", "options", "summary", "strata", "calibration"}) {
      EXPECT_EQ(pooled[key], whole[key]) << key;
    }
    EXPECT_EQ(pooled["decoys"], whole["decoys"]);
    EXPECT_EQ(pooled["elsewhere"], whole["elsewhere"]);
    EXPECT_EQ(without_last_digits(pooled["lines"]), without_last_digits(whole["lines"]));
    EXPECT_EQ(without_last_digits(pooled["shift"]), without_last_digits(whole["shift"]));
  }
  EXPECT_EQ(read(path("pooled/tolerances.csv")), read(path("town/whole/tolerances.csv")));
}

TEST_P(PoolOfAreas, AddsFewBytesALine) {
  std::size_t n_lines = 0, n_bytes = 0;
  for (const std::string& folder : judge_areas(GetParam(), "areas")) {
    for (const char* stem : {"truth", "lines.fair"}) {
      const json area = read_json(path(fmt::format("{}/evaluation.{}.json", folder, stem)));
      const auto size = [](const json& value) { return value.dump(2).size(); };
      n_bytes += size(area["area"]);
      n_lines += area["lines"].size();
      for (const json& line : area["lines"]) {
        json less = line;
        less.erase("number");
        for (json& plane : less["planes"]) plane.erase("points");
        n_bytes += size(line) - size(less);
      }
    }
  }
  EXPECT_LE(n_bytes, 300 * n_lines);
}

INSTANTIATE_TEST_SUITE_P(OfN, PoolOfAreas, testing::Values(1, 2, 4));

class PoolRefuses : public Pool {
 protected:
  static constexpr const char* kWest = "512000,5400000,513045,5410000";
  static constexpr const char* kEast = "513045,5400000,520000,5410000";

  void expect_refused(const std::string& area,
                      const std::vector<std::string>& more,
                      const testing::Matcher<std::string>& message) const {
    ASSERT_EQ(judge(kWest, "west").exit_code, 0);
    const ProgramResult other = judge(area, "east", more);
    ASSERT_EQ(other.exit_code, 0) << other.err;
    EXPECT_REFUSED(pool({"west", "east"}, "pooled"), message);
    EXPECT_FALSE(std::filesystem::exists(path("pooled")));
  }
};

TEST_F(PoolRefuses, OtherOptions) {
  expect_refused(kEast, {"--gross-m", "0.7"}, AllOf(HasSubstr("east"), HasSubstr("gross_m: 0.7")));
}

TEST_F(PoolRefuses, AreasThatOverlap) {
  expect_refused("513044,5400000,520000,5410000", {}, HasSubstr("overlaps that of west"));
}

TEST_F(PoolRefuses, LinesThatWereMoved) {
  ASSERT_EQ(judge(kWest, "west", {"--apply-shift"}).exit_code, 0);
  EXPECT_REFUSED(pool({"west"}, "pooled"), HasSubstr("apply-shift"));
}

TEST_F(PoolRefuses, AnotherReferenceSystem) {
  expect_refused(kEast, {"--origin", "513100,5403000,200"}, HasSubstr("origin_m"));
}

TEST_F(PoolRefuses, AnotherVersion) {
  ASSERT_EQ(judge(kWest, "west").exit_code, 0);
  ASSERT_EQ(judge(kEast, "east").exit_code, 0);
  json record = read_json(path("east/run.json"));
  record["versions"]["git_hash"] = "0000000";
  write(path("east/run.json"), record.dump());
  EXPECT_REFUSED(pool({"west", "east"}, "pooled"), HasSubstr("version git_hash: \"0000000\""));
}

TEST_F(PoolRefuses, LinesThatStandTwice) {
  ASSERT_EQ(judge(kWest, "west").exit_code, 0);
  std::filesystem::copy(path("west"), path("east"));
  json record = read_json(path("east/run.json"));
  record["options"]["area"] = {513045, 5400000, 520000, 5410000};
  write(path("east/run.json"), record.dump());
  EXPECT_REFUSED(pool({"west", "east"}, "pooled"), HasSubstr("stands there and in west"));
}

TEST_F(PoolRefuses, ARunOfAllLines) {
  EXPECT_REFUSED(pool({"town/whole"}, "pooled"), HasSubstr("is not the judgement of an area"));
}

TEST_F(Pool, SaysHowManyLinesLieInNoArea) {
  ASSERT_EQ(judge("512000,5400000,513045,5410000", "west").exit_code, 0);
  const ProgramResult result = pool({"west"}, "pooled");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("lie in none of the areas"));
}

TEST_F(Pool, IsAFolderOfResults) {
  const ProgramResult pooled = pool(judge_areas(2, "areas"), "pooled");
  ASSERT_EQ(pooled.exit_code, 0) << pooled.err;
  EXPECT_EQ(read_json(path("pooled/run.json"))["runs"].size(), 4U);
  EXPECT_THAT(run({"info", "pooled"}).out, HasSubstr("results of ridgeline pool"));
  write(path("gates.yaml"), "gates:\n  - {class: total, metric: rms_m, max: 5.0}\n");
  const ProgramResult gate =
      run({"gate", "pooled", "--gates", "gates.yaml", "--baseline", "town/whole"});
  EXPECT_EQ(gate.exit_code, 0) << gate.err;
  const ProgramResult compared = run({"compare", "pooled", "town/whole", "--out", "compared"});
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
}

TEST_F(Pool, HasAPageWithThePlanOfItsAreas) {
  const std::vector<std::string> folders = judge_areas(2, "areas");
  ASSERT_EQ(run({"report", folders[0]}).exit_code, 0);
  ASSERT_EQ(pool(folders, "pooled").exit_code, 0);
  const ProgramResult report = run({"report", "pooled"});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  const json areas = data_of("pooled/report.html")["run"]["areas"];
  ASSERT_EQ(areas.size(), folders.size());
  std::size_t n_lines = 0;
  for (const json& area : areas) n_lines += area["n_lines"].get<std::size_t>();
  EXPECT_EQ(n_lines, read_json(path("town/whole/evaluation.truth.json"))["lines"].size());
  const auto n_pages =
      std::ranges::count_if(areas, [](const json& area) { return area.contains("page"); });
  EXPECT_EQ(n_pages, 1);
  EXPECT_EQ(areas[0]["page"], "../areas/0/report.html");
}

TEST_F(Pool, TakesTheEmptyArea) {
  const ProgramResult result = judge("500000,5400000,500001,5410000", "nothing");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_REFUSED(judge("3,3,3,4", "none"), HasSubstr("must be x_min,y_min,x_max,y_max"));
}

}  // namespace
}  // namespace ridgeline::cli
