// SPDX-License-Identifier: BSD-3-Clause
// Images, cameras and elements that a reader leaves out, each with a word.
#include "io/orientation/read_orientation.h"
#include "tests/io/orientation/fixture.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

std::string fixture_text(const std::string& file) {
  std::ifstream stream(fixture::path_of(file), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The text with `old` replaced wherever it occurs.
std::string all_replaced(std::string text, const std::string& old, const std::string& with) {
  std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  for (; at != std::string::npos; at = text.find(old, at + with.size())) {
    text.replace(at, old.size(), with);
  }
  return text;
}

Orientation read_with(const std::string& file, const std::string& old, const std::string& with) {
  const TempFolder folder;
  return read_orientation(folder.write(file, all_replaced(fixture_text(file), old, with)));
}

TEST(ReadOrientation, LeavesOutImagesWithoutAName) {
  const Orientation metashape = read_with("metashape_local.xml", "3.tif\"", "\"");
  EXPECT_THAT(metashape.warnings, Contains(HasSubstr("images without a name, left out: 1")));
  const Orientation blocks =
      read_with("blocks_exchange_angles.xml", "<ImagePath>D:/flight 1/a b_1.tif</ImagePath>", "");
  EXPECT_THAT(blocks.images, SizeIs(3));
  EXPECT_THAT(blocks.warnings, Contains("photos without a name, left out: 1 (Id 0)"));
}

TEST(ReadOrientation, NeedsNoCameraWithoutImages) {
  const std::string fisheye_group =
      "<Photogroup><Name>idle</Name><CameraModelType>Fisheye</CameraModelType></Photogroup>";
  EXPECT_THAT(
      read_with("blocks_exchange_angles.xml", "<Photogroup>", fisheye_group + "<Photogroup>")
          .cameras,
      SizeIs(1));
  EXPECT_THAT(read_with("opensfm.json", "\"cameras\": {",
                        R"("cameras": {"idle": {"projection_type": "fisheye"}, )")
                  .cameras,
              SizeIs(1));
  EXPECT_THAT(read_with("inpho.prj", "$CAMERA_DEFINITION",
                        "$CAMERA_DEFINITION\n  $ID : idle\n$END\n$CAMERA_DEFINITION")
                  .cameras,
              SizeIs(1));
  const TempFolder folder;
  OrientationOptions options;
  options.cameras =
      folder.write("cameras.yaml", fixture_text("cameras.yaml") + "idle: {type: fisheye, k4: 1}\n");
  EXPECT_THAT(read_orientation(fixture::path_of("opk_deg.csv"), options).cameras, SizeIs(1));
  options.cameras = folder.write("others.yaml", "a: {type: fisheye}\nb: {type: fisheye}\n");
  EXPECT_THAT(io_error_of([&] { read_orientation(fixture::path_of("opk_deg.csv"), options); }),
              HasSubstr("has camera 'cam 1', which is missing in"));
}

TEST(ReadMetashape, LeavesOutDisabledChunks) {
  const Orientation orientation =
      read_with("metashape_local.xml", "<document version=\"2.0.0\">",
                "<document><chunk label=\"old\" enabled=\"false\"></chunk>");
  EXPECT_THAT(orientation.images, SizeIs(4));
  EXPECT_THAT(orientation.warnings, Contains("disabled chunks, left out: 1 (old)"));
}

TEST(ReadOrientation, NamesElementsThatChangeWhatAPixelMeans) {
  EXPECT_THAT(read_with("metashape_local.xml", "<calibration",
                        "<rolling_shutter>true</rolling_shutter><calibration")
                  .warnings,
              Contains(HasSubstr("elements that are not read: rolling_shutter in sensor")));
  EXPECT_THAT(read_with("metashape_local.xml", "<calibration",
                        "<film_camera>false</film_camera><calibration")
                  .warnings,
              Not(Contains(HasSubstr("not read"))));
  EXPECT_THAT(read_with("blocks_exchange_angles.xml", "<P1>", "<K4>0.1</K4><P1>").warnings,
              Contains("elements that are not read: K4 in Distortion (1)"));
  EXPECT_THAT(
      read_with("opensfm.json", "\"translation\"", R"("rolling_shutter": [1, 2], "translation")")
          .warnings,
      Contains("members that are not read: rolling_shutter of shot"));
  EXPECT_THAT(
      read_with("inpho.prj", "  $TERRAIN_HEIGHT", "  $FIDUCIAL_OBS :\n    1 2 3\n  $TERRAIN_HEIGHT")
          .warnings,
      Contains(HasSubstr("fiducial marks, left out: 4")));
  EXPECT_THAT(read_orientation(fixture::path_of("metashape_utm.xml")).warnings,
              Not(Contains(HasSubstr("not read"))));
  EXPECT_THAT(read_orientation(fixture::path_of("blocks_exchange_angles.xml")).warnings, IsEmpty());
}

/// A chunk with the local coordinates of its components 0 and 1, to which one camera each belongs.
std::string two_components(const char* active) {
  return all_replaced(all_replaced(R"(<document><chunk>
<sensors><sensor id="0" type="frame"><calibration type="frame"><resolution width="60" height="60"/>
<f>50</f></calibration></sensor></sensors>
<components active_id="ACTIVE"><component id="0"/><component id="1"/></components><cameras>
<camera id="0" sensor_id="0" component_id="0" label="a"><transform>POSE</transform></camera>
<camera id="1" sensor_id="0" component_id="1" label="b"><transform>POSE</transform></camera>
</cameras></chunk></document>)",
                                   "ACTIVE", active),
                      "POSE", "1 0 0 0 0 -1 0 0 0 0 -1 50 0 0 0 1");
}

TEST(ReadMetashape, ReadsOnlyTheActiveComponentOfALocalChunk) {
  const TempFolder folder;
  for (const auto& [active, image] : {std::pair{"0", "a"}, std::pair{"1", "b"}}) {
    const Orientation orientation = read_orientation(folder.write("a.xml", two_components(active)));
    ASSERT_THAT(orientation.images, SizeIs(1)) << active;
    EXPECT_EQ(orientation.images[0].name, image);
    EXPECT_THAT(orientation.warnings,
                Contains(HasSubstr("images of a component without a place, left out: 1")));
  }
}

TEST(ReadBlocksExchange, RefusesAnglesOfTheAircraft) {
  std::string text = fixture_text("blocks_exchange_angles.xml");
  for (const auto& [old, with] :
       {std::pair{"Omega>", "Yaw>"}, std::pair{"Phi>", "Pitch>"}, std::pair{"Kappa>", "Roll>"}}) {
    text = all_replaced(text, old, with);
  }
  const TempFolder folder;
  EXPECT_THAT(io_error_of([&] { read_orientation(folder.write("a.xml", text)); }),
              HasSubstr("must be at most -20 degrees, as of a camera that looks down"));
}

TEST(ReadPatB, TakesFlagsFortranExponentsAndAnEndMark) {
  OrientationOptions options;
  options.cameras = fixture::path_of("cameras.yaml");
  options.matrix = MatrixDirection::kWorldFromCamera;
  const std::string plain =
      "1 500300.5 5412300.25 100\n1 0 0 0 0.6\n-0.8 0 0.8 0.6\n"
      "2 500400.5 5412300.25 101\n1 0 0 0 1\n0 0 0 1\n";
  const std::string odd =
      "1 153.0 500300.5 5412300.25 100.0 1 0\n0.1D+01 0.0 0.0 0.0 0.6D0 0\n"
      "-0.8 0.0 0.8 0.6 0\n2 0.50040050D+06 5412300.25 101.0 1\n1.0 0.0 0.0 0.0 1.0\n"
      "0.0 0.0 0.0 1.0\n-99\n";
  const TempFolder folder;
  const std::string more = plain + "-99\n3 500500.5 5412300.25 101\n1 0 0 0 1\n0 0 0 1\n";
  EXPECT_THAT(io_error_of([&] { read_orientation(folder.write("c.ori", more), options); }),
              HasSubstr("c.ori:7: "));
  const Orientation a = read_orientation(folder.write("a.ori", plain), options);
  const Orientation b = read_orientation(folder.write("b.ori", odd), options);
  ASSERT_THAT(b.images, SizeIs(2));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(b.images[i].name, a.images[i].name);
    EXPECT_EQ(b.images[i].exterior.position_m, a.images[i].exterior.position_m);
    EXPECT_EQ(b.images[i].exterior.world_from_camera_axes,
              a.images[i].exterior.world_from_camera_axes);
  }
}

TEST(ReadOrientation, RefusesPositionsFarOutsideTheirSystem) {
  OrientationOptions options;
  options.cameras = fixture::path_of("cameras.yaml");
  const auto error_of = [&](const char* crs, const char* rows) {
    const TempFolder folder;
    options.crs.definition = crs;
    const std::string table = std::string("name,x,y,z,omega_deg,phi_deg,kappa_deg\n") + rows;
    return io_error_of([&] { read_orientation(folder.write("a.csv", table), options); });
  };
  EXPECT_THAT(error_of("", "a,4157665,671679,4775252,0,0,0\n"),
              HasSubstr("the height of image a is 4775252 m"));
  EXPECT_THAT(error_of("EPSG:32632", "a,4157665,671679,1050,0,0,0\n"),
              HasSubstr("outside the area of use of WGS 84 / UTM zone 32N"));
  EXPECT_THAT(error_of("EPSG:32632", "a,513000,5403000,1050,0,0,0\n"), IsEmpty());
}

}  // namespace
}  // namespace ridgeline::io
