// SPDX-License-Identifier: BSD-3-Clause
// Frames of which only windows are read: by an area, or by windows that the patch states.
#include "io/images/image_writer.h"
#include "io/project/segments_file.h"
#include "reconstruct/scene/normalised_image.h"
#include "tests/cli/oriented_patch.h"

#include <opencv2/core.hpp>

#include <array>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The small patch, whose images serve as frames, with a table of orientations.
class Frames : public OrientedPatch {
 protected:
  [[nodiscard]] std::string frame_file(const std::string& id) const {
    return path("patch/" + id + ".tif").string();
  }

  /// The middle of the frame, three quarters of its sides.
  [[nodiscard]] io::Window window_of(const std::string& id) const {
    const io::ImageFacts facts = io::image_facts(frame_file(id));
    return {facts.width_px / 8 + 3, facts.height_px / 8 + 5, facts.width_px * 3 / 4,
            facts.height_px * 3 / 4};
  }

  /// The key `radiometry` of a frame.
  [[nodiscard]] std::string radiometry_of(const std::string& id) const {
    std::string text;
    for (const auto& [low, high] :
         reconstruct::band_ranges(io::read_picture(frame_file(id)).sample))
      text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", low, high);
    return "[" + text + "]";
  }

  void write_patch(const std::string& file,
                   const std::string& images,
                   const std::string& more = "height_range: auto") const {
    write(path("patch/" + file),
          fmt::format("id: '1'\nlidar: lidar.las\norientation: opk.csv\ncameras: cameras.yaml\n"
                      "crs: EPSG:25832\n{}\nimages: {}\n",
                      more, images));
  }

  [[nodiscard]] ProgramResult run_file(const std::string& file, const std::string& out) const {
    return run({"run", "patch/" + file, "--out", out, "--methods", "joint", "--no-report"});
  }

  /// Moves the frames to patch/frames.
  void move_frames() const {
    fs::create_directories(path("patch/frames"));
    for (const char* id : {"left", "right"})
      fs::rename(frame_file(id), path(fmt::format("patch/frames/{}.tif", id)));
  }

  /// The middle third of the plan of the village, as bounds.
  [[nodiscard]] std::string bounds() const {
    const nlohmann::json lines = read_json(path("patch/truth.geojson"))["features"];
    Eigen::AlignedBox2d box;
    for (const auto& line : lines) {
      for (const auto& x : line["geometry"]["coordinates"])
        box.extend(Eigen::Vector2d(x[0].get<double>(), x[1].get<double>()));
    }
    const Eigen::Vector2d third = box.sizes() / 3.0;
    return fmt::format("{:.1f},{:.1f},{:.1f},{:.1f}", box.min().x() + third.x(),
                       box.min().y() + third.y(), box.max().x() - third.x(),
                       box.max().y() - third.y());
  }
};

TEST_F(Frames, WindowGivesTheBytesOfAFileThatIsCutOut) {
  std::string windows;
  std::string cuts;
  for (const std::string id : {"left", "right"}) {
    const io::Window w = window_of(id);
    io::write_tiff(path("patch/cut_" + id + ".tif").string(),
                   io::read_picture(frame_file(id), {.window = w}).pixels);
    windows += fmt::format("\n  - {{path: {}.tif, window_px: [{}, {}, {}, {}]}}", id, w.column,
                           w.row, w.width, w.height);
    cuts += fmt::format(
        "\n  - {{id: {0}, path: cut_{0}.tif, name: {0}, window_px: [{1}, {2}], radiometry: {3}}}",
        id, w.column, w.row, radiometry_of(id));
  }
  const std::string heights = "height_range: [229, 280]";
  write_patch("windows.yaml", windows, heights);
  write_patch("cuts.yaml", cuts, heights);
  const ProgramResult by_window = run_file("windows.yaml", "by_window");
  ASSERT_EQ(by_window.exit_code, 0) << by_window.err;
  const ProgramResult by_cut = run_file("cuts.yaml", "by_cut");
  ASSERT_EQ(by_cut.exit_code, 0) << by_cut.err;
  for (const char* file :
       {"segments.left.csv", "matches.csv", "lines.joint.geojson", "evaluation.joint.json"}) {
    EXPECT_EQ(read(path(std::string("by_window/1/") + file)),
              read(path(std::string("by_cut/1/") + file)))
        << file;
  }
  EXPECT_GT(read_json(path("by_window/1/lines.joint.geojson"))["features"].size(), 5U);
  const nlohmann::json windows_px =
      read_json(path("by_window/run.json"))["windows_px"]["1"]["left"];
  const io::Window left = window_of("left");
  EXPECT_EQ(windows_px, nlohmann::json({left.column, left.row, left.width, left.height}));
  EXPECT_FALSE(read_json(path("by_cut/run.json")).contains("windows_px"));
}

TEST_F(Frames, PatchOfAnAreaIsWrittenAndRuns) {
  move_frames();
  fs::copy(path("patch/frames/left.tif"), path("patch/frames/öther ünknown.tif"));
  const ProgramResult made =
      run({"patch", "--init", "patch/roofs.yaml", "--orientation", "patch/opk.csv", "--cameras",
           "patch/cameras.yaml", "--images", "patch/frames", "--area", bounds(), "--lidar",
           "patch/lidar.las", "--crs", "EPSG:25832"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out,
              AllOf(HasSubstr("height_range: auto is "), HasSubstr("images of the area, 2 of 2: "),
                    HasSubstr("1 of 3 image files are not in the orientation")));
  EXPECT_THAT(read(path("patch/roofs.yaml")),
              AllOf(HasSubstr("orientation: \"opk.csv\""), HasSubstr("images: \"frames\"")));
  const ProgramResult result = run_file("roofs.yaml", "out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_GT(read_json(path("out/roofs/lines.joint.geojson"))["features"].size(), 3U);
  const nlohmann::json windows = read_json(path("out/run.json"))["windows_px"]["roofs"];
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_LT(windows["left"][2].get<int>(),
            io::image_facts(path("patch/frames/left.tif").string()).width_px);
  EXPECT_THAT(run({"info", "patch/roofs.yaml"}).out, HasSubstr(", window "));
  // A patch file that is there is kept.
  EXPECT_REFUSED(run({"patch", "--init", "patch/roofs.yaml", "--orientation", "patch/opk.csv",
                      "--images", "patch/frames", "--area", bounds(), "--height-range", "229,280"}),
                 HasSubstr("already exists"));
}

TEST_F(Frames, FaultsOfAnAreaAreSaidAndNothingIsWritten) {
  move_frames();
  const auto init = [&](const std::string& area, const std::string& more,
                        const std::string& value) {
    return run({"patch", "--init", "patch/new.yaml", "--orientation", "patch/opk.csv", "--cameras",
                "patch/cameras.yaml", "--images", "patch/frames", "--area", area, "--crs",
                "EPSG:25832", more, value});
  };
  EXPECT_REFUSED(init("1000,1000,1100,1100", "--height-range", "229,280"),
                 HasSubstr("area: only 0 of 2 images show it"));
  EXPECT_REFUSED(init("1000,1000,1100,1100", "--lidar", "patch/lidar.las"),
                 HasSubstr("no LIDAR point lies in the area"));
  EXPECT_REFUSED(init("1100,1000,1000,1100", "--height-range", "229,280"), HasSubstr("min <= max"));
  EXPECT_REFUSED(init("area.gpkg", "--height-range", "229,280"),
                 HasSubstr("area.gpkg: does not exist"));
  EXPECT_REFUSED(init(bounds(), "--max-views", "2"),
                 HasSubstr("--lidar, --surface-model or --height-range"));
  fs::remove(path("patch/frames/right.tif"));
  EXPECT_REFUSED(init(bounds(), "--height-range", "229,280"),
                 HasSubstr("at least two are required"));
  EXPECT_FALSE(fs::exists(path("patch/new.yaml")));
}

TEST_F(Frames, KeysThatDoNotGoTogetherAreRefused) {
  const std::string list = "\n  - path: left.tif\n  - path: right.tif";
  const auto refusal = [&](const std::string& images, const std::string& more) {
    write_patch("bad.yaml", images, more);
    return run({"run", "patch/bad.yaml", "--out", "bad", "--quiet"});
  };
  EXPECT_REFUSED(refusal(list, "height_range: low"),
                 HasSubstr("must be [lowest, highest] or auto"));
  EXPECT_REFUSED(refusal(list, "height_range: [229, 280]\nmax_views: 3"),
                 HasSubstr("max_views requires area"));
  EXPECT_REFUSED(refusal(list, "height_range: [229, 280]\nsurface_model: dsm.tif"),
                 HasSubstr("surface_model is only used"));
  EXPECT_REFUSED(refusal("none/*.tif", "height_range: [229, 280]"), HasSubstr("matches no file"));
  EXPECT_REFUSED(
      refusal("\n  - {path: left.tif, window_px: [0, 0, 90000, 10]}\n  - path: right.tif",
              "height_range: [229, 280]"),
      HasSubstr("do not contain the window"));
  EXPECT_REFUSED(refusal("\n  - {path: left.tif, radiometry: [[9, 3]]}\n  - path: right.tif",
                         "height_range: [229, 280]"),
                 HasSubstr("must be [low, high]"));
}

TEST_F(Frames, ExtractReadsAWindow) {
  const io::Window w = window_of("left");
  ASSERT_EQ(run({"extract", "patch/left.tif", "--out", "window.csv", "--window",
                 fmt::format("{},{},{},{}", w.column, w.row, w.width, w.height)})
                .exit_code,
            0);
  ASSERT_EQ(run({"extract", "patch/left.tif", "--out", "whole.csv"}).exit_code, 0);
  const std::vector<EdgeSegment> whole = io::read_segments(path("whole.csv").string());
  const Eigen::Vector2d corner(w.column, w.row);
  const auto is_in_whole = [&](const EdgeSegment& segment) {
    constexpr double kSame_px = 0.02;
    return std::ranges::any_of(whole, [&](const EdgeSegment& other) {
      return (segment.in_image.start + corner - other.in_image.start).norm() < kSame_px &&
             (segment.in_image.end + corner - other.in_image.end).norm() < kSame_px;
    });
  };
  constexpr double kBorder_px = 70.0;  // a block of noise at the border is cut
  int n = 0;
  int n_in_whole = 0;
  for (const EdgeSegment& segment : io::read_segments(path("window.csv").string())) {
    const Eigen::Vector2d x = midpoint(segment.in_image);
    if (x.minCoeff() < kBorder_px || x.x() > w.width - kBorder_px || x.y() > w.height - kBorder_px)
      continue;
    ++n;
    n_in_whole += is_in_whole(segment);
  }
  EXPECT_GT(n, 10);
  EXPECT_GT(n_in_whole, 0.8 * n);  // some run into the border
  EXPECT_REFUSED(run({"extract", "patch/left.tif", "--out", "x.csv", "--window", "0,0,99999,10"}),
                 HasSubstr("do not contain the window of 99999 x 10"));
}

}  // namespace
}  // namespace ridgeline::cli
