// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/merged_lines.h"

#include "evaluate/files/judged_lines.h"
#include "io/lines/read_lines.h"
#include "io/project/patch.h"
#include "reconstruct/estimate/beyond/merge_lines.h"
#include "reconstruct/geometry/plan_box.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <span>
#include <utility>

namespace ridgeline::apps {
namespace {

/// Converts image positions from the windows of a patch to the whole frames.
void count_from_frame(const std::vector<io::PatchImage>& images, io::Line& line) {
  line.observations = results::observations_of(line, images);
  line.base_px.reset();
  line.other_px.reset();
  for (io::LineObservation& observation : line.observations) {
    const auto image = std::ranges::find(images, observation.image, &io::PatchImage::id);
    if (image == images.end()) continue;
    observation.px.start += image->window_px;
    observation.px.end += image->window_px;
  }
}

struct LinesOfPatch {
  std::vector<io::Line> lines;
  std::size_t n_without_place = 0;
};

LinesOfPatch read_lines_of(const BlockTask& task, reconstruct::Method method) {
  const std::vector<io::PatchImage> images = io::read_patch(task.patch_path()).images;
  io::LineSet set = io::read_lines(task.lines_path(method));
  LinesOfPatch found;
  for (io::Line& line : set.lines) {
    if (!all_finite(line.segment_in_world) || !line.covariance_m2) {
      ++found.n_without_place;
      continue;
    }
    count_from_frame(images, line);
    line.id = fmt::format("{}/{}", task.planned().id, line.id);
    if (!line.parent_id.empty())
      line.parent_id = fmt::format("{}/{}", task.planned().id, line.parent_id);
    line.row = 0;
    found.lines.push_back(std::move(line));
  }
  return found;
}

class StripMerge {
 public:
  using Take = std::function<void(const io::Line&, std::size_t patch)>;

  StripMerge(const BlockPlan& plan, const Take& take)
      : plan_(plan), take_(take), merger_(grid_of(plan), {.overlap_m = plan.overlap_m}) {}

  void add(std::span<const BlockTask* const> column, reconstruct::Method method) {
    std::vector<LinesOfPatch> read(column.size());
    tbb::parallel_for(std::size_t{0}, column.size(),
                      [&](std::size_t i) { read[i] = read_lines_of(*column[i], method); });
    std::vector<reconstruct::FoundLine> found;
    for (std::size_t i = 0; i < column.size(); ++i) {
      counts_.n_without_place += read[i].n_without_place;
      for (io::Line& line : read[i].lines) {
        found.push_back({{line.segment_in_world, *line.covariance_m2}, column[i]->planned().cell});
        held_.push_back(std::move(line));
      }
    }
    counts_.n_found += found.size();
    take_all(merger_.add(found));
  }

  MergedCounts finish() {
    take_all(merger_.finish());
    return counts_;
  }

 private:
  void take_all(const std::vector<reconstruct::MergedLine>& merged) {
    for (const reconstruct::MergedLine& one : merged) {
      const Segment3& segment = one.geometry.segment_in_world;
      if (!is_within(plan_.area_m, midpoint(segment).head<2>())) continue;
      io::Line& line = held_[one.line - n_dropped_];
      line.segment_in_world = segment;
      line.covariance_m2 = one.geometry.covariance_m2;
      const auto patch = std::ranges::lower_bound(plan_.patches, one.cell, {}, &PlannedPatch::cell);
      take_(line, static_cast<std::size_t>(patch - plan_.patches.begin()));
    }
    for (; n_dropped_ < merger_.first_needed(); ++n_dropped_) held_.pop_front();
  }

  const BlockPlan& plan_;
  const Take& take_;
  reconstruct::LineMerger merger_;
  std::deque<io::Line> held_;  ///< the lines from number n_dropped_ on
  std::size_t n_dropped_ = 0;
  MergedCounts counts_;
};

}  // namespace

MergedCounts merge_lines_of(const BlockPlan& plan,
                            const std::vector<const BlockTask*>& tasks,
                            reconstruct::Method method,
                            const std::function<void(const io::Line&, std::size_t patch)>& take) {
  StripMerge merge(plan, take);
  const auto column_of = [](const BlockTask* task) { return task->planned().cell.column; };
  for (auto first = tasks.begin(); first != tasks.end();) {
    const auto last =
        std::ranges::upper_bound(first, tasks.end(), column_of(*first), {}, column_of);
    merge.add({first, last}, method);
    first = last;
  }
  return merge.finish();
}

}  // namespace ridgeline::apps
