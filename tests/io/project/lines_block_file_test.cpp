// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/lines_block_file.h"

#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

#include <string>

namespace ridgeline::io {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ReadLinesBlock, ReadsEveryKey) {
  const TempFolder folder;
  const LinesBlockFile block = read_lines_block(
      folder.write("b/BLOCK.yaml",
                   "block: town\nlines: [a.geojson, ../b.gpkg]\nlidar: ['tiles/*.laz', /c/d.las]\n"
                   "crs: EPSG:25832\nreference_lines: true.geojson\npatch_size_m: 250\n"
                   "classes: [2, 6]\nexclude_withheld: false\nlast_returns: true\n"
                   "scale_to_ground: true\nbounds: [1, 2, 3, 4]\norigin: [100, 200, 0]\n"));
  EXPECT_EQ(block.block, "town");
  EXPECT_THAT(block.lines, ElementsAre(folder.file("b/a.geojson"), folder.file("b.gpkg")));
  EXPECT_THAT(block.lidar, ElementsAre(folder.file("b/tiles/*.laz"), "/c/d.las"));
  EXPECT_EQ(block.crs.definition, "EPSG:25832");
  EXPECT_EQ(block.reference_lines, folder.file("b/true.geojson"));
  EXPECT_EQ(block.patch_size_m, 250.0);
  EXPECT_THAT(*block.classes, ElementsAre(2, 6));
  EXPECT_FALSE(block.exclude_withheld);
  EXPECT_TRUE(block.last_returns);
  EXPECT_TRUE(block.scale_to_ground);
  EXPECT_THAT(block.bounds, ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(block.origin, ElementsAre(100, 200, 0));
}

TEST(ReadLinesBlock, HasTheDefaultsOfEvaluate) {
  const TempFolder folder;
  const LinesBlockFile block =
      read_lines_block(folder.write("BLOCK.yaml", "lines: a.csv\nlidar: b.las\n"));
  EXPECT_EQ(block.block, "");
  EXPECT_FALSE(block.crs.known());
  EXPECT_FALSE(block.reference_lines);
  EXPECT_EQ(block.patch_size_m, 500.0);
  EXPECT_FALSE(block.classes);
  EXPECT_TRUE(block.exclude_withheld);
  EXPECT_FALSE(block.last_returns || block.scale_to_ground);
  EXPECT_TRUE(block.bounds.empty() && block.origin.empty());
}

TEST(ReadLinesBlock, NamesTheLineAndTheRuleOfAFault) {
  const TempFolder folder;
  const std::string good = "lines: a.csv\nlidar: b.las\n";
  struct Case {
    std::string text, line, rule;
  };
  for (const Case& c : {
           Case{good + "patch_size: 3\n", "line 3", "unknown key 'patch_size'"},
           Case{good + "images: x\n", "line 3", "unknown key 'images'"},
           Case{"lines: a.csv\n", "line 1", "key 'lidar' is missing"},
           Case{"block: b\nlidar: a.las\n", "line 1", "key 'lines' is missing"},
           Case{"lidar: a.las\nlines: []\n", "line 2", "at least one file is needed"},
           Case{good + "lines: c.csv\n", "line 3", "given twice"},
           Case{good + "patch_size_m: 0\n", "line 3", "must be in [1, 1e+06]"},
           Case{good + "patch_size_m: .inf\n", "line 3", "must be a finite number"},
           Case{good + "classes: [2, 256]\n", "line 3", "whole numbers, 0 to 255"},
           Case{good + "classes: []\n", "line 3", "no point would be kept"},
           Case{good + "last_returns: 1\n", "line 3", "must be true or false"},
           Case{good + "bounds: [3, 0, 1, 1]\n", "line 3", "min <= max"},
           Case{good + "origin: [0.5, 0, 0]\n", "line 3", "whole metres"},
           Case{good + "crs: nowhere\n", "line 3", "crs: "},
       }) {
    const std::string path = folder.write("BLOCK.yaml", c.text);
    EXPECT_THAT(io_error_of([&] { read_lines_block(path); }),
                AllOf(HasSubstr(path), HasSubstr(c.line), HasSubstr(c.rule)))
        << c.text;
  }
}

}  // namespace
}  // namespace ridgeline::io
