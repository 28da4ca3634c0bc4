// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/read_orientation.h"

#include "tests/io/orientation/fixture.h"
#include "tests/support/processor_time.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Files have 9 to 15 digits.
constexpr double kExact_px = 2e-5;
/// A rotation cannot take in how a map bends and stretches within a block of 100 m: 1e-5 of 600 px.
constexpr double kOnMap_px = 0.02;

OrientationOptions with_cameras(const std::string& file = "cameras.yaml") {
  OrientationOptions options;
  options.cameras = fixture::path_of(file);
  return options;
}

/// The images in the order of the fixture, by the last part of their names.
Orientation sorted(Orientation orientation) {
  const auto place = [](const OrientedImage& image) {
    return std::ranges::find(fixture::names(), file_name_of(image)) - fixture::names().begin();
  };
  std::ranges::sort(orientation.images, std::less(), place);
  return orientation;
}

void expect_fixture(const std::string& file,
                    const OrientationOptions& options = {},
                    const std::string& observations = "observations.csv",
                    double tolerance_px = kExact_px) {
  SCOPED_TRACE(file);
  const Orientation orientation = sorted(read_orientation(fixture::path_of(file), options));
  ASSERT_EQ(orientation.images.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(file_name_of(orientation.images[i]), fixture::names()[i]);
  }
  ASSERT_EQ(orientation.cameras.size(), 1U);
  EXPECT_EQ(orientation.cameras[0].interior.size_px, Eigen::Vector2i(1200, 900));
  EXPECT_LT(fixture::worst_px(orientation, fixture::observations(observations)), tolerance_px);
}

TEST(ReadOpkTable, SeesTheFixtureInEveryUnitThatTheTableStates) {
  expect_fixture("opk_deg.csv", with_cameras());
  expect_fixture("opk_gon.csv", with_cameras());
  expect_fixture("opk_deg.csv", with_cameras("cameras_mm.yaml"));
}

TEST(ReadOpkTable, TakesTheUnitThatTheUserStates) {
  OrientationOptions options = with_cameras();
  options.angles = AngleUnit::kRadian;
  expect_fixture("opk_rad.csv", options);
  options.angles = AngleUnit::kDegree;
  expect_fixture("opk_bare.txt", options);
}

TEST(ReadOpensfm, SeesTheFixtureOnTheMap) {
  expect_fixture("opensfm.json", {}, "observations_utm.csv", kOnMap_px);
  EXPECT_THAT(read_orientation(fixture::path_of("opensfm.json")).decisions,
              ElementsAre(HasSubstr("WGS 84 / UTM zone 32N")));
}

TEST(ReadPix4d, SeesTheFixture) {
  expect_fixture("block_calibrated_camera_parameters.txt");
  EXPECT_THAT(
      read_orientation(fixture::path_of("block_calibrated_camera_parameters.txt")).files_beside,
      ElementsAre(fixture::path_of("block_offset.xyz")));
}

TEST(ReadBlocksExchange, SeesTheFixtureByAllCameraAxes) {
  for (const char* axes : {"XRightYDown", "XRightYUp", "XLeftYDown", "XLeftYUp", "XDownYRight",
                           "XDownYLeft", "XUpYRight", "XUpYLeft"}) {
    expect_fixture(fmt::format("blocks_exchange_{}.xml", axes));
  }
  expect_fixture("blocks_exchange_angles.xml");
  const Orientation orientation = read_orientation(fixture::path_of("blocks_exchange_angles.xml"));
  EXPECT_EQ(orientation.crs.definition, "EPSG:25832");
  ASSERT_TRUE(orientation.ground_height_m.has_value());
  EXPECT_NEAR(*orientation.ground_height_m, 12.0,
              6.0);  // median depths of 100 m below images at 100 m, tilted
}

TEST(ReadBlocksExchange, ConvertsTopocentricAndGeocentricPosesToTheMap) {
  expect_fixture("blocks_exchange_enu.xml", {}, "observations_utm.csv", kOnMap_px);
  expect_fixture("blocks_exchange_geocentric.xml", {}, "observations_utm.csv", kOnMap_px);
  constexpr double kGround_m = 1e-3;  // digits of the file
  EXPECT_NEAR(
      read_orientation(fixture::path_of("blocks_exchange_geocentric.xml")).ground_height_m.value(),
      read_orientation(fixture::path_of("blocks_exchange_enu.xml")).ground_height_m.value(),
      kGround_m);
}

TEST(ReadMetashape, SeesTheFixtureInLocalAndGeocentricChunks) {
  expect_fixture("metashape_local.xml");
  expect_fixture("metashape_utm.xml", {}, "observations_utm.csv", kOnMap_px);
  EXPECT_THAT(read_orientation(fixture::path_of("metashape_local.xml")).warnings,
              ElementsAre("images without a pose, left out: 1 (not aligned.tif)",
                          HasSubstr("local coordinates")));
}

/// The fixture of Inpho has no distortion, as its sign is not stated; the observations have.
TEST(ReadInpho, SeesTheFixtureAlsoWithACameraBuiltInAcross) {
  for (const char* file : {"inpho.prj", "inpho_turned.prj"}) {
    Orientation orientation = read_orientation(fixture::path_of(file));
    ASSERT_EQ(orientation.cameras.size(), 1U);
    orientation.cameras[0].interior.distortion = fixture::kDistortion;
    EXPECT_LT(fixture::worst_px(orientation, fixture::observations()), kExact_px) << file;
    EXPECT_EQ(file_name_of(orientation.images[1]), fixture::names()[1]);
    EXPECT_EQ(orientation.ground_height_m, 6.0);
  }
}

TEST(ReadPatB, TakesTheDirectionThatTheUserStates) {
  OrientationOptions options = with_cameras();
  const auto worst_px = [&](const char* file) {
    const Orientation orientation = read_orientation(fixture::path_of(file), options);
    return fixture::worst_px(orientation, fixture::observations());
  };
  // positions have five digits, the matrix twelve
  constexpr double kRounded_px = 2e-4;
  options.matrix = MatrixDirection::kWorldFromCamera;
  EXPECT_LT(worst_px("pat_b_world_from_camera.ori"), kRounded_px);
  EXPECT_GT(worst_px("pat_b_camera_from_world.ori"), 100.0);
  options.matrix = MatrixDirection::kCameraFromWorld;
  EXPECT_LT(worst_px("pat_b_camera_from_world.ori"), kRounded_px);
}

std::vector<PointObservation> fixture_points(const Orientation& orientation) {
  std::vector<PointObservation> points;
  for (const fixture::Observation& one : fixture::observations()) {
    if (one.image < orientation.images.size()) points.push_back({one.point, one.image, one.x_px});
  }
  return points;
}

TEST(ReadOrientation, DecidesByRaysThatMeetWhatTheFileLeavesOpen) {
  OrientationOptions options = with_cameras();
  options.find_observations = fixture_points;
  for (const char* file : {"opk_rad.csv", "opk_bare.txt", "pat_b_world_from_camera.ori",
                           "pat_b_camera_from_world.ori"}) {
    const Orientation orientation = read_orientation(fixture::path_of(file), options);
    EXPECT_LT(fixture::worst_px(orientation, fixture::observations()), 2e-4) << file;
    EXPECT_THAT(orientation.decisions, ElementsAre(HasSubstr("rays intersect within"))) << file;
  }
}

TEST(ReadOrientation, NamesTheOptionsWhereNothingDecides) {
  const auto error_of = [&](const char* file) {
    return io_error_of([&] { read_orientation(fixture::path_of(file)); });
  };
  EXPECT_THAT(error_of("pat_b_camera_from_world.ori"),
              HasSubstr("give one of: matrix: world_from_camera | matrix: camera_from_world"));
  EXPECT_THAT(error_of("opk_rad.csv"),
              HasSubstr("give one of: angles: deg | angles: gon | angles: rad"));
}

/// The fixture's table with other names of columns, in the order of the fixture's columns.
double worst_px_of_table(const std::string& header, const std::string& more_columns = "") {
  std::ifstream stream(fixture::path_of("opk_deg.csv"));
  std::string text = header + "\n";
  std::string row;
  std::getline(stream, row);
  while (std::getline(stream, row)) text += row.substr(0, row.rfind(',')) + more_columns + "\n";
  const TempFolder folder;
  OrientationOptions options = with_cameras();
  options.angles = AngleUnit::kDegree;
  const Orientation orientation = read_orientation(folder.write("a.txt", text), options);
  return fixture::worst_px(orientation, fixture::observations());
}

TEST(ReadOpkTable, KnowsTheHeadersOfOtherWriters) {
  EXPECT_LT(worst_px_of_table("# Cameras (4)\n#PhotoID, X, Y, Z, Omega, Phi, Kappa, r11, r12",
                              ",0.1,0.2"),
            kExact_px);
  EXPECT_LT(worst_px_of_table("imageName,X,Y,Z,Omega,Phi,Kappa"), kExact_px);
  EXPECT_LT(worst_px_of_table("ID,EASTING,NORTHING,ELEVATION,OMEGA,PHI,KAPPA"), kExact_px);
  EXPECT_LT(
      worst_px_of_table("\"Label\",\"X/Easting\",\"Y/Northing\",\"Z/Altitude\",Omega,Phi,Kappa"),
      kExact_px);
}

TEST(ReadOpkTable, TakesTheSystemOfAComment) {
  const TempFolder folder;
  const std::string file = folder.write("a.txt",
                                        "# CoordinateSystem: EPSG:25832\n#Label X Y Z Omega[deg] "
                                        "Phi Kappa\na 513000 5403000 3 4 5 6\n");
  EXPECT_EQ(read_orientation(file).crs.definition, "EPSG:25832");
}

std::string error_of_text(const std::string& name, const std::string& text) {
  const TempFolder folder;
  return io_error_of([&] { read_orientation(folder.write(name, text)); });
}

std::string text_of_fixture(const std::string& name) {
  std::ifstream stream(fixture::path_of(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string replaced(std::string text, const std::string& old, const std::string& with) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), with);
}

struct Variant {
  const char* file;
  std::vector<std::pair<std::string, std::string>> replacements;
};

/// What other versions and programs write in place of parts of the fixture.
TEST(ReadOrientation, ReadsWhatOtherWritersWrite) {
  const std::vector<Variant> variants{
      {"blocks_exchange_XRightYDown.xml",
       {{"<SensorSize>36</SensorSize>", "<FocalLengthPixels>1300</FocalLengthPixels>"},
        {"<CameraOrientation>XRightYDown</CameraOrientation>", ""}}},
      {"metashape_local.xml",
       {{"<components next_id=\"1\" active_id=\"0\"><component id=\"0\" label=\"Component 1\">",
         ""},
        {"</component></components>", ""}}},
      {"block_calibrated_camera_parameters.txt", {}}};
  for (const Variant& variant : variants) {
    std::string text = text_of_fixture(variant.file);
    for (const auto& [old, with] : variant.replacements) text = replaced(text, old, with);
    const TempFolder folder;
    (void)folder.write("block_offset.xyz", text_of_fixture("block_offset.xyz"));
    const Orientation orientation = read_orientation(folder.write(variant.file, text));
    EXPECT_LT(fixture::worst_px(orientation, fixture::observations()), kExact_px) << variant.file;
  }
}

TEST(ReadInpho, TakesCamerasOfOlderProjects) {
  const TempFolder folder;
  const std::string text =
      replaced(text_of_fixture("inpho.prj"), "$CAMERA_DEFINITION\n  $ID", "$CAMERA\n  $TYPE");
  Orientation orientation = read_orientation(folder.write("a.prj", text));
  orientation.cameras.at(0).interior.distortion = fixture::kDistortion;
  EXPECT_LT(fixture::worst_px(orientation, fixture::observations()), kExact_px);
}

TEST(ReadOrientation, RefusesFisheyeByName) {
  EXPECT_THAT(error_of_text("a.xml", replaced(text_of_fixture("blocks_exchange_XRightYUp.xml"),
                                              ">Perspective<", ">Fisheye<")),
              HasSubstr("CameraModelType Fisheye; only Perspective is supported"));
  EXPECT_THAT(error_of_text("a.xml", replaced(text_of_fixture("metashape_local.xml"),
                                              "type=\"frame\"", "type=\"fisheye\"")),
              HasSubstr("type fisheye; only frame is supported"));
  EXPECT_THAT(error_of_text("a.json",
                            replaced(text_of_fixture("opensfm.json"), "\"brown\"", "\"fisheye\"")),
              HasSubstr("camera cam 1 is of type 'fisheye'"));
  const TempFolder folder;
  OrientationOptions options;
  options.cameras = folder.write("c.yaml", "cam 1:\n  type: fisheye\n  k4: 1\n");
  EXPECT_THAT(io_error_of([&] { read_orientation(fixture::path_of("opk_deg.csv"), options); }),
              HasSubstr("line 2: camera type fisheye"));
}

TEST(ReadOrientation, RefusesWhatBrownsModelLacksUnlessItIsTooSmallToSee) {
  const std::string metashape = text_of_fixture("metashape_local.xml");
  const auto with = [&](const char* element) {
    return replaced(metashape, "</k3>", fmt::format("</k3>{}", element));
  };
  EXPECT_THAT(error_of_text("a.xml", with("<k4>0.05</k4>")), HasSubstr("k4 moves pixels by"));
  EXPECT_THAT(error_of_text("a.xml", with("<b2>0.31</b2>")), HasSubstr("b2 moves pixels by"));
  EXPECT_THAT(error_of_text("a.xml", with("<p3>9</p3>")), HasSubstr("p3 moves pixels by"));
  EXPECT_THAT(error_of_text("a.xml", with("<k4>1e-6</k4><b2>0.01</b2>")), IsEmpty());
  EXPECT_THAT(
      error_of_text("a.prj", replaced(text_of_fixture("inpho.prj"), "    $FOCAL_LENGTH : 7",
                                      "    $RADIAL_COEFFS :\n 0 -1e-5 0 0\n    $FOCAL_LENGTH : 7")),
      HasSubstr("$RADIAL_COEFFS moves pixels by"));
}

TEST(ReadOrientation, RefusesTwoImagesOfOneName) {
  const std::map<std::string, std::string> files{
      {"opk_deg.csv", "3.tif,"},          {"blocks_exchange_enu.xml", "3.tif<"},
      {"metashape_local.xml", "3.tif\""}, {"opensfm.json", "3.tif\""},
      {"inpho.prj", "3.tif\n"},           {"block_calibrated_camera_parameters.txt", "3.tif "}};
  for (const auto& [file, name] : files) {
    const std::string twice =
        replaced(text_of_fixture(file), name, std::string("a b_1.tif") + name.back());
    EXPECT_THAT(error_of_text(file, twice),
                ::testing::AnyOf(HasSubstr("two images are named"), HasSubstr("a b_1.tif\" twice")))
        << file;
  }
}

TEST(ReadOrientation, SaysOfEveryTruncationThatSomethingIsMissing) {
  for (const char* file : {"opensfm.json", "blocks_exchange_enu.xml", "metashape_utm.xml"}) {
    const std::string whole = text_of_fixture(file);
    for (std::size_t size = 0; size + 2 < whole.size(); size += 97) {
      EXPECT_THAT(error_of_text(file, whole.substr(0, size)), ::testing::Not(IsEmpty()))
          << file << " " << size;
    }
  }
}

/// Tables, and blocks whose end is that of the file, may be cut between two images; within one it
/// is an error.
TEST(ReadOrientation, ReadsNoImageThatIsCutOff) {
  for (const char* file : {"inpho.prj", "block_calibrated_camera_parameters.txt", "opk_deg.csv"}) {
    const std::string whole = text_of_fixture(file);
    const TempFolder folder;
    for (std::size_t size = 0; size < whole.size(); size += 53) {
      const std::string path = folder.write(file, whole.substr(0, size));
      try {
        for (const OrientedImage& image : read_orientation(path).images) {
          EXPECT_NE(std::ranges::find(fixture::names(), file_name_of(image)),
                    fixture::names().end());
        }
      } catch (const IoError& error) {
        EXPECT_THAT(error.what(), ::testing::Not(HasSubstr("\n")));
      }
    }
  }
}

TEST(ReadOpkTable, RefusesRowsWithTooFewFields) {
  EXPECT_THAT(error_of_text("a.txt", "a 1 2 3 4 5 6\nb 1 2 3 4 5\n"),
              HasSubstr("a.txt:2: 6 fields"));
  EXPECT_THAT(error_of_text("a.txt", "name,x,y,z,omega,phi,kappa,camera\na,1,2,3,4,5\n"),
              HasSubstr("a.txt:2: 6 fields; name, x, y, z, omega, phi and kappa are needed in 8"));
}

TEST(ReadOrientation, RefusesWhatIsNoOrientation) {
  EXPECT_THAT(error_of_text("a.prj", ""), HasSubstr("is empty"));
  EXPECT_THAT(error_of_text("a.opk", "nothing here\n"),
              HasSubstr("is not a supported orientation"));
  EXPECT_THAT(error_of_text("a.yaml", "id: 1\nimages: []\n"), HasSubstr("is a patch file, not"));
  EXPECT_THAT(error_of_text("a.csv", "filename lat lon alt roll pitch yaw\na 1 2 3 4 5 6\n"),
              HasSubstr("roll, pitch and yaw are angles of the aircraft"));
  EXPECT_THAT(io_error_of([] { read_orientation("/none/a.prj"); }), HasSubstr("no such file"));
}

/// A hole of 10 GB behind a good beginning.
TEST(ReadOrientation, RefusesHugeFilesAtOnce) {
  constexpr std::uintmax_t kHuge_bytes = 10'000'000'000U;
  const TempFolder folder;
  const double start_s = test::processor_s();
  for (const char* file :
       {"opensfm.json", "blocks_exchange_enu.xml", "metashape_utm.xml", "inpho.prj",
        "pat_b_camera_from_world.ori", "opk_deg.csv", "block_calibrated_camera_parameters.txt"}) {
    const std::string path = folder.write(file, text_of_fixture(file));
    std::filesystem::resize_file(path, kHuge_bytes);
    EXPECT_THAT(io_error_of([&] { read_orientation(path); }),
                HasSubstr("the limit for an orientation is"))
        << file;
  }
  EXPECT_LT(test::processor_s() - start_s, 2.0);
}

TEST(ReadOrientation, RefusesAMatrixThatIsNoRotation) {
  EXPECT_THAT(error_of_text("a.xml", replaced(text_of_fixture("blocks_exchange_XRightYUp.xml"),
                                              "<M_00>", "<M_00>1")),
              HasSubstr("is not a rotation"));
}

TEST(ReadOrientation, DeclaresTheSystemOfAFileThatStatesNone) {
  OrientationOptions options;
  options.crs = {"EPSG:25832"};
  const std::string file = fixture::path_of("block_calibrated_camera_parameters.txt");
  EXPECT_EQ(read_orientation(file, options).crs.definition, "EPSG:25832");
  EXPECT_EQ(
      read_orientation(fixture::path_of("blocks_exchange_angles.xml"), options).crs.definition,
      "EPSG:25832");
}

TEST(FileNameOf, CutsFoldersOfBothKinds) {
  EXPECT_EQ(file_name_of({"D:\\a b\\c.tif", {}, {}}), "c.tif");
  EXPECT_EQ(file_name_of({"a/b.tif", {}, {}}), "b.tif");
  EXPECT_EQ(file_name_of({"b", {}, {}}), "b");
}

}  // namespace
}  // namespace ridgeline::io
