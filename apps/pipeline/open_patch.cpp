// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/open_patch.h"

#include "apps/pipeline/check_patch.h"
#include "apps/pipeline/decide_patch.h"
#include "apps/pipeline/image_points.h"

namespace ridgeline::apps {

io::Patch read_patch(const std::string& path, const io::Crs& assume_crs) {
  io::Patch patch = decide_patch(io::read_patch(path, find_points_in_files));
  if (assume_crs.known()) patch.crs = assume_crs;
  check_positions(patch);
  return patch;
}

io::Patch open_patch(const std::string& path,
                     const PatchLimits& limits,
                     const std::function<void(const io::Patch&)>& before_check) {
  io::Patch patch = read_patch(path, limits.assume_crs);
  if (before_check) before_check(patch);
  check_patch(patch, limits.max_image_mpx);
  return patch;
}

std::vector<std::string> notes_on(const io::Patch& patch) {
  std::vector<std::string> notes = patch.decisions;
  notes.insert(notes.end(), patch.warnings.begin(), patch.warnings.end());
  return notes;
}

}  // namespace ridgeline::apps
