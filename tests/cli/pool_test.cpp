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

/// The figures without intervals and counts of clusters.
json without_intervals(json figures) {
  if (!figures.is_structured()) return figures;
  for (const char* key : {"ci95", "ci95_m", "n_clusters", "few_clusters", "uncertainty"}) {
    if (figures.is_object()) figures.erase(key);
  }
  for (json& part : figures) part = without_intervals(part);
  return figures;
}

/// What a line was judged to be: all but its coordinates and planes.
json verdict_of(json line) {
  for (const char* key : {"start_m", "end_m", "planes", "number"}) line.erase(key);
  return line;
}

/// The lines of each line's cluster: those that share planes, from one to the next.
std::vector<std::set<std::size_t>> clusters_of(const json& lines) {
  std::vector<std::size_t> label(lines.size());
  std::map<std::uint64_t, std::size_t> by_plane;
  for (std::size_t i = 0; i < lines.size(); ++i) label[i] = i;
  const auto unite = [&](std::size_t a, std::size_t b) {
    for (std::size_t& one : label) one = one == a ? b : one;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const json& plane : lines[i]["planes"]) {
      const auto entry = by_plane.try_emplace(plane["id"].get<std::uint64_t>(), i).first;
      if (label[i] != label[entry->second]) unite(label[i], label[entry->second]);
    }
  }
  std::vector<std::set<std::size_t>> clusters(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (label[i] == label[k]) clusters[i].insert(k);
    }
  }
  return clusters;
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
      EXPECT_EQ(without_intervals(pooled[key]), without_intervals(whole[key])) << key;
    }
    EXPECT_EQ(without_intervals(pooled["decoys"]), without_intervals(whole["decoys"]));
    EXPECT_EQ(without_intervals(pooled["elsewhere"]), without_intervals(whole["elsewhere"]));
    ASSERT_EQ(pooled["lines"].size(), whole["lines"].size());
    for (std::size_t i = 0; i < whole["lines"].size(); ++i) {
      EXPECT_EQ(verdict_of(pooled["lines"][i]), verdict_of(whole["lines"][i]));
    }
    constexpr double kShift_m = 0.001;
    if (!whole["shift"].is_null()) {
      for (const auto& [axis, shift] : whole["shift"]["axes"].items()) {
        const json& of_pool = pooled["shift"]["axes"][axis];
        ASSERT_EQ(of_pool.is_null(), shift.is_null()) << axis;
        if (shift.is_null()) continue;
        EXPECT_NEAR(of_pool["shift_m"].get<double>(), shift["shift_m"].get<double>(), kShift_m);
      }
    }
  }
  EXPECT_EQ(read(path("pooled/tolerances.csv")), read(path("town/whole/tolerances.csv")));
}

TEST_P(PoolOfAreas, HasTheIntervalsOfOneRunInFewBytes) {
  const std::vector<std::string> folders = judge_areas(GetParam(), "areas");
  ASSERT_EQ(pool(folders, "pooled").exit_code, 0);
  std::size_t n_lines = 0, n_same = 0, n_bytes = 0;
  for (const char* stem : {"truth", "lines.fair"}) {
    const std::string name = fmt::format("evaluation.{}.json", stem);
    const json whole = read_json(path("town/whole/" + name));
    const json pooled = read_json(path("pooled/" + name));
    const auto expected = clusters_of(whole["lines"]);
    const auto found = clusters_of(pooled["lines"]);
    for (std::size_t i = 0; i < expected.size(); ++i) n_same += expected[i] == found[i] ? 1 : 0;
    n_lines += expected.size();
    const json& in_one = whole["summary"]["total"]["ci95_m"];
    const json& in_pool = pooled["summary"]["total"]["ci95_m"];
    const auto width = [](const json& interval) {
      return interval[1].get<double>() - interval[0].get<double>();
    };
    EXPECT_NEAR(width(in_pool), width(in_one), 0.05 * width(in_one));
    for (const std::string& folder : folders) {
      const json area = read_json(path(folder + "/" + name));
      const auto size = [](const json& value) { return value.dump(2).size(); };
      n_bytes += size(area["area"]);
      for (const json& line : area["lines"]) {
        json less = line;
        less.erase("number");
        for (json& plane : less["planes"]) plane.erase("sample");
        n_bytes += size(line) - size(less);
      }
    }
  }
  // Samples of points decide which planes are one across a seam. Areas of 20 m, narrower than the
  // roofs, are only checked by their intervals.
  constexpr std::array kLeastShare{1.0, 0.95, 0.0, 0.75};  // by areas a side, less one
  const double least_share = kLeastShare.at(static_cast<std::size_t>(GetParam() - 1));
  EXPECT_GE(static_cast<double>(n_same), least_share * static_cast<double>(n_lines));
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
  EXPECT_REFUSED(pool({"west"}, "pooled"), HasSubstr("apply_shift"));
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
  const ProgramResult report = run({"report", "pooled"});
  EXPECT_EQ(report.exit_code, 0) << report.err;
}

TEST_F(Pool, TakesTheEmptyArea) {
  const ProgramResult result = judge("500000,5400000,500001,5410000", "nothing");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_REFUSED(judge("3,3,3,4", "none"), HasSubstr("must be x_min,y_min,x_max,y_max"));
}

}  // namespace
}  // namespace ridgeline::cli
