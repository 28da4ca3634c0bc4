// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/report_input.h"
#include "apps/report/shown_planes.h"
#include "evaluate/gates/gate.h"

#include <optional>
#include <vector>

namespace ridgeline::apps {

/// The contents of a patch's 3D view in addition to its points: for each method, the planes of its
/// lines.
struct ShownScene {
  std::vector<ShownPlanes> methods;
};

ShownScene shown_scene(const ReportPatch& patch);

/// The data of the page, as declared in apps/report/web/src/data/schema.ts. Figures are computed
/// from the judged lines, like those in the result files. Coordinates are local; binary arrays are
/// base64 of little-endian values. `scenes`: one per patch.
evaluate::Json report_json(const ReportInput& input,
                           const std::vector<ShownScene>& scenes,
                           const std::optional<evaluate::GateReport>& gates);

}  // namespace ridgeline::apps
