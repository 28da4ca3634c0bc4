// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_files.h"
#include "io/lines/line_set.h"
#include "io/project/patch.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::results {

/// Sees to it that distances in the plan are metres on the ground where the lines lie, as heights are: Web Mercator is half
/// as long again in Germany. A plan that is not true to scale is refused, see io::require_true_scale(), or on
/// request the cloud's plan is divided by its scale at the middle of the lines; lines_beside() takes that over.
/// Throws IoError if the plan is not true to scale, and on request if its scale varies too much over the lines
/// or its axes are askew on the ground; std::invalid_argument on request with cameras, which cannot follow.
void set_plan_scale(const std::vector<io::LineSet>& sets,
                    const std::optional<io::PatchFile>& patch,
                    bool scale_to_ground,
                    io::CloudFiles& cloud,
                    std::vector<std::string>& warnings);

}  // namespace ridgeline::results
