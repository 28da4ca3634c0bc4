// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/merged_lines.h"

#include "io/lines/read_lines.h"
#include "io/project/patch.h"
#include "reconstruct/block/merge_lines.h"
#include "reconstruct/geometry/plan_box.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace ridgeline::apps {
namespace {

/// The pixels that a patch counts from the corner of its windows, in the whole frames.
void count_from_frame(const io::PatchFile& patch, io::Line& line) {
  if (line.sightings.empty() && line.left_px && line.right_px)
    line.sightings = {{patch.images[0].id, *line.left_px}, {patch.images[1].id, *line.right_px}};
  line.left_px.reset();
  line.right_px.reset();
  for (io::LineSighting& sighting : line.sightings) {
    const auto image = std::ranges::find(patch.images, sighting.image, &io::PatchImage::id);
    if (image == patch.images.end()) continue;
    sighting.px.start += image->window_px;
    sighting.px.end += image->window_px;
  }
}

struct LinesOfPatch {
  io::Crs crs;
  std::vector<io::Line> lines;
  std::size_t n_without_place = 0;
};

LinesOfPatch read_lines_of(const FinishedPatch& finished) {
  const io::PatchFile patch = io::read_patch(finished.patch_path);
  io::LineSet set = io::read_lines(finished.lines_path);
  LinesOfPatch found{set.crs, {}, 0};
  for (io::Line& line : set.lines) {
    if (!all_finite(line.segment_in_world) || !line.covariance_m2) {
      ++found.n_without_place;
      continue;
    }
    count_from_frame(patch, line);
    line.id = fmt::format("{}/{}", finished.planned->id, line.id);
    if (!line.parent_id.empty())
      line.parent_id = fmt::format("{}/{}", finished.planned->id, line.parent_id);
    found.lines.push_back(std::move(line));
  }
  return found;
}

}  // namespace

BlockLines merged_lines(const BlockPlan& plan, const std::vector<FinishedPatch>& patches) {
  std::vector<LinesOfPatch> read(patches.size());
  tbb::parallel_for(std::size_t{0}, patches.size(),
                    [&](std::size_t i) { read[i] = read_lines_of(patches[i]); });
  BlockLines merged;
  std::vector<reconstruct::FoundLine> found;
  std::vector<io::Line*> lines;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    merged.n_without_place += read[i].n_without_place;
    for (io::Line& line : read[i].lines) {
      found.push_back({{line.segment_in_world, *line.covariance_m2}, patches[i].planned->cell});
      lines.push_back(&line);
    }
  }
  merged.n_found = found.size();
  merged.set.crs.definition = plan.crs;
  const reconstruct::PatchGrid grid{plan.patch_size_m};
  for (const reconstruct::MergedLine& one :
       reconstruct::merge_lines(found, grid, {.overlap_m = plan.overlap_m})) {
    const Segment3& segment = one.geometry.segment_in_world;
    if (!is_within(plan.area_m, midpoint(segment).head<2>())) continue;
    io::Line line = std::move(*lines[one.line]);
    line.segment_in_world = segment;
    line.covariance_m2 = one.geometry.covariance_m2;
    line.row = 0;
    merged.set.lines.push_back(std::move(line));
    const auto patch = std::ranges::find(plan.patches, found[one.line].cell, &PlannedPatch::cell);
    merged.patch_of_line.push_back(static_cast<std::size_t>(patch - plan.patches.begin()));
  }
  return merged;
}

}  // namespace ridgeline::apps
