// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/edge_decision.h"
#include "evaluate/judge/footprint.h"
#include "evaluate/judge/image_evidence.h"
#include "evaluate/judge/options.h"
#include "evaluate/judge/plane_support.h"

#include <optional>
#include <span>
#include <string>

namespace ridgeline::evaluate {

/// Whether the images show the line on none of the chosen planes: it is off across by 5 px at one end, or by
/// 3.5 px at both. False without images.
bool is_contradicted(std::span<const CandidatePlane> candidates,
                     const EdgeDecision& decision,
                     const std::optional<ImageEvidence>& images);

/// The reason for doubt if a chosen plane is known less well at the middle of the line, by
/// PlaneFit::sigma_at(), than from three laser points there. Nothing otherwise.
std::optional<std::string> reason_too_little_known(std::span<const CandidatePlane> candidates,
                                                   const EdgeDecision& decision,
                                                   const Footprint& footprint,
                                                   const JudgeOptions& options);

/// The reason why the planes chosen for a line may be the wrong ones, so that the line is ambiguous. Nothing if there is
/// no such reason.
///
///   - reason_too_little_known(): a few points off the line happen to lie in a plane.
///   - Points that no plane explains stand on the chosen surface along the line: a hedge, a parapet or a
///     fence. A fence has few points, but they lie in the line itself; two points are enough for it if the
///     images show the line off the surface.
///   - The images show the line on none of the chosen planes, and there are points beside it that no
///     plane explains, or the cloud has nothing on one side of it. Such a line lies in an alley or on a
///     wall, or it is wrong: the cloud does not tell.
///
/// Without images only the first two are looked for. The line's height plays no part except through the images.
/// @param zone      the points beside the line
/// @param decision  a decision with the status `evaluated`
std::optional<std::string> reason_for_doubt(std::span<const ZonePoint> zone,
                                            std::span<const CandidatePlane> candidates,
                                            const EdgeDecision& decision,
                                            const Footprint& footprint,
                                            const std::optional<ImageEvidence>& images,
                                            const JudgeOptions& options);

}  // namespace ridgeline::evaluate
