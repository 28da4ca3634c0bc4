// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/png_writer.h"
#include "tests/cli/cli_fixture.h"
#include "tests/support/paths.h"

#include <opencv2/core.hpp>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Info : public Cli {
 protected:
  /// Writes a file and asks what it holds.
  [[nodiscard]] ProgramResult info(const std::string& name, const std::string& content) const {
    write(path(name), content);
    return run({"info", name});
  }
};

std::string oriented(const std::string& name) {
  return test::source_dir() + "/tests/io/orientation/fixtures/" + name;
}

#define EXPECT_TOLD(result, matcher)                      \
  do {                                                    \
    const ::ridgeline::cli::ProgramResult& r_ = (result); \
    EXPECT_EQ(r_.exit_code, 0) << r_.err;                 \
    EXPECT_THAT(r_.out, matcher);                         \
  } while (false)

TEST_F(Info, TellsTheCloudsPointsClassesDensityAndCrs) {
  EXPECT_TOLD(run({"info", "scene/lidar.las"}),
              AllOf(HasSubstr("LAS 1.4, point format 6"), HasSubstr("points "),
                    HasSubstr("bounds      x 513000."), HasSubstr("points/m2"), HasSubstr("2: "),
                    HasSubstr("ETRS89 / UTM zone 32N"), HasSubstr("metre (1 m)")));
}

TEST_F(Info, TellsTheLinesOfSeveralFiles) {
  EXPECT_TOLD(run({"info", "scene/lines.good.geojson", "scene/truth.geojson"}),
              AllOf(HasSubstr("scene/lines.good.geojson: GeoJSON"), HasSubstr("total length "),
                    HasSubstr("scene/truth.geojson: GeoJSON"), HasSubstr("epipolar_angle_deg")));
}

TEST_F(Info, ReadsEveryTextFormatOfLines) {
  EXPECT_TOLD(info("a.csv", "id,x1,y1,z1,x2,y2,z2\n0,1,2,3,4,6,3\n"),
              HasSubstr("lines       1, total length 5.0 m"));
  EXPECT_TOLD(info("a.wkt", "LINESTRING Z (1 2 3, 4 6 3)\n"), HasSubstr("1, total length 5.0 m"));
  EXPECT_TOLD(info("a.obj", "v 1 2 3\nv 4 6 3\nl 1 2\n"), HasSubstr("1, total length 5.0 m"));
  EXPECT_TOLD(info("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
                   "property double z\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
                   "end_header\n1 2 3\n4 6 3\n0 1\n"),
              HasSubstr("1, total length 5.0 m"));
}

TEST_F(Info, ReadsEveryTextFormatOfClouds) {
  EXPECT_TOLD(info("a.xyz", "1 2 3\n4 6 3\n"), HasSubstr("points      2"));
  EXPECT_TOLD(info("a.pts", "2\n1 2 3 90\n4 6 3 90\n"), HasSubstr("points      2"));
  EXPECT_TOLD(info("a.csv", "\"X\";\"Y\";\"Z\"\n1,5;2;3\n4;6;3\n"), HasSubstr("x 1.500 .. 4.000"));
  EXPECT_TOLD(info("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
                   "property double z\nend_header\n1 2 3\n4 6 3\n"),
              HasSubstr("points      2"));
  EXPECT_TOLD(info("a.pcd",
                   "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\n"
                   "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n1 2 3\n4 6 3\n"),
              HasSubstr("points      2"));
}

TEST_F(Info, TellsThePatchWithItsProjectionCentres) {
  EXPECT_TOLD(
      info("patch.yaml",
           "id: north\ncrs: EPSG:25832\nheight_range: [240, 270]\nlidar: [lidar.las]\nimages:\n"
           "  - {id: left, path: l.tif, projection_matrix: "
           "[[1000, 0, 0, -513000000], [0, 1000, 0, -5403000000], [0, 0, -1, 800]]}\n"
           "  - {id: right, path: r.tif, projection_matrix: "
           "[[1000, 0, 0, -513050000], [0, 1000, 0, -5403000000], [0, 0, -1, 800]]}\n"),
      AllOf(HasSubstr("patch north"), HasSubstr("240 .. 270 m"), HasSubstr("image       left"),
            HasSubstr("projection centre 513050.000 5403000.000 800.000"),
            HasSubstr("UTM zone 32N"), HasSubstr("warning     lidar.las does not exist")));
}

TEST_F(Info, TellsTheSizeAndBandsOfAnImage) {
  io::write_png(path("grey.png").string(), cv::Mat(30, 40, CV_8UC1, cv::Scalar(70)));
  const ProgramResult result = run({"info", "grey.png"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("grey.png: PNG"), HasSubstr("size        40 x 30 px"),
                                HasSubstr("bands       1 of 8 bit")));
}

TEST_F(Info, TellsTheResultsAndWhatTakesThem) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out").exit_code, 0);
  EXPECT_TOLD(
      run({"info", "out"}),
      AllOf(HasSubstr("out: results of ridgeline evaluate"), HasSubstr("line files  lines.good"),
            HasSubstr("of them judged"), HasSubstr("ridgeline compare out; open out/report.html")));
  EXPECT_TOLD(run({"info", "out/evaluation.lines.good.json"}),
              AllOf(HasSubstr("evaluation of lines"), HasSubstr("method      lines.good")));
  EXPECT_TOLD(run({"info", "out/report.html"}), HasSubstr("open it in a browser"));
  EXPECT_TOLD(run({"info", "out/run.json"}), HasSubstr("record of a run"));
  EXPECT_TOLD(run({"info", "out/table2.csv"}), HasSubstr("table of results\n  rows        "));
}

TEST_F(Info, TellsWhatTheProgramItselfPrints) {
  const ProgramResult gates = run({"gate", "--init"});
  EXPECT_TOLD(info("g.txt", gates.out), AllOf(HasSubstr("g.txt: gates file\n  gates       2\n"),
                                              HasSubstr("ridgeline gate RESULTS --gates g.txt")));
  const ProgramResult config = run({"config"});
  EXPECT_TOLD(info("c.yaml", config.out), AllOf(HasSubstr("c.yaml: config file"),
                                                HasSubstr("extract ("), HasSubstr("judge (")));
  EXPECT_TOLD(info("m.csv", "left_id,right_id,score,votes,matcher\n0,1,0.5,1,chio\n"),
              AllOf(HasSubstr("table of matches\n  rows        1"), HasSubstr("--matches")));
}

TEST_F(Info, NamesLineAndRuleOfItsOwnFiles) {
  EXPECT_REFUSED(info("g.yaml", "gates:\n  - {metrix: rms_m}\n"), HasSubstr("line 2"));
  EXPECT_REFUSED(info("c.yaml", "judge:\n  sead: 1\n"), HasSubstr("line 2: unknown key 'sead'"));
}

TEST_F(Info, TellsTheContentWhateverTheName) {
  fs::copy(path("scene/lidar.las"), path("cloud.json"));
  EXPECT_TOLD(run({"info", "cloud.json"}), HasSubstr("LAS 1.4"));
}

TEST_F(Info, TellsAFolderOfPatches) {
  fs::create_directories(path("all"));
  fs::copy(fs::path(test::source_dir()) / "sample_data/1", path("all/1"));
  EXPECT_TOLD(run({"info", "all/1"}),
              AllOf(HasSubstr("all/1/patch.yaml: patch 1"), HasSubstr("image       left"),
                    HasSubstr("use         ridgeline run all/1/patch.yaml --out results")));
  fs::copy(fs::path(test::source_dir()) / "sample_data/2", path("all/2"));
  EXPECT_TOLD(run({"info", "all"}), AllOf(HasSubstr("all: folder of 2 patches"),
                                          HasSubstr("patch       2: all/2/patch.yaml, 2 images")));
}

TEST_F(Info, ShowsEveryFileEvenIfOneCannotBeRead) {
  write(path("a.zip"), "PK\x03\x04");
  const ProgramResult result =
      run({"info", "missing.las", "scene/lidar.las", "a.zip", "scene/truth.geojson"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, AllOf(HasSubstr("scene/lidar.las: LAS 1.4"),
                                HasSubstr("scene/truth.geojson: GeoJSON")));
  EXPECT_THAT(result.err, AllOf(HasSubstr("missing.las: does not exist"),
                                HasSubstr("a.zip: is a ZIP archive")));
}

TEST_F(Info, SaysAWarningOfSeveralFilesOnce) {
  const char* const empty = R"({"type":"FeatureCollection","features":[]})";
  for (const char* name : {"a.geojson", "b.geojson", "c.geojson"}) write(path(name), empty);
  EXPECT_TOLD(run({"info", "a.geojson"}), HasSubstr("  warning     has no lines"));
  const ProgramResult several =
      run({"info", "a.geojson", "b.geojson", "scene/lidar.las", "c.geojson"});
  EXPECT_TOLD(several, HasSubstr("warning: a.geojson and 2 more files: has no lines"));
  EXPECT_EQ(several.out.find("has no lines"), several.out.rfind("has no lines"));
}

TEST_F(Info, TellsABlockByItsFolder) {
  write(path("flight/block.yaml"), "block: village\norientation: opk.csv\n");
  EXPECT_TOLD(run({"info", "flight"}), HasSubstr("ridgeline block flight/block.yaml --out"));
}

TEST_F(Info, TellsTheOrientationOfAProjectFolder) {
  fs::create_directories(path("project/opensfm"));
  fs::create_directories(path("project/images"));
  fs::copy(oriented("opensfm.json"), path("project/opensfm/reconstruction.json"));
  EXPECT_TOLD(run({"info", "project"}),
              AllOf(HasSubstr("project/opensfm/reconstruction.json: OpenSfM"),
                    HasSubstr("of them in project/images")));
}

TEST_F(Info, TellsTheOrientationOfRealProjectFolders) {
  for (const auto& [folder, told] :
       {std::pair("boruszyn", "boruszyn/colmap: COLMAP"), std::pair("orientations/pix4d", "Pix4D"),
        std::pair("drone_odm", "drone_odm: folder with 2 orientations")}) {
    const fs::path there = shared_data(folder);
    if (!fs::exists(there)) GTEST_SKIP() << there << " is not there";
    EXPECT_TOLD(run({"info", there.string()}), HasSubstr(told));
  }
}

TEST_F(Info, RefusesOtherKindsWithThoseThatItKnows) {
  EXPECT_REFUSED(info("a.zip", "PK\x03\x04"),
                 AllOf(HasSubstr("a.zip: is a ZIP archive, unpack it; supported are point clouds"),
                       HasSubstr("folders of patches, blocks, orientations and results")));
  EXPECT_REFUSED(info("a.unheard", "words"), HasSubstr("is of an unknown kind; supported are"));
  EXPECT_REFUSED(info("a.dat", ""), HasSubstr("is an empty file; supported are"));
  EXPECT_REFUSED(run({"info", "scene"}), HasSubstr("is a folder with 1 cloud and "));
}

TEST_F(Info, RefusesWhatItCannotReadByName) {
  for (const char* name :
       {"no.las", "no.txt", "no.yaml", "no.geojson", "no.pcd", "no.ply", "no.unknown", "no"}) {
    EXPECT_REFUSED(run({"info", name}), HasSubstr(std::string(name) + ": "));
  }
  EXPECT_REFUSED(info("words.txt", "neither cloud nor lines\n"), HasSubstr("words.txt"));
  EXPECT_REFUSED(run({"info", "scene"}), HasSubstr("scene: "));
  EXPECT_REFUSED(run({"info", "two\nlines.las"}), HasSubstr("two lines.las: "));
}

TEST_F(Info, BytesAtRandomAreRefusedByEveryReader) {
  std::string noise;
  for (unsigned i = 1; i <= 5000; ++i) noise += static_cast<char>((i * 2654435761U) >> 24U);
  for (const char* extension : {"las", "laz", "pcd", "ply", "xyz", "txt", "geojson", "json", "gpkg",
                                "shp", "dxf", "csv", "wkt", "yaml"}) {
    const std::string name = std::string("noise.") + extension;
    EXPECT_REFUSED(info(name, noise), HasSubstr(name));
  }
  // an OBJ may hold statements of any other tool
  EXPECT_TOLD(info("noise.obj", noise), HasSubstr("has no lines"));
}

TEST_F(Info, TellsAnOrientationAndDrawsItsPlan) {
  EXPECT_TOLD(
      run({"info", oriented("blocks_exchange_enu.xml"), "--map", "plan.gpkg"}),
      AllOf(HasSubstr("BlocksExchange\n"), HasSubstr("images      4, D:/flight 1/a b_1.tif"),
            HasSubstr("group 1: 1200 x 900 px, focal length 1300.00 px"),
            HasSubstr("crs         WGS 84 / UTM zone 32N"), HasSubstr("decided     Poses were"),
            HasSubstr("map         plan.gpkg, footprints at 10.")));
  EXPECT_TRUE(fs::exists(path("plan.gpkg")));
  EXPECT_TOLD(run({"info", oriented("opk_rad.csv"), "--angles", "rad", "--cameras",
                   oriented("cameras.yaml"), "--crs", "EPSG:25832"}),
              AllOf(HasSubstr("cam 1: 1200 x 900 px"), HasSubstr("ETRS89 / UTM zone 32N")));
}

TEST_F(Info, AsksForWhatAnOrientationLeavesOpen) {
  const ProgramResult open = run({"info", oriented("pat_b_camera_from_world.ori")});
  EXPECT_EQ(open.exit_code, 1);
  EXPECT_THAT(open.err, HasSubstr("give one of: matrix: world_from_camera"));
  const ProgramResult no_height =
      run({"info", oriented("metashape_utm.xml"), "--map", "plan.gpkg"});
  EXPECT_EQ(no_height.exit_code, 1);
  EXPECT_THAT(no_height.err, HasSubstr("give --ground-height"));
}

/// Images lie beside the tables: points in them tell degrees from gon.
TEST_F(Info, DecidesByTheImagesOfARealOrientation) {
  const fs::path folder = shared_data("orientations/ngi");
  if (!fs::exists(folder)) GTEST_SKIP() << "../shared/data/orientations/ngi is absent";
  EXPECT_TOLD(
      run({"info", (folder / "ngi_xyz_opk.csv").string(), "--cameras",
           (folder / "ngi_int_param.yaml").string()}),
      AllOf(HasSubstr("4 of them in"), HasSubstr("with angles in deg rays intersect within 0."),
            HasSubstr("crs         +proj=tmerc")));
}

}  // namespace
}  // namespace ridgeline::cli
