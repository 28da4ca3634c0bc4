// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/report_input.h"
#include "apps/report/shown_planes.h"
#include "evaluate/gates/gate.h"

#include <optional>
#include <vector>

namespace ridgeline::apps {

/// What a patch shows in 3D beside its points: per method the planes of the lines.
struct ShownScene {
  std::vector<ShownPlanes> methods;
};

ShownScene shown_scene(const ReportPatch& patch);

/// The data of the page, as apps/report/web/src/data/schema.ts declares it. Figures are computed
/// from the judged lines, as those of the result files are; coordinates are local, binary arrays
/// base64 of little-endian values. `scenes`: one per patch.
evaluate::Json report_json(const ReportInput& input,
                           const std::vector<ShownScene>& scenes,
                           const std::optional<evaluate::GateReport>& gates);

}  // namespace ridgeline::apps
