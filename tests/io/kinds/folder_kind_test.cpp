// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/folder_kind.h"

#include "tests/support/temp_folder.h"

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The kind of a folder with these files.
FileKind kind_of_files(std::initializer_list<const char*> files) {
  const TempFolder folder;
  for (const char* const file : files) (void)folder.write(file, "");
  return kind_of_folder(folder.file(""));
}

TEST(KindOfFolder, TellsWhatTheProgramWritesAndTakes) {
  EXPECT_EQ(kind_of_files({"run.json", "table2.json"}).group, FileGroup::kResultFolder);
  EXPECT_EQ(kind_of_files({"evaluation.joint.json", "patch.yaml"}).group, FileGroup::kResultFolder);
  EXPECT_EQ(kind_of_files({"patch.yaml", "left.tif"}).what, "a folder with a patch file");
  EXPECT_EQ(kind_of_files({"1/patch.yaml", "2/patch.yaml", "3/other"}).what,
            "a folder of 2 patches");
  EXPECT_EQ(kind_of_files({"compare.json"}).what, "a comparison of results");
}

TEST(KindOfFolder, TellsFoldersOfOtherTools) {
  EXPECT_EQ(kind_of_files({"track_0.txt"}).group, FileGroup::kLineFolder);
  EXPECT_EQ(kind_of_files({"cameras.bin", "images.bin"}).what, "a COLMAP model");
  EXPECT_EQ(kind_of_files({"cameras.bin", "images.txt"}).group, FileGroup::kFolder);
}

TEST(KindOfFolder, CountsWhatElseLiesInIt) {
  EXPECT_EQ(kind_of_files({"a.las", "b.LAZ", "c.geojson", "d.doc"}).what,
            "a folder with 2 clouds and 1 line file");
  EXPECT_EQ(kind_of_files({"a.doc"}).what, "a folder");
  EXPECT_EQ(kind_of_files({}).what, "an empty folder");
}

TEST(KindOfFolder, TellsABlock) {
  EXPECT_EQ(kind_of_files({"block.yaml", "frames/a.tif"}).group, FileGroup::kBlockFolder);
  EXPECT_EQ(kind_of_files({"block.yaml", "table2.json"}).group, FileGroup::kResultFolder);
}

TEST(KindOfFolder, TellsProjectsOfOtherToolsByTheirOrientation) {
  for (const char* const file :
       {"opensfm/reconstruction.json", "params/a_calibrated_camera_parameters.txt",
        "1_initial/params/a_calibrated_camera_parameters.txt"}) {
    EXPECT_EQ(kind_of_files({file, "images/a.jpg"}).group, FileGroup::kOrientationFolder) << file;
  }
  EXPECT_EQ(kind_of_files({"sparse/0/cameras.bin", "sparse/0/images.bin"}).what,
            "a folder with an orientation");
}

TEST(OrientationsIn, AreFilesRecognisedByTheirContentElseThoseOfSubfolders) {
  const TempFolder folder;
  const std::string below = folder.write("opensfm/reconstruction.json", "");
  EXPECT_THAT(orientations_in(folder.file("")), ElementsAre(below));
  const std::string table =
      folder.write("poses.csv", "name,x,y,z,omega,phi,kappa\na,1,2,3,4,5,6\n");
  (void)folder.write("words.txt", "no orientation\n");
  EXPECT_THAT(orientations_in(folder.file("")), ElementsAre(table));
  EXPECT_EQ(kind_of_folder(folder.file("")).advice,
            "name " + table + " as orientation in a patch file");
}

TEST(PatchFilesIn, AreThatOfTheFolderOrThoseOfItsSubfolders) {
  const TempFolder folder;
  const std::string second = folder.write("2/patch.yaml", "");
  const std::string first = folder.write("1/patch.yaml", "");
  EXPECT_THAT(patch_files_in(folder.file("")), ElementsAre(first, second));
  EXPECT_THAT(patch_files_in(folder.file("1")), ElementsAre(first));
  EXPECT_THAT(patch_files_in(folder.file("none")), IsEmpty());
}

}  // namespace
}  // namespace ridgeline::io
