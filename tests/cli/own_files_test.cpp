// SPDX-License-Identifier: BSD-3-Clause
// What becomes of files that exist where results are to be written: nothing of the user is lost.
#include "tests/cli/cli_fixture.h"

#include <sqlite3.h>

#include <algorithm>
#include <string>
#include <utility>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// Files that options name.
class SingleFiles : public SmallPatch {
 protected:
  /// Expects that the command writes its output `file` over another one only if it is told to.
  void expect_replaced_only_if_told(std::vector<std::string> arguments,
                                    const std::string& file) const {
    SCOPED_TRACE(file);
    write(path(file), "mine");
    EXPECT_REFUSED(run(arguments), HasSubstr(file + ": already exists; --overwrite replaces it"));
    EXPECT_EQ(read(path(file)), "mine");
    arguments.emplace_back("--overwrite");
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(read(path(file)), "mine");
    fs::remove(path(file));
  }
};

TEST_F(SingleFiles, OfGate) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "results", {"--no-report"}).exit_code, 0);
  write(path("gates.yaml"), "gates: [{metric: rms_m, class: total, max: 10}]\n");
  for (const char* option : {"--junit", "--summary", "--json"})
    expect_replaced_only_if_told({"gate", "results", "--gates", "gates.yaml", option, "f"}, "f");
}

TEST_F(SingleFiles, OfExtractAndMatch) {
  const std::vector<std::string> extract{"extract", "patch/left.tif", "--out",
                                         "s.csv",   "--overlay",      "s.png"};
  const std::vector<std::string> match{
      "match", "patch/patch.yaml", "--out", "m.csv",        "--matcher",
      "chio",  "--segments",       "seen",  "--provenance", "p.csv"};
  for (const char* file : {"s.csv", "s.png"}) {
    expect_replaced_only_if_told(extract, file);
    for (const char* other : {"s.csv", "s.png"}) fs::remove(path(other));
  }
  for (const char* file : {"m.csv", "p.csv", "seen/segments.left.csv"}) {
    expect_replaced_only_if_told(match, file);
    for (const char* other : {"m.csv", "p.csv"}) fs::remove(path(other));
    fs::remove_all(path("seen"));
  }
}

TEST_F(SingleFiles, OfReconstruct) {
  ASSERT_EQ(run({"match", "patch/patch.yaml", "--out", "m.csv"}).exit_code, 0);
  const std::vector<std::string> command{
      "reconstruct", "patch/patch.yaml", "--matches", "m.csv", "--out", "l.dxf"};
  expect_replaced_only_if_told(command, "l.dxf");
  std::vector<std::string> with_surface = command;
  with_surface.insert(with_surface.end(), {"--write-surface", "surface.las"});
  expect_replaced_only_if_told(with_surface, "surface.las");
}

TEST_F(SingleFiles, OfEvaluate) {
  const std::vector<std::string> command{"evaluate",  "--lines",         "scene/lines.good.geojson",
                                         "--cloud",   "scene/lidar.las", "--out",
                                         "out",       "--no-report",     "--write-points",
                                         "points.pcd"};
  expect_replaced_only_if_told(command, "points.pcd");
}

TEST_F(SingleFiles, LinksAreReplacedOnlyIfToldAndTheirFileStays) {
  write(path("mine.csv"), "mine");
  fs::create_symlink("mine.csv", path("s.csv"));
  EXPECT_REFUSED(run({"extract", "patch/left.tif", "--out", "s.csv"}),
                 HasSubstr("s.csv: already exists"));
  EXPECT_EQ(run({"extract", "patch/left.tif", "--out", "s.csv", "--overwrite"}).exit_code, 0);
  EXPECT_EQ(read(path("mine.csv")), "mine");
}

TEST_F(SingleFiles, FormatOfLinesIsThatOfTheEnding) {
  ASSERT_EQ(run({"match", "patch/patch.yaml", "--out", "m.csv"}).exit_code, 0);
  const auto reconstruct = [this](const std::string& out, const std::string& format = "") {
    std::vector<std::string> words{
        "reconstruct", "patch/patch.yaml", "--matches", "m.csv", "--out", out};
    if (!format.empty()) words.insert(words.end(), {"--format", format});
    return run(words);
  };
  for (const auto& [file, beginning] :
       {std::pair("l.dxf", "  0\nSECTION"), std::pair("l.GeoJSON", "{\"type\":\"FeatureCollection"),
        std::pair("l.json", "{\"type\":\"FeatureCollection"), std::pair("l", "{\"type\":"),
        std::pair("l.wkt.csv", "wkt,"), std::pair("l.csv", "x1,y1,z1"),
        std::pair("l.ply", "ply\n")}) {
    ASSERT_EQ(reconstruct(file).exit_code, 0) << file;
    EXPECT_THAT(read(path(file)), testing::StartsWith(beginning)) << file;
  }
  EXPECT_EQ(reconstruct("l.lines", "dxf").exit_code, 0);
  EXPECT_REFUSED(reconstruct("l.dwg"), HasSubstr("--out = l.dwg: no known format has"));
  EXPECT_REFUSED(reconstruct("m.dxf", "csv"), HasSubstr("--format csv: m.dxf has the extension"));
}

/// Folders of results.
class OwnFolders : public SmallPatch {
 protected:
  [[nodiscard]] ProgramResult judge(std::vector<std::string> more = {"--no-report"}) const {
    return evaluate("scene/lines.good.geojson", "out", std::move(more));
  }
  /// The names that run.json lists.
  [[nodiscard]] std::vector<std::string> listed() const {
    std::vector<std::string> names;
    const nlohmann::json record = read_json(path("out/run.json"));
    for (const auto& file : record["files"]) names.push_back(file["path"]);
    return names;
  }
  /// All files of the folder but run.json, as the list names them.
  [[nodiscard]] std::vector<std::string> present() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(path("out"))) {
      const std::string name = fs::relative(entry.path(), path("out")).string();
      if (entry.is_regular_file() && name != "run.json") names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
  }
};

TEST_F(OwnFolders, AllFilesAreListedAndReplacedByTheNextRun) {
  for (int i = 0; i < 2; ++i) {
    const ProgramResult result = judge({});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(listed(), present());
    EXPECT_THAT(listed(), AllOf(Contains("report.html"), Contains("table2.csv")));
    EXPECT_EQ(run({"report", "out"}).exit_code, 0);
    EXPECT_EQ(listed(), present());
  }
}

TEST_F(OwnFolders, FilesOfRunAreListedToo) {
  for (int i = 0; i < 2; ++i) {
    const ProgramResult result = run({"run", "patch/patch.yaml", "--out", "out"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(listed(), present());
  }
}

TEST_F(OwnFolders, FilesOfTheUserAreNeitherReplacedNorRemoved) {
  for (const char* name :
       {"table2.csv", "evaluation.lines.good.json", "reference.md", "run.json"}) {
    write(path("out") / name, "mine");
    EXPECT_REFUSED(judge(), AllOf(HasSubstr(std::string("out/") + name),
                                  HasSubstr("was not written by ridgeline or has changed since")));
    EXPECT_EQ(present().size() + 1, std::string(name) == "run.json" ? 1U : 2U);
    EXPECT_EQ(read(path("out") / name), "mine");
    fs::remove(path("out") / name);
  }
  write(path("out/run.json"), R"({"command": "make", "files": ["all"]})");
  EXPECT_REFUSED(judge(), HasSubstr("out/run.json: was not written by ridgeline"));
  fs::remove(path("out/run.json"));
  write(path("out/report.html"), "mine");
  EXPECT_EQ(judge().exit_code, 0);
  EXPECT_EQ(read(path("out/report.html")), "mine");
  EXPECT_THAT(judge({}).err, HasSubstr("report.html: was not written by ridgeline"));
  EXPECT_REFUSED(run({"report", "out"}), HasSubstr("out/report.html: was not written"));
  EXPECT_EQ(read(path("out/report.html")), "mine");
}

TEST_F(OwnFolders, ChangedFilesAreTheUsers) {
  ASSERT_EQ(judge({}).exit_code, 0);
  for (const char* name : {"table2.csv", "judged.lines.good.gpkg"}) {
    const std::string before = read(path("out") / name);
    write(path("out") / name, before + " ");
    EXPECT_REFUSED(judge(), HasSubstr(std::string("out/") + name));
    EXPECT_EQ(read(path("out") / name), before + " ");
    write(path("out") / name, before);
  }
  write(path("out/report.html"), "mine");
  EXPECT_EQ(judge().exit_code, 0);
  EXPECT_EQ(read(path("out/report.html")), "mine");
}

TEST_F(OwnFolders, OfOlderVersionsAreLeftAlone) {
  ASSERT_EQ(judge().exit_code, 0);
  nlohmann::json record = read_json(path("out/run.json"));
  record.erase("files");
  write(path("out/run.json"), record.dump());
  EXPECT_REFUSED(judge(), HasSubstr("is in a folder written by an older version"));
  EXPECT_EQ(read(path("out/run.json")), record.dump());
}

TEST_F(OwnFolders, LinksAreTheUsers) {
  write(path("mine.txt"), "mine");
  fs::create_directory(path("out"));
  fs::create_symlink("../mine.txt", path("out/table2.csv"));
  EXPECT_REFUSED(judge(), HasSubstr("out/table2.csv"));
  EXPECT_TRUE(fs::is_symlink(path("out/table2.csv")));
}

TEST_F(OwnFolders, AMapThatQgisHasOpenedIsReplaced) {
  ASSERT_EQ(judge().exit_code, 0);
  const std::string map = path("out/judged.lines.good.gpkg").string();
  const std::string before = read(map);
  sqlite3* base = nullptr;
  ASSERT_EQ(sqlite3_open(map.c_str(), &base), SQLITE_OK);
  for (const char* mode : {"pragma journal_mode=wal", "pragma journal_mode=delete"})
    ASSERT_EQ(sqlite3_exec(base, mode, nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(base);
  EXPECT_NE(read(map), before);
  EXPECT_EQ(judge().exit_code, 0);

  // changes that QGIS has saved and still keeps beside the map
  ASSERT_EQ(sqlite3_open(map.c_str(), &base), SQLITE_OK);
  for (const char* edit :
       {"pragma journal_mode=wal", "update gpkg_contents set description = 'mine'"})
    ASSERT_EQ(sqlite3_exec(base, edit, nullptr, nullptr, nullptr), SQLITE_OK) << edit;
  EXPECT_REFUSED(judge(), HasSubstr("out/judged.lines.good.gpkg"));
  sqlite3_close(base);
  EXPECT_REFUSED(judge(), HasSubstr("out/judged.lines.good.gpkg"));  // they are in it now
}

TEST_F(OwnFolders, AfterAFailedRunTheNextOneGoesOn) {
  ASSERT_EQ(judge().exit_code, 0);
  // as a killed run leaves it: the list is where the lock was, and the end of its last line is lost
  std::string notes = "process 4194305 on here\n";
  const nlohmann::json record = read_json(path("out/run.json"));
  for (const auto& file : record["files"]) notes += file.dump() + "\n";
  fs::remove(path("out/run.json"));
  const std::string table = read(path("out/table2.csv"));
  write(path("out/.ridgeline.lock"), notes + "{\"path\": \"tab");
  write(path("out/table2.csv"), "mine");  // edited after the kill
  EXPECT_REFUSED(judge(), HasSubstr("out/table2.csv"));
  EXPECT_TRUE(fs::exists(path("out/.ridgeline.lock")));  // keeps the list of what is ours
  write(path("out/table2.csv"), table);
  EXPECT_EQ(judge().exit_code, 0);
  EXPECT_FALSE(fs::exists(path("out/.ridgeline.lock")));
  EXPECT_EQ(listed(), present());
}

TEST_F(OwnFolders, ComparisonsAreReplacedAndOtherFilesAreNot) {
  ASSERT_EQ(judge().exit_code, 0);
  const std::vector<std::string> compare{"compare", "out", "out", "--out", "compared"};
  for (int i = 0; i < 2; ++i) EXPECT_EQ(run(compare).exit_code, 0);
  write(path("compared/compare.md"), "mine");
  EXPECT_REFUSED(run(compare), HasSubstr("compared/compare.md"));
}

}  // namespace
}  // namespace ridgeline::cli
