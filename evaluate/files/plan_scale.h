// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_files.h"
#include "io/lines/line_set.h"
#include "io/project/patch.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::results {

/// Ensures that distances in plan, like heights, are metres on the ground at the lines. In Web
/// Mercator, plan distances in Germany are half as long again as on the ground. By default, a plan
/// that is not true to scale is an IoError, see io::require_true_scale(). With `scale_to_ground`
/// the cloud's plan coordinates are divided by the map scale at the centre of the lines;
/// judge_lines() then does the same to the lines. In this case, throws IoError only if the scale
/// varies too much over the lines or the axes are skewed on the ground, and std::invalid_argument
/// if there are cameras, which cannot be scaled.
void set_plan_scale(const std::vector<io::LineSet>& sets,
                    const std::optional<io::Patch>& patch,
                    bool scale_to_ground,
                    io::CloudFiles& cloud,
                    std::vector<std::string>& warnings);

/// The same for a cloud without lines: at the origin of its frame, which is amid its points.
void set_plan_scale(bool scale_to_ground,
                    io::CloudFiles& cloud,
                    std::vector<std::string>& warnings);

}  // namespace ridgeline::results
