// SPDX-License-Identifier: BSD-3-Clause
// The file surface.las that a run keeps in the folder of a patch.
#include "io/cloud/read_cloud.h"
#include "tests/cli/cli_fixture.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// The small patch, run into `out/`.
class KeptSurface : public SmallPatch {
 protected:
  [[nodiscard]] ProgramResult run_patch(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run",       "patch/patch.yaml", "--out",      "out",
                                   "--methods", "direct",           "--no-report"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  /// The points in millimetres, which LAS keeps.
  [[nodiscard]] std::multiset<std::tuple<long, long, long>> points(const std::string& file) const {
    io::ReadOptions options;
    options.frame = LocalFrame{};
    const io::PointCloud cloud = io::read_cloud({path(file).string()}, options);
    std::multiset<std::tuple<long, long, long>> found;
    for (const io::CloudPoint& p : cloud.points) {
      found.emplace(std::lround(1000.0 * p.x), std::lround(1000.0 * p.y),
                    std::lround(1000.0 * p.z));
    }
    return found;
  }

  static constexpr const char* kFile = "out/1/surface.las";
};

TEST_F(KeptSurface, IsAPartOfThePointsThatReconstructWrites) {
  ASSERT_EQ(run_patch().exit_code, 0);
  ASSERT_EQ(run({"reconstruct", "patch/patch.yaml", "--out", "lines.geojson", "--write-surface",
                 "all.las"})
                .exit_code,
            0);
  const auto kept = points(kFile);
  const auto all = points("all.las");
  EXPECT_GT(kept.size(), 30000U);  // one of four: every second row and column
  EXPECT_LT(kept.size(), all.size());
  EXPECT_TRUE(std::includes(all.begin(), all.end(), kept.begin(), kept.end()));
}

TEST_F(KeptSurface, IsTheSameForAnyNumberOfThreadsAndWhenResumed) {
  ASSERT_EQ(run_patch({"--jobs", "1"}).exit_code, 0);
  const std::string first = read(path(kFile));
  ASSERT_EQ(run_patch({"--jobs", "2"}).exit_code, 0);
  EXPECT_TRUE(read(path(kFile)) == first);
  fs::remove(path(kFile));
  const ProgramResult resumed = run_patch({"--resume"});
  EXPECT_THAT(resumed.err, HasSubstr("5 finished stages skipped"));
  EXPECT_TRUE(read(path(kFile)) == first);
}

TEST_F(KeptSurface, OfAnEarlierRunDoesNotStayWithoutASurface) {
  write(path("off.yaml"),
        "match: {surface: false, guided: false}\nreconstruct: {surface: false}\n");
  ASSERT_EQ(run_patch().exit_code, 0);
  const std::string first = read(path(kFile));
  for (const std::vector<std::string>& off :
       {std::vector<std::string>{"--preset", "published"}, {"--config", "off.yaml", "--resume"}}) {
    ASSERT_EQ(run_patch(off).exit_code, 0);
    EXPECT_FALSE(fs::exists(path(kFile)));
    ASSERT_EQ(run_patch({"--resume"}).exit_code, 0);
    EXPECT_TRUE(read(path(kFile)) == first);
  }
}

TEST_F(KeptSurface, IsKeptIfTheReconstructionAloneAsksForIt) {
  const std::string match_off = "match: {surface: false, guided: false}\n";
  write(path("off.yaml"), match_off);
  ASSERT_EQ(run_patch({"--config", "off.yaml"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(path(kFile)));
  write(path("off.yaml"), match_off + "reconstruct: {surface: false}\n");
  ASSERT_EQ(run_patch({"--config", "off.yaml", "--resume"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(path(kFile)));
}

TEST_F(KeptSurface, IsNotWrittenOverWhatAUserHasThere) {
  for (const char* preset : {"default", "published"}) {
    write(path(kFile), "LASF of another program");  // 23 bytes
    EXPECT_REFUSED(run_patch({"--preset", preset}),
                   AllOf(HasSubstr(kFile), HasSubstr("would be overwritten")));
    EXPECT_EQ(fs::file_size(path(kFile)), 23U);
  }
}

TEST_F(KeptSurface, IsNotWrittenOverAnInput) {
  fs::create_directories(path("out/1"));
  fs::copy(path("patch/lidar.las"), path(kFile));
  std::string yaml = read(path("patch/patch.yaml"));
  yaml.replace(yaml.find("lidar.las"), 9, path(kFile).string());
  write(path("patch/patch.yaml"), yaml);
  EXPECT_REFUSED(run_patch(), AllOf(HasSubstr(kFile), HasSubstr("is an input")));
}

}  // namespace
}  // namespace ridgeline::cli
