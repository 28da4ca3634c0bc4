// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/read_patch.h"

#include "apps/pipeline/complete_patch.h"
#include "apps/pipeline/image_points.h"

namespace ridgeline::apps {

io::PatchFile read_patch(const std::string& path) {
  io::PatchFile patch =
      io::read_patch(path, [](const io::Orientation& orientation, const io::ImageFiles& files) {
        return find_image_points(orientation, files);
      });
  complete_patch(patch);
  return patch;
}

std::vector<std::string> notes_on(const io::PatchFile& patch) {
  std::vector<std::string> notes = patch.decisions;
  notes.insert(notes.end(), patch.warnings.begin(), patch.warnings.end());
  return notes;
}

}  // namespace ridgeline::apps
