// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_files.h"
#include "io/lines/line_set.h"
#include "io/project/patch.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::results {

/// Sees to it that distances in the plan are metres on the ground where the lines lie, as heights
/// are. In Web Mercator they are half as long again in Germany. A plan that is not true to scale is
/// refused, see io::require_true_scale(). With `scale_to_ground` the cloud's plan is divided by its
/// scale at the middle of the lines instead; judge_lines() then does the same to the lines. Throws
/// IoError if the plan is not true to scale; with `scale_to_ground` only if its scale varies too
/// much over the lines or its axes are askew on the ground. Throws std::invalid_argument for
/// `scale_to_ground` with cameras, which cannot be scaled.
void set_plan_scale(const std::vector<io::LineSet>& sets,
                    const std::optional<io::Patch>& patch,
                    bool scale_to_ground,
                    io::CloudFiles& cloud,
                    std::vector<std::string>& warnings);

}  // namespace ridgeline::results
