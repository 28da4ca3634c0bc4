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

/// Whether the images show the line on none of the chosen planes: off across it by 5 px at one end or by
/// 3.5 px at both. Not without images.
bool is_contradicted(std::span<const CandidatePlane> candidates,
                     const EdgeDecision& decision,
                     const std::optional<ImageEvidence>& images);

/// Says so if a chosen plane is known less well at the middle of the line than three laser points there would
/// tell, by PlaneFit::sigma_at(); nothing else.
std::optional<std::string> reason_too_little_known(std::span<const CandidatePlane> candidates,
                                                   const EdgeDecision& decision,
                                                   const Footprint& footprint,
                                                   const JudgeOptions& options);

/// Why the planes that were chosen for a line may be the wrong ones: the line is ambiguous then. Nothing if there is no such reason.
///
///   - reason_too_little_known(): a few points aside that happen to lie in a plane.
///   - Points stand on the chosen surface along the line that no plane explains: a hedge, a parapet, or a
///     fence, which has few points but these in the line; two, if the images show the line off the surface.
///   - The images show the line on none of the chosen planes, and there are points beside it that no
///     plane explains, or the cloud has nothing on one side of it. Such a line lies in an alley or on a
///     wall, or it is wrong: the cloud does not tell.
///
/// Without images only the first two are looked for. The line's height plays no part but by the images.
/// @param zone      the points beside the line
/// @param decision  one that evaluates
std::optional<std::string> reason_for_doubt(std::span<const ZonePoint> zone,
                                            std::span<const CandidatePlane> candidates,
                                            const EdgeDecision& decision,
                                            const Footprint& footprint,
                                            const std::optional<ImageEvidence>& images,
                                            const JudgeOptions& options);

}  // namespace ridgeline::evaluate
