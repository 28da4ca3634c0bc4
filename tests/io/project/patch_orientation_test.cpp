// SPDX-License-Identifier: BSD-3-Clause
// Patches whose images take camera and pose from an orientation.
#include "io/project/block_file.h"
#include "io/project/image_names.h"
#include "io/project/patch.h"
#include "tests/support/paths.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace ridgeline::io {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kTableHead =
    "name,x,y,z,omega_deg,phi_deg,kappa_deg\n";  // the unit is stated
constexpr const char* kTwoRows =
    "left,513000,5403000,1500,0.5,-1.25,90\n"
    "right,513300,5403010,1502,-0.75,0.5,91\n";
constexpr const char* kThirdRow = "third,513600,5403000,1501,0.25,0,89\n";
constexpr const char* kInteriorText =
    "{focal_length_mm: 120, pixel_size_um: 12, size_px: [7680, 13824], principal_point_mm: [0.01, "
    "-0.02], k1: 0.01}";

/// A folder with an orientation and its file of cameras, for the patch files of a test.
class PatchOfOrientation : public testing::Test {
 protected:
  PatchOfOrientation() {
    (void)folder_.write("block/opk.csv", std::string(kTableHead) + kTwoRows + kThirdRow);
    (void)folder_.write("block/cameras.yaml", fmt::format("DMC: {}\n", kInteriorText));
  }

  /// A patch file: `keys` beside the orientation, and `images`, its list.
  [[nodiscard]] std::string write(const std::string& images, const std::string& keys = "") const {
    return folder_.write("patch.yaml",
                         fmt::format("id: 1\nheight_range: [250, 300]\n"
                                     "orientation: block/opk.csv\ncameras: block/cameras.yaml\n"
                                     "{}images:\n{}",
                                     keys, images));
  }
  [[nodiscard]] PatchFile read(const std::string& images, const std::string& keys = "") const {
    return read_patch(write(images, keys));
  }
  [[nodiscard]] std::string refusal_of(const std::string& images,
                                       const std::string& keys = "") const {
    const std::string path = write(images, keys);
    return io_error_of([&] { read_patch(path); });
  }

  TempFolder folder_;
};

constexpr const char* kTwoPaths = "  - path: frames/left.tif\n  - path: frames/right.tif\n";

std::string typed_image(const std::string& name,
                        const std::string& pose,
                        const std::string& more = "") {
  return fmt::format("  - {{id: {}, path: frames/{}.tif, interior: {}, exterior: {}{}}}\n", name,
                     name, kInteriorText, pose, more);
}

std::string typed_images(const std::string& more_of_right = "") {
  return typed_image(
             "left",
             "{position_m: [513000, 5403000, 1500], omega_phi_kappa_deg: [0.5, -1.25, 90]}") +
         typed_image("right",
                     "{position_m: [513300, 5403010, 1502], omega_phi_kappa_deg: [-0.75, 0.5, 91]}",
                     more_of_right);
}

void expect_same_images(const PatchFile& a, const PatchFile& b) {
  constexpr double kRelative = 1e-9;
  ASSERT_EQ(a.images.size(), b.images.size());
  for (std::size_t i = 0; i < a.images.size(); ++i) {
    EXPECT_EQ(a.images[i].id, b.images[i].id);
    EXPECT_EQ(a.images[i].path, b.images[i].path);
    EXPECT_EQ(a.images[i].window_px, b.images[i].window_px);
    const ProjectionMatrix& P = b.images[i].image_from_world;
    EXPECT_LT((a.images[i].image_from_world - P).cwiseAbs().maxCoeff(),
              kRelative * P.cwiseAbs().maxCoeff());
    ASSERT_TRUE(a.images[i].interior && b.images[i].interior);
    EXPECT_EQ(a.images[i].interior->size_px, b.images[i].interior->size_px);
    EXPECT_EQ(a.images[i].interior->distortion.k1, b.images[i].interior->distortion.k1);
  }
}

TEST_F(PatchOfOrientation, IsThatOfTheSameCamerasTypedIn) {
  const PatchFile patch = read(kTwoPaths);
  const PatchFile typed = read(typed_images());
  expect_same_images(patch, typed);
  EXPECT_THAT(patch.orientation_files,
              ElementsAre(folder_.file("block/opk.csv"), folder_.file("block/cameras.yaml")));
  EXPECT_THAT(patch.decisions, ElementsAre(folder_.file("block/opk.csv") +
                                           ": Angles are in deg (stated in the table)."));
  EXPECT_THAT(patch.warnings, IsEmpty());
}

TEST_F(PatchOfOrientation, ShiftsTheCameraOfAWindow) {
  const PatchFile patch =
      read("  - path: frames/left.tif\n  - {path: frames/right.tif, window_px: [3000, 6000]}\n");
  expect_same_images(patch, read(typed_images(", window_px: [3000, 6000]")));
  const Eigen::Vector3d x(513200.0, 5403010.0, 270.0);
  const Eigen::Vector2d shift = project(read(kTwoPaths).images[1].image_from_world, x) -
                                project(patch.images[1].image_from_world, x);
  EXPECT_LT((shift - Eigen::Vector2d(3000.0, 6000.0)).norm(), 1e-6);
}

TEST_F(PatchOfOrientation, MixesWithCamerasTypedIn) {
  const std::string images = typed_images();
  const std::string left = images.substr(0, images.find('\n') + 1);
  expect_same_images(read(left + "  - path: frames/right.tif\n"), read(images));
}

TEST_F(PatchOfOrientation, FindsImagesByTheNameThatIsStated) {
  const PatchFile patch = read(
      "  - {id: a, path: cut/17.tif, name: left.TIF}\n"
      "  - {path: cut/18.tif, name: right}\n");
  EXPECT_EQ(patch.images[0].id, "a");
  EXPECT_EQ(patch.images[1].id, "18");
  const PatchFile typed = read(typed_images());
  EXPECT_TRUE(patch.images[0].image_from_world.isApprox(typed.images[0].image_from_world, 1e-9));
  EXPECT_TRUE(patch.images[1].image_from_world.isApprox(typed.images[1].image_from_world, 1e-9));
}

TEST_F(PatchOfOrientation, NamesAnImageThatIsNotThereAndTheNearest) {
  EXPECT_THAT(refusal_of("  - path: frames/lefty.tif\n  - path: frames/right.tif\n"),
              AllOf(HasSubstr("patch.yaml: line 6: orientation " + folder_.file("block/opk.csv")),
                    HasSubstr("has no image lefty.tif; similar names: left, right, third")));
}

TEST_F(PatchOfOrientation, NamesTheFileOfACameraThatIsMissing) {
  const std::string path = folder_.write(
      "patch.yaml",
      fmt::format("id: 1\nheight_range: [250, 300]\norientation: block/opk.csv\nimages:\n{}",
                  kTwoPaths));
  EXPECT_THAT(io_error_of([&] { read_patch(path); }),
              HasSubstr("block/opk.csv does not define the camera of image left; name a camera "
                        "file with the key cameras"));
}

TEST_F(PatchOfOrientation, TakesOrComparesTheReferenceSystem) {
  EXPECT_FALSE(read(kTwoPaths).crs.known());
  EXPECT_EQ(read(kTwoPaths, "crs: EPSG:25832\n").crs.definition, "EPSG:25832");
  const PatchFile utm32 = read_patch(folder_.write(
      "utm32.yaml", "id: 1\ncrs: EPSG:25832\nheight_range: [0, 1]\nimages:\n" + typed_images()));
  (void)folder_.write("block/opk.prj",
                      R"(PROJCS["ETRS89 / UTM zone 32N",GEOGCS["ETRS89",)"
                      R"(DATUM["European_Terrestrial_Reference_System_1989",)"
                      R"(SPHEROID["GRS 1980",6378137,298.257222101]],)"
                      R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],)"
                      R"(PROJECTION["Transverse_Mercator"],)"
                      R"(PARAMETER["latitude_of_origin",0],)"
                      R"(PARAMETER["central_meridian",9],)"
                      R"(PARAMETER["scale_factor",0.9996],)"
                      R"(PARAMETER["false_easting",500000],)"
                      R"(PARAMETER["false_northing",0],UNIT["metre",1]])");
  EXPECT_TRUE(compare(read(kTwoPaths).crs, utm32.crs).compatible);
  EXPECT_TRUE(read(kTwoPaths).crs.known());
  EXPECT_THAT(read(kTwoPaths, "crs: EPSG:25832\n").warnings, IsEmpty());
  EXPECT_THAT(read(kTwoPaths, "crs: EPSG:25832+7837\n").warnings,
              ElementsAre(AllOf(HasSubstr("opk.csv: "), HasSubstr("heights may differ"))));
  EXPECT_THAT(refusal_of(kTwoPaths, "crs: EPSG:25833\n"),
              AllOf(HasSubstr("patch.yaml: line 5: patch and orientation "), HasSubstr("opk.csv"),
                    HasSubstr("do not match: horizontal reference systems differ: "),
                    HasSubstr("ETRS89 / UTM zone 33N")));
}

TEST_F(PatchOfOrientation, NamesTheOrientationIfThatIsDamaged) {
  const std::string table = folder_.file("block/opk.csv");
  (void)folder_.write("block/opk.csv", std::string(kTableHead) + "left,513000,5403000\n");
  EXPECT_THAT(refusal_of(kTwoPaths), HasSubstr(table + ":2: 3 fields"));
  (void)folder_.write("block/opk.csv", "");
  EXPECT_THAT(refusal_of(kTwoPaths), HasSubstr(table + ": is empty"));
  std::filesystem::remove(table);
  EXPECT_THAT(refusal_of(kTwoPaths), HasSubstr(table + ": no such file"));
}

TEST_F(PatchOfOrientation, StatesWhatTheFileLeavesOpen) {
  (void)folder_.write("block/opk.csv", std::string("name,x,y,z,omega,phi,kappa\n") + kTwoRows);
  EXPECT_THAT(
      refusal_of("  - path: left.tif\n  - path: right.tif\n"),
      AllOf(HasSubstr("opk.csv: the rotation convention is ambiguous"), HasSubstr("angles: gon")));
  expect_same_images(read(kTwoPaths, "angles: deg\n"), read(typed_images(), "angles: deg\n"));
  EXPECT_FALSE(read(kTwoPaths, "angles: gon\n")
                   .images[0]
                   .image_from_world.isApprox(
                       read(kTwoPaths, "angles: deg\n").images[0].image_from_world, 1e-6));
  EXPECT_FALSE(read(kTwoPaths, "angles: deg\nrotation: pok\n")
                   .images[0]
                   .image_from_world.isApprox(
                       read(kTwoPaths, "angles: deg\n").images[0].image_from_world, 1e-7));
}

TEST_F(PatchOfOrientation, AsksThePointsOfItsWholeImages) {
  (void)folder_.write("block/opk.csv", std::string("name,x,y,z,omega,phi,kappa\n") + kTwoRows);
  ImageFiles asked;
  const auto find = [&](const Orientation&, const ImageFiles& files) {
    asked = files;
    return std::vector<PointObservation>{};
  };
  const std::string path = write(
      "  - path: frames/right.tif\n  - {path: frames/left.tif, window_px: [1, 2]}\n"
      "  - path: frames/fourth.tif\n");
  EXPECT_THAT(io_error_of([&] { read_patch(path, find); }), HasSubstr("the rotation convention"));
  ASSERT_THAT(asked, SizeIs(2));
  EXPECT_FALSE(asked[0]);
  EXPECT_EQ(asked[1], folder_.file("frames/right.tif"));
}

TEST_F(PatchOfOrientation, RefusesKeysThatDoNotGoTogether) {
  EXPECT_THAT(refusal_of(kTwoPaths, "angles: degrees\n"),
              HasSubstr("line 5: angles = degrees; must be deg, gon or rad"));
  EXPECT_THAT(refusal_of(kTwoPaths, "rotation: kpo\n"), HasSubstr("must be opk or pok"));
  EXPECT_THAT(refusal_of(kTwoPaths, "matrix: other\n"),
              HasSubstr("must be world_from_camera or camera_from_world"));
  const auto refusal_of_patch = [&](const std::string& rest) {
    const std::string path =
        folder_.write("other.yaml", "id: 1\nheight_range: [250, 300]\n" + rest);
    return io_error_of([&] { read_patch(path); });
  };
  for (const char* key : {"cameras", "angles", "rotation", "matrix"}) {
    EXPECT_THAT(refusal_of_patch(fmt::format("{}: x\nimages: []\n", key)),
                HasSubstr(fmt::format("line 3: {0} requires orientation", key)));
  }
  EXPECT_THAT(refusal_of_patch("orientation: block/opk.csv\ncolmap: sparse\n"),
              HasSubstr("orientation requires images, not colmap"));
  EXPECT_THAT(refusal_of_patch("images:\n  - {id: a, path: a.tif}\n"),
              HasSubstr("or an orientation for the patch"));
  EXPECT_THAT(refusal_of(typed_images(", name: right")), HasSubstr("name requires an orientation"));
}

TEST_F(PatchOfOrientation, RecordsTheFilesOfAColmapModel) {
  (void)folder_.write("sparse/cameras.txt", "1 SIMPLE_PINHOLE 100 100 100 50 50\n");
  (void)folder_.write("sparse/images.txt",
                      "1 1 0 0 0 0 0 0 1 a.png\n\n"
                      "2 1 0 0 0 -1 0 0 1 sub/b.png\n\n");
  (void)folder_.write("sparse/notes.txt", "of the user\n");
  const PatchFile patch =
      read_patch(folder_.write("colmap.yaml",
                               "id: 1\nheight_range: [0, 1]\norientation: sparse\n"
                               "images:\n  - path: a.png\n  - path: b.png\n"));
  EXPECT_THAT(patch.orientation_files,
              ElementsAre(folder_.file("sparse/cameras.txt"), folder_.file("sparse/images.txt")));
  EXPECT_NEAR(projection_centre(patch.images[1].image_from_world).hnormalized().x(), 1.0, 1e-9);
}

TEST_F(PatchOfOrientation, TakesTheFilesOfAFolderThatItKnows) {
  for (const char* name : {"left.tif", "right.JPG", "other.tif", "notes.txt"})
    (void)folder_.write(std::string("frames/") + name, "x");
  const PatchFile patch = read("  frames\n");
  expect_same_images(patch, read("  - path: frames/left.tif\n  - path: frames/right.JPG\n"));
  ASSERT_THAT(patch.without_file, SizeIs(1));
  EXPECT_EQ(patch.without_file[0].id, "third");
  ASSERT_THAT(patch.warnings, SizeIs(1));
  EXPECT_THAT(patch.warnings[0],
              AllOf(HasSubstr("1 of 3 image files"), HasSubstr("frames/other.tif")));
  (void)folder_.write("frames/left.png", "x");
  EXPECT_THAT(refusal_of("  frames\n"), AllOf(HasSubstr("has only one image, left, for both"),
                                              HasSubstr("narrow the pattern")));
  EXPECT_THAT(refusal_of("  block\n"), HasSubstr("has no image"));
}

TEST_F(PatchOfOrientation, TellsImagesOfOneNameInTwoFoldersApart) {
  (void)folder_.write(
      "block/opk.csv",
      std::string(kTableHead) +
          "a/1.tif,513000,5403000,1500,0,0,90\nb/1.tif,513300,5403010,1502,0,0,91\n");
  for (const char* name : {"a/1.tif", "b/1.tif"})
    (void)folder_.write(std::string("frames/") + name, "x");
  const PatchFile patch = read("  frames/*/*.tif\n");
  ASSERT_THAT(patch.images, SizeIs(2));
  EXPECT_EQ(patch.images[0].id, "a_1");
  EXPECT_EQ(patch.images[1].id, "b_1");
  EXPECT_EQ(patch.images[1].path, folder_.file("frames/b/1.tif"));
}

TEST_F(PatchOfOrientation, NamesAFileIfThePatternMatchesNoImage) {
  for (const char* name : {"lefty.tif", "righty.tif"})
    (void)folder_.write(std::string("frames/") + name, "x");
  EXPECT_THAT(refusal_of("  frames\n"),
              HasSubstr("has none of the 2 image files, such as " +
                        folder_.file("frames/lefty.tif") + "; similar names: left, right, third"));
}

TEST_F(PatchOfOrientation, OfABlockMayListImagesWithTheirNames) {
  const auto write_block = [&](const std::string& images) {
    return folder_.write("block.yaml",
                         "block: b\nheight_range: [250, 300]\norientation: block/opk.csv\n"
                         "cameras: block/cameras.yaml\nimages:\n" +
                             images);
  };
  const BlockFile block = read_block_file(
      write_block("  - {path: a/1.tif, name: left, id: l}\n  - {path: b/1.tif, name: right}\n"));
  ASSERT_THAT(block.images, SizeIs(2));
  EXPECT_EQ(block.images[0].id, "l");
  EXPECT_EQ(block.images[1].exterior->position_m.x(), 513300.0);
  const std::string cut = write_block("  - {path: left.tif, window_px: [1, 2]}\n");
  EXPECT_THAT(io_error_of([&] { read_block_file(cut); }),
              HasSubstr("line 6: window_px is only for patches"));
  const std::string twice =
      write_block("  - {path: a/1.tif, name: left}\n  - {path: b/1.tif, name: right}\n");
  EXPECT_THAT(io_error_of([&] { read_block_file(twice); }), HasSubstr("two images have the id 1"));
}

class ReportedNames : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << folder_ << " is not there";
  }

  std::string folder_ = test::shared_data_dir() + "/reported_2";
};

TEST_F(ReportedNames, MayDifferInCase) {
  const PatchFile patch = read_patch(folder_ + "/16-names-that-match-no-file/patch.yaml");
  ASSERT_THAT(patch.images, SizeIs(2));
  EXPECT_EQ(patch.images[1].exterior->position_m.x(), 513000.0);
}

TEST_F(ReportedNames, OfFilesInFoldersAreToldApartByThem) {
  const BlockFile block = read_block_file(folder_ + "/17-same-name-in-subfolders/block.yaml");
  ASSERT_THAT(block.images, SizeIs(4));
  EXPECT_EQ(block.images[2].id, "101MEDIA_DJI_0001");
  EXPECT_EQ(block.images[2].exterior->position_m.x(), 513320.0);
}

/// The heads of one camera take their images in one place.
TEST_F(PatchOfOrientation, MayHaveImagesInOnePlaceIfTheAreaChooses) {
  (void)folder_.write("block/opk.csv",
                      std::string(kTableHead) + kTwoRows + "oblique,513300,5403010,1502,30,0,91\n");
  for (const char* name : {"left.tif", "right.tif", "oblique.tif"})
    (void)folder_.write(std::string("frames/") + name, "x");
  EXPECT_THAT(refusal_of("  frames\n"), HasSubstr("have the same position"));
  const PatchFile patch = read("  frames\n", "area: [513100, 5403000, 513200, 5403100]\n");
  EXPECT_EQ(patch.max_views, kDefaultMaxViews);
  EXPECT_THAT(patch.images, SizeIs(3));
}

Orientation images_called(const std::vector<std::string>& names) {
  Orientation orientation;
  for (const std::string& name : names) orientation.images.push_back({name, {}, {}});
  return orientation;
}

TEST(ImageNames, TakesNamesWithAndWithoutFolderAndExtension) {
  const Orientation orientation =
      images_called({"D:\\flight\\1.tif", "2", "sub/3.jpg", "3.tif", "7.12", "7.13"});
  EXPECT_EQ(ImageNames(orientation).at("1.tif"), 0U);
  EXPECT_EQ(ImageNames(orientation).at("1"), 0U);
  EXPECT_EQ(ImageNames(orientation).at("1.JPG"), 0U);
  EXPECT_EQ(ImageNames(orientation).at("2.png"), 1U);
  EXPECT_EQ(ImageNames(orientation).at("3.jpg"), 2U);
  EXPECT_EQ(ImageNames(orientation).at("3.tif"), 3U);
  EXPECT_EQ(ImageNames(orientation).at("7.12.tif"), 4U);
  EXPECT_EQ(ImageNames(orientation).at("7.13"), 5U);
}

TEST(ImageNames, TellsFilesOfOneNameApartByTheirFolders) {
  const ImageNames names(images_called({"strip1/7.tif", "strip2/7.tif", "8.tif"}));
  EXPECT_EQ(names.find("/data/strip2/7.tif"), 1U);
  EXPECT_EQ(names.find("strip1/7.tif"), 0U);
  EXPECT_EQ(names.find("/data/strip9/8.jpg"), 2U);
  EXPECT_EQ(names.find("/data/strip1/9.tif"), std::nullopt);
  EXPECT_THROW((void)names.find("/data/strip3/7.tif"), std::invalid_argument);
}

TEST(ImageNames, TakesTheLongestCommonEndOfThePaths) {
  const ImageNames names(images_called({"D:\\Flug 2026\\100MEDIA\\DJI_0001.TIF",
                                        "D:\\Flug 2026\\101MEDIA\\DJI_0001.TIF", "DJI_0002.TIF"}));
  EXPECT_EQ(names.find("/data/101media/dji_0001.tif"), 1U);
  EXPECT_EQ(names.find("/data/flug 2026/100MEDIA/DJI_0001.jpg"), 0U);
  EXPECT_EQ(names.find("/data/102MEDIA/dji_0002.tif"), 2U);
}

TEST(ImageNames, PrefersTheSameCaseAndReadsLatin1) {
  const ImageNames names(images_called({"a.TIF", "a.tif", "H\xc3\xb6he.tif"}));
  EXPECT_EQ(names.find("/data/a.tif"), 1U);
  EXPECT_EQ(names.find("/data/a.TIF"), 0U);
  EXPECT_EQ(names.find("/data/H\xf6he.tif"), 2U);
  EXPECT_THROW((void)names.find("/data/A.Tif"), std::invalid_argument);
}

TEST(ImageNames, RefusesNamesThatSeveralImagesOrNoneHave) {
  const auto refusal = [](const std::vector<std::string>& names, const std::string& name) {
    try {
      (void)ImageNames(images_called(names)).at(name);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal({"a/1.tif", "b/1.tif"}, "1.tif"),
            "has 2 images that could be 1.tif, such as a/1.tif and b/1.tif; select one with the "
            "key name");
  EXPECT_EQ(refusal({"a/1.tif", "b/1.tif"}, "a/1.tif"), "");
  EXPECT_THAT(refusal({"1.tif", "1.jpg"}, "1.png"), HasSubstr("has 2 images"));
  EXPECT_EQ(refusal({"7.12", "7.13"}, "7"), "has no image 7; similar names: 7.12, 7.13");
  EXPECT_EQ(refusal({"far away", "img_4", "img_1", "img_12"}, "img_2"),
            "has no image img_2; similar names: img_4, img_1, img_12");
}

TEST(PatchOfDroneImages, HasTheCamerasOfTheReconstruction) {
  const std::string folder = test::shared_data_dir() + "/drone_odm";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const TempFolder temp;
  const PatchFile patch = read_patch(
      temp.write("patch.yaml", fmt::format("id: 1\nheight_range: [85, 112]\ncrs: EPSG:32651\n"
                                           "orientation: {0}/reconstruction.json\n"
                                           "images:\n  - path: {0}/100_0005_0136.tif\n"
                                           "  - path: {0}/100_0005_0140.tif\n",
                                           folder)));
  EXPECT_EQ(patch.crs.definition, "EPSG:32651");
  EXPECT_EQ(patch.images[0].id, "100_0005_0136");
  EXPECT_THAT(patch.decisions, ElementsAre(HasSubstr("reconstruction.json: Poses were converted")));
  EXPECT_THAT(patch.warnings, ElementsAre(HasSubstr("heights may differ")));  // of the ellipsoid
  const Eigen::Vector3d centre = projection_centre(patch.images[1].image_from_world).hnormalized();
  EXPECT_LT((centre - Eigen::Vector3d(292722.239, 2731034.5, 186.505)).norm(),
            3.0);  // see docs/orientations.md
}

}  // namespace
}  // namespace ridgeline::io
