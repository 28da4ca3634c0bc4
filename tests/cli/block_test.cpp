// SPDX-License-Identifier: BSD-3-Clause
// A block of frames: plan, tasks, merge, in one call or step by step.
#include "io/files/csv_table.h"
#include "io/lines/read_lines.h"
#include "io/project/patch.h"
#include "reconstruct/geometry/segment.h"
#include "tests/cli/oriented_patch.h"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <sstream>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The small patch as a block of four squares.
class Block : public OrientedPatch {
 protected:
  Block() {
    fs::create_directories(path("patch/frames"));
    for (const char* id : {"left", "right"})
      fs::rename(path(fmt::format("patch/{}.tif", id)),
                 path(fmt::format("patch/frames/{}.tif", id)));
    write_block("block.yaml");
  }

  void write_block(const std::string& file,
                   const std::string& more = "patch_size_m: 20\noverlap_m: 8\n",
                   const std::string& images = "frames/*.tif") const {
    write(path("patch/" + file),
          fmt::format(
              "block: village\ncrs: EPSG:25832\norientation: opk.csv\ncameras: cameras.yaml\n"
              "images: {}\nlidar: [lidar.las]\nheight_range: auto\nreference_lines: truth.geojson\n"
              "area: {}\n{}",
              images, area(), more));
  }

  /// The box of the true lines, moved so that squares of 20 m cut it into four, with slivers of 4
  /// m.
  [[nodiscard]] std::string area() const { return "[513004, 5403004, 513044, 5403044]"; }

  [[nodiscard]] ProgramResult block(const std::string& out,
                                    const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"block", "patch/block.yaml", "--out", out, "--no-report"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  /// Lines have their midpoint in the area, and image segments where the whole frames show the
  /// lines.
  void expect_lines_of_the_area(const std::string& lines) const {
    constexpr double kNear_px = 3.0;       // a forgotten corner of a window is ten times that
    constexpr double kMinNearShare = 0.9;  // some segments are longer than their line
    const io::PatchFile patch = io::read_patch(path("patch/patch.yaml").string());
    std::size_t n = 0, n_near = 0;
    const Eigen::AlignedBox2d area_m(Eigen::Vector2d(513004, 5403004),
                                     Eigen::Vector2d(513044, 5403044));
    for (const io::Line& line : io::read_lines(path(lines).string()).lines) {
      EXPECT_FALSE(line.base_px);
      EXPECT_TRUE(area_m.contains(midpoint(line.segment_in_world).head<2>())) << line.id;
      for (const io::LineObservation& observation : line.observations) {
        const auto image = std::ranges::find(patch.images, observation.image, &io::PatchImage::id);
        ASSERT_NE(image, patch.images.end()) << observation.image;
        const Segment2 seen = project(image->image_from_world, line.segment_in_world);
        ++n;
        n_near += distance(seen, midpoint(observation.px)) < kNear_px ? 1 : 0;
      }
    }
    EXPECT_GT(n, 100U);
    EXPECT_GT(static_cast<double>(n_near), kMinNearShare * static_cast<double>(n)) << "of " << n;
  }

  /// True lines that a neighbour found count for the square that they belong to.
  void expect_true_lines_of_all_squares(const std::string& out) const {
    const auto sum_of = [&](const std::string& file, const char* column, const char* of) {
      const io::CsvTable table(path(out + "/" + file).string());
      double sum = 0.0;
      for (std::size_t row = 0; row < table.size(); ++row) {
        if (*of == '\0' || table.text(row, table.column("kind")) == of)
          sum += table.number(row, table.column(column));
      }
      return sum;
    };
    EXPECT_GT(sum_of("patches.csv", "n_reference_found", ""), 20.0);
    EXPECT_EQ(sum_of("patches.csv", "n_reference_found", ""),
              sum_of("reference_completeness.csv", "n_reconstructed", "all"));
  }

  /// The files of a block's folder that are results, with their content.
  [[nodiscard]] std::map<std::string, std::string> results(const std::string& out) const {
    std::map<std::string, std::string> files;
    for (const std::string& name : names_in(path(out))) {
      if (name == "tasks" || name == "run.json") continue;
      files[name] = read(path(out + "/" + name));
    }
    return files;
  }
};

TEST_F(Block, GivesTheSameBytesInOneCallAndStepByStep) {
  const ProgramResult whole = block("whole");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_THAT(whole.out, HasSubstr("village"));
  EXPECT_THAT(whole.err, HasSubstr("4 of 4: patch"));
  const auto expected = results("whole");
  for (const char* name : {"lines.lines.geojson", "lines.lines.gpkg", "judged.lines.gpkg",
                           "table2.csv", "evaluation.lines.json", "patches.csv", "plan.json"})
    EXPECT_EQ(expected.count(name), 1U) << name;
  EXPECT_THAT(expected.at("lines.lines.geojson"), HasSubstr("25650_270150/"));

  expect_lines_of_the_area("whole/lines.lines.geojson");
  expect_true_lines_of_all_squares("whole");

  ASSERT_EQ(block("steps", {"--plan"}).exit_code, 0);
  for (const char* task : {"4", "2-3", "1"})
    ASSERT_EQ(block("steps", {"--task", task, "--jobs", "1"}).exit_code, 0) << task;
  ASSERT_EQ(block("steps", {"--merge"}).exit_code, 0);
  EXPECT_EQ(results("steps"), expected);

  // A finished block is merged again, and no task runs.
  const auto written = fs::last_write_time(path("steps/tasks/25650_270150/run.json"));
  ASSERT_EQ(block("steps").exit_code, 0);
  EXPECT_EQ(fs::last_write_time(path("steps/tasks/25650_270150/run.json")), written);

  // A task whose lines are lost, and one whose end was cut off, run again.
  fs::remove(path("steps/tasks/25650_270150/25650_270150/lines.lines.geojson"));
  write(path("steps/tasks/25651_270150/stages.json"), "{\"key\"");
  const ProgramResult open = block("steps", {"--merge"});
  EXPECT_EQ(open.exit_code, 1);
  EXPECT_THAT(open.err,
              AllOf(HasSubstr("patch 25650_270150 has no lines"), HasSubstr("patch 25651_270150"),
                    HasSubstr("2 of 4 tasks have no results")));
  ASSERT_EQ(block("steps").exit_code, 0);
  EXPECT_EQ(results("steps"), expected);
}

TEST_F(Block, FolderIsReadAsThatOfOtherRuns) {
  ASSERT_EQ(block("out").exit_code, 0);
  write(path("gates.yaml"), "gates: [{metric: rms_m, class: total, max: 10}]\n");
  EXPECT_THAT(run({"gate", "out", "--gates", "gates.yaml"}).out, HasSubstr("passed"));
  EXPECT_THAT(run({"info", "out"}).out,
              AllOf(HasSubstr("results of ridgeline block"), HasSubstr("patches     village\n")));
  const ProgramResult compared = run({"compare", "out", "out"});
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_THAT(compared.out, AllOf(HasSubstr("village"), Not(HasSubstr("25650_270150"))));
  const ProgramResult report = run({"report", "out", "--gates", "gates.yaml"});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_THAT(read(path("out/report.html")), HasSubstr("\"gates\":{"));
}

TEST_F(Block, FailedTaskIsToldAndTheOthersGoOn) {
  ASSERT_EQ(block("out", {"--plan"}).exit_code, 0);
  const std::string right = read(path("patch/frames/right.tif"));
  fs::resize_file(path("patch/frames/right.tif"), right.size() / 2);
  const ProgramResult failed = block("out");
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_THAT(failed.err, AllOf(HasSubstr("right.tif: has changed since the block was planned"),
                                HasSubstr("4 of 4 tasks have no results")));
  EXPECT_THAT(read(path("out/patches.csv")),
              AllOf(HasSubstr(",failed,"), HasSubstr("has changed")));
  write(path("patch/frames/right.tif"), right);  // a new time alone is no change
  const ProgramResult mended = block("out");
  EXPECT_EQ(mended.exit_code, 0) << mended.err;
  EXPECT_THAT(read(path("out/patches.csv")), Not(HasSubstr(",failed,")));

  // Other options are another result: what is there does not count.
  const ProgramResult other = block("out", {"--merge", "--methods", "direct"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.err, HasSubstr("was run with other options"));
}

/// A table of poses (name,x,y,z,...) with all images higher.
std::string raised_by(double higher_m, const std::string& table) {
  std::istringstream rows(table);
  std::string raised, row;
  std::getline(rows, raised);
  while (std::getline(rows, row)) {
    const std::size_t z = row.find(',', row.find(',', row.find(',') + 1) + 1) + 1;
    const std::size_t end = row.find(',', z);
    raised += fmt::format("\n{}{}{}", row.substr(0, z),
                          std::stod(row.substr(z, end - z)) + higher_m, row.substr(end));
  }
  return raised + "\n";
}

TEST_F(Block, MendedPosesGiveTheLinesOfAFreshFolder) {
  const std::vector<std::string> direct{"--methods", "direct"};
  ASSERT_EQ(block("out", direct).exit_code, 0);
  write(path("patch/opk.csv"), raised_by(0.25, read(path("patch/opk.csv"))));
  EXPECT_REFUSED(block("out", {"--methods", "direct", "--merge"}),
                 HasSubstr("opk.csv: has changed since the block was planned"));
  fs::remove(path("out/plan.json"));
  ASSERT_EQ(block("out", direct).exit_code, 0);
  ASSERT_EQ(block("fresh", direct).exit_code, 0);
  EXPECT_EQ(results("out"), results("fresh"));
}

TEST_F(Block, WrongStepsAndFilesAreRefused) {
  EXPECT_REFUSED(block("out", {"--task", "1"}), HasSubstr("plan.json: there is no plan"));
  ASSERT_EQ(block("out", {"--plan"}).exit_code, 0);
  for (const char* task : {"0", "5", "3-2", "1-9", "a", "1.5"})
    EXPECT_REFUSED(block("out", {"--task", task}), HasSubstr("the tasks of this block are 1 to 4"));
  EXPECT_REFUSED(block("out", {"--task", "1", "--merge"}), HasSubstr("--merge"));

  fs::copy(path("patch/block.yaml"), path("patch/second.yaml"));
  EXPECT_REFUSED(run({"block", "patch/second.yaml", "--out", "out"}),
                 HasSubstr("a folder can only hold one block"));
  write_block("block.yaml", "patch_size_m: 50\n");
  EXPECT_REFUSED(block("out"),
                 AllOf(HasSubstr("block.yaml: has changed since the block was planned")));

  const auto refusal = [&](const std::string& more, const std::string& images = "frames/*.tif") {
    write_block("bad.yaml", more, images);
    return run({"block", "patch/bad.yaml", "--out", "bad"});
  };
  EXPECT_REFUSED(refusal("overlap_m: 60\n"), HasSubstr("overlap_m = 60, patch_size_m = 100"));
  EXPECT_REFUSED(refusal("patch_size_m: 0\n"), HasSubstr("patch_size_m = 0; must be"));
  EXPECT_REFUSED(refusal("patchsize: 7\n"), HasSubstr("patchsize"));
  EXPECT_REFUSED(refusal("", "[{path: frames/left.tif, window_px: [1, 2]}]"),
                 HasSubstr("window_px is only for patches"));
  EXPECT_FALSE(fs::exists(path("bad")));
  EXPECT_REFUSED(run({"run", "patch/block.yaml", "--out", "bad"}), HasSubstr("is a block file"));
  EXPECT_REFUSED(run({"block", "patch/oriented.yaml", "--out", "bad"}),
                 HasSubstr("is a patch file"));
}

/// Plans with a surface model in place of the LIDAR for the heights.
class BlockOfModel : public Block {
 protected:
  [[nodiscard]] ProgramResult plan(const std::string& model, const std::string& out) const {
    write(path("patch/dsm.asc"), model);
    std::string text = read(path("patch/block.yaml"));
    const std::string key = "height_range: auto\n";
    text.replace(text.find(key), key.size(), key + "surface_model: dsm.asc\n");
    write(path("patch/model.yaml"), text);
    return run({"block", "patch/model.yaml", "--out", out, "--plan"});
  }

  void expect_all_squares(const std::string& out) const {
    const nlohmann::json plan = read_json(path(out + "/plan.json"));
    ASSERT_EQ(plan["patches"].size(), 4U);
    for (const nlohmann::json& patch : plan["patches"]) {
      EXPECT_GT(patch["height_range_m"][0], 200.0);
      EXPECT_LT(patch["height_range_m"][1], 400.0);
    }
  }
};

/// Cells of 2 m around the area; those in the west have a value.
std::string model_with_west(const std::string& west) {
  std::string text = "ncols 60\nnrows 60\nxllcorner 512980\nyllcorner 5402980\ncellsize 2\n";
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 60; ++column) text += (column < 29 ? west : "255") + " ";
    text += "\n";
  }
  return text;
}

TEST_F(BlockOfModel, SquaresWithoutHeightsAreSearchedAtThoseOfTheBlockAndNamed) {
  const ProgramResult result = plan(model_with_west("-9999"), "out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("are below -500 m or above 9000 m"),
                                HasSubstr("2 of 4 squares (25650_270150, 25650_270151) have no "
                                          "heights and are searched at those of the whole block")));
  expect_all_squares("out");
}

TEST_F(BlockOfModel, ReportedSurfaceLosesNoSquares) {
  const fs::path folder = shared_data("reported_2/56-surface-without-nodata");
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const ProgramResult unstated = plan(read(folder / "dsm_unstated.asc"), "unstated");
  ASSERT_EQ(unstated.exit_code, 0) << unstated.err;
  EXPECT_THAT(unstated.err, HasSubstr("are below -500 m or above 9000 m"));
  expect_all_squares("unstated");
  const ProgramResult stated = plan(read(folder / "dsm_ok.asc"), "stated");
  ASSERT_EQ(stated.exit_code, 0) << stated.err;
  EXPECT_THAT(stated.err, AllOf(Not(HasSubstr("below -500 m")), HasSubstr("have no heights")));
  expect_all_squares("stated");
}

TEST_F(Block, SquaresOfTheAreaThatNoTwoFramesShowAreNamed) {
  std::string text = read(path("patch/block.yaml"));
  const std::string frames_show = "5403044]";
  text.replace(text.find(frames_show), frames_show.size(), "5403604]");
  write(path("patch/far.yaml"), text);
  const ProgramResult result = run({"block", "patch/far.yaml", "--out", "out", "--plan"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("of the area are shown by fewer than two images"));
}

/// A GeoJSON without `crs` whose coordinates are no degrees.
TEST_F(Block, AreaWithoutAReferenceSystemIsInThatOfTheBlock) {
  const fs::path folder = shared_data("reported_2/55-area-without-crs");
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  fs::copy(folder / "area.geojson", path("patch/area.geojson"));
  std::string text = read(path("patch/block.yaml"));
  text.replace(text.find(area()), area().size(), "area.geojson");
  write(path("patch/file.yaml"), text);
  const ProgramResult result = run({"block", "patch/file.yaml", "--out", "out", "--plan"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("area.geojson: states no reference system; assuming that of "
                                    "the block, ETRS89 / UTM zone 32N"));
}

}  // namespace
}  // namespace ridgeline::cli
