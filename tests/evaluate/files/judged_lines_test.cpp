// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/judged_lines.h"

#include <gtest/gtest.h>

namespace ridgeline::results {
namespace {

/// A camera 800 m above the ground that looks down; 0.1 m a pixel.
io::PatchImage image_at(const std::string& id, double x_m, double y_m) {
  io::PatchImage image;
  image.id = id;
  image.image_from_world << 8000, 0, 0, -8000 * x_m, 0, -8000, 0, 8000 * y_m, 0, 0, -1, 800;
  return image;
}

/// Two images along x, one across.
io::Patch patch_of_three() {
  io::Patch patch;
  patch.images = {image_at("a", 0, 0), image_at("b", 200, 0), image_at("c", 0, 200)};
  patch.height_range_m = {0, 20};
  return patch;
}

/// A line with what these images show of it.
io::LineSet lines_seen_by(const Segment3& line, const std::vector<std::string>& ids) {
  const io::Patch patch = patch_of_three();
  io::LineSet set;
  set.lines.emplace_back();
  set.lines[0].segment_in_world = line;
  for (const std::string& id : ids) {
    const auto image = std::ranges::find(patch.images, id, &io::PatchImage::id);
    set.lines[0].observations.push_back({id, project(image->image_from_world, line)});
  }
  return set;
}

const Segment3 kAlongX{{10, 20, 5}, {30, 20, 5}};
const Segment3 kAlongY{{10, 20, 5}, {10, 40, 5}};

ProjectionMatrix evidence_beside_the_first(const io::LineSet& set) {
  const auto judged = judged_lines_of(set, {}, patch_of_three());
  return judged.at(0).images.value().observations.at(1).image_from_local;
}

TEST(JudgedLines, EvidenceIsOfTheImageThatTellsBestWhereTheLineLies) {
  const io::Patch patch = patch_of_three();
  const std::vector<std::string> all{"a", "b", "c"};
  EXPECT_EQ(evidence_beside_the_first(lines_seen_by(kAlongX, all)),
            patch.images[2].image_from_world);
  EXPECT_EQ(evidence_beside_the_first(lines_seen_by(kAlongY, all)),
            patch.images[1].image_from_world);
}

TEST(JudgedLines, EvidenceIsOfAWholeSegmentBeforeAShortPiece) {
  const Segment3 rather_across_c{{10, 20, 5}, {40, 35, 5}};
  io::LineSet set = lines_seen_by(rather_across_c, {"a", "c", "b"});
  Segment2& piece = set.lines[0].observations[1].px;
  piece.end = point_at(piece, 0.2);
  EXPECT_EQ(evidence_beside_the_first(set), patch_of_three().images[1].image_from_world);
}

TEST(JudgedLines, EvidenceNeedsTwoImagesOfThePatch) {
  EXPECT_FALSE(judged_lines_of(lines_seen_by(kAlongX, {"a", "a"}), {}, patch_of_three())[0].images);
  io::LineSet set = lines_seen_by(kAlongX, {"a", "b"});
  set.lines[0].observations[1].image = "of another patch";
  EXPECT_FALSE(judged_lines_of(set, {}, patch_of_three())[0].images);
}

}  // namespace
}  // namespace ridgeline::results
