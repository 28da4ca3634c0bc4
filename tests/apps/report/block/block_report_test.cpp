// SPDX-License-Identifier: BSD-3-Clause
// What stands in the report of a block and on the pages of its patches.
#include "apps/report/block/block_json.h"
#include "apps/report/block/write_block_report.h"
#include "apps/report/page.h"
#include "evaluate/files/output_folder.h"
#include "evaluate/tables/table2.h"
#include "tests/apps/report/block/block_fixture.h"

#include <gmock/gmock.h>

namespace ridgeline::apps {
namespace {

using evaluate::Json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Json data_of(const std::string& page) {
  const std::string begin = R"(id="report-data">)";
  const std::size_t at = page.find(begin) + begin.size();
  return Json::parse(page.substr(at, page.find("</script>", at) - at));
}

Json report_of(const BlockFixture& block) {
  (void)write_block_report(block.path(), std::nullopt);
  return data_of(block.folder().read("report.html"));
}

TEST(BlockReport, HasTheFiguresOfItsTables) {
  const BlockFixture block;
  const Json data = report_of(block);
  EXPECT_EQ(data["note"], evaluate::kFixedSentence);
  EXPECT_EQ(data["table2"].size(), 1U);
  EXPECT_EQ(data["table2"][0]["rms_m"], 0.5);
  ASSERT_EQ(data["patches"].size(), 3U);
  EXPECT_EQ(data["patches"][0]["core"], Json({0.0, 0.0, 100.0, 100.0}));
  EXPECT_EQ(data["patches"][0]["figures"][0].dump(),
            R"({"n_lines":2,"n_evaluated":1,"rms_m":0.1234,"median_m":0.1,"max_m":0.2,)"
            R"("n_reference_lines":4,"n_reference_found":3})");
  EXPECT_EQ(data["patches"][1]["figures"][0]["rms_m"], nullptr);
}

TEST(BlockReport, NamesFailedPatchesWithTheirReasons) {
  const Json data = report_of(BlockFixture());
  EXPECT_EQ(data["patches"][0]["reason"], "");
  EXPECT_EQ(data["patches"][2]["reason"], R"(a.tif: is damaged, "very")");
}

TEST(BlockReport, HoldsNoFoldersAndNoTimes) {
  const BlockFixture block;
  (void)write_block_report(block.path(), std::nullopt);
  for (const char* name : {"report.html", "pages/10_20.html", "pages/10_21.html"}) {
    const std::string page = block.folder().read(name);
    EXPECT_THAT(page, Not(HasSubstr(block.data().file("")))) << name;
    EXPECT_THAT(page, Not(HasSubstr("12345.678"))) << name;
  }
  EXPECT_EQ(report_of(block)["notes"][0], "b.tif: is dark");
}

TEST(BlockReport, ShowsWorstLinesAndLeavesOutThoseOfNoPatch) {
  const Json method = report_of(BlockFixture())["methods"][0];
  EXPECT_EQ(method["lines"]["n_all"], 2);
  ASSERT_EQ(method["worst"].size(), 1U);
  EXPECT_EQ(method["worst"][0].dump(),
            R"({"id":"7","patch":"10_20","class":"aligned","kind":"step","status":"evaluated",)"
            R"("length_m":10.05,"mean_m":0.1,"max_m":0.2,"n_images":0})");
}

TEST(BlockReport, HasTheSameBytesAgain) {
  const BlockFixture block;
  (void)write_block_report(block.path(), std::nullopt);
  const std::string report = block.folder().read("report.html");
  const std::string page = block.folder().read("pages/10_20.html");
  block.write_run({{"stages", {{{"seconds", 9.0}}}}});
  (void)write_block_report(block.path(), std::nullopt);
  EXPECT_EQ(block.folder().read("report.html"), report);
  EXPECT_EQ(block.folder().read("pages/10_20.html"), page);
}

TEST(EveryKth, LeavesAtMostSoMany) {
  EXPECT_THAT(every_kth({1, 2, 3, 4, 5}, 2), ElementsAre(1, 4));
  EXPECT_THAT(every_kth({1, 2, 3, 4, 5}, 5), ElementsAre(1, 2, 3, 4, 5));
  EXPECT_TRUE(every_kth({}, 5).empty());
}

TEST(BlockReport, ShowsThePointsOfItsAreaOnAPage) {
  const BlockFixture block;
  (void)write_block_report(block.path(), std::nullopt);
  const Json page = data_of(block.folder().read("pages/10_20.html"));
  EXPECT_EQ(page["points"]["n_shown"], 110 * 110);  // from 0 to below 110 m, at whole metres
  EXPECT_EQ(page["points"]["steps"][0], 0.0);
  EXPECT_EQ(report_of(block)["points"]["n_all"], BlockFixture::kPoints);
}

TEST(BlockReport, SaysWhyThereIsNoLidar) {
  const BlockFixture block;
  std::filesystem::resize_file(block.cloud(), 100);
  const Json data = report_of(block);
  EXPECT_EQ(data["points"], nullptr);
  EXPECT_THAT(data["notes"][1].get<std::string>(),
              HasSubstr("LIDAR is not shown: lidar.pcd: has changed since the block was judged"));
}

TEST(BlockReport, RefusesADamagedPlan) {
  const BlockFixture block;
  (void)block.folder().write("plan.json", R"({"plan": 3})");
  EXPECT_THAT(io::io_error_of([&] { (void)write_block_report(block.path(), std::nullopt); }),
              HasSubstr("a results file is damaged"));
}

TEST(PatchPage, HasItsLinesItsRowAndItsNeighbours) {
  const BlockFixture block;
  (void)write_block_report(block.path(), std::nullopt);
  const Json page = data_of(block.folder().read("pages/10_20.html"));
  EXPECT_EQ(page["methods"][0]["lines"].dump(),
            R"([["7","aligned","step","evaluated",10.05,0.1,0.2,0,10.0,10.0,5.0,20.0,10.0,6.0],)"
            R"(["8","aligned","","no_plane",10.0,null,null,0,30.0,50.0,5.0,30.0,60.0,5.0]])");
  EXPECT_EQ(page["table2"].size(), 1U);
  EXPECT_EQ(page["neighbours"].dump(), R"({"north":"10_21","east":"11_20"})");
}

TEST(PatchPages, OfPatchesThatAreGoneAreRemoved) {
  const BlockFixture block;
  results::OutputFolder(block.path(), {}).write("pages/1_1.html", "old");
  const std::string gone = block.folder().file("pages/1_1.html");
  const std::string other = block.folder().write("pages/notes.html", "mine");
  (void)write_block_report(block.path(), std::nullopt);
  EXPECT_FALSE(std::filesystem::exists(gone));
  EXPECT_TRUE(std::filesystem::exists(other));
  EXPECT_TRUE(std::filesystem::exists(block.folder().file("pages/11_20.html")));
  remove_patch_pages(results::OutputFolder(block.path(), {}), block.path());
  EXPECT_FALSE(std::filesystem::exists(block.folder().file("pages/11_20.html")));
  EXPECT_TRUE(std::filesystem::exists(other));
}

TEST(BlockFolder, IsKnownByItsPlanAndItsRun) {
  const BlockFixture block;
  EXPECT_TRUE(is_block_folder(block.path()));
  block.write_run({{"command", "evaluate"}});
  EXPECT_FALSE(is_block_folder(block.path()));
  EXPECT_FALSE(is_block_folder(block.data().file("")));
}

/// A thousand patches with 300 lines each, and as much LIDAR as is held.
BlockFolder large_block() {
  const BlockFixture fixture;
  BlockFolder block = read_block_folder(fixture.path());
  const ShownPatch one = block.patches[0];
  const ShownLine line = block.methods[0].lines[0];
  block.patches.clear();
  for (std::uint32_t i = 0; i < 1000; ++i) {
    ShownPatch& patch = block.patches.emplace_back(one);
    patch.id = fmt::format("{}_90000", 8000 + i);
    for (int k = 0; k < 300; ++k) {
      ShownLine& copy = block.methods[0].lines.emplace_back(line);
      copy.patch = i;
      copy.segment_m.start += Eigen::Vector3d(i, k, 0);
    }
  }
  return block;
}

TEST(BlockReport, OfAThousandPatchesIsBelow20Megabytes) {
  constexpr std::size_t kMaxPage_bytes = 20'000'000;
  BlockCloud cloud;
  for (int i = 0; i < 1'000'000; ++i) cloud.x_m.emplace_back(i % 1000, i / 1000, i % 7);
  const Json data = block_json(large_block(), cloud, std::nullopt);
  EXPECT_EQ(data["methods"][0]["lines"]["n_shown"], kMaxPlanLines);
  EXPECT_EQ(data["points"]["n_shown"], kMaxPlanPoints);
  EXPECT_LT(report_page("t", data.dump(), block_front_end()).size(), kMaxPage_bytes);
}

}  // namespace
}  // namespace ridgeline::apps
