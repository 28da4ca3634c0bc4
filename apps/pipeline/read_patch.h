// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// io::read_patch() and complete_patch(); what an orientation leaves open is decided by the patch's
/// images. Throws IoError as these do.
io::PatchFile read_patch(const std::string& path);

/// What was decided in reading the patch, and its warnings, each in a text that stands alone.
std::vector<std::string> notes_on(const io::PatchFile& patch);

}  // namespace ridgeline::apps
