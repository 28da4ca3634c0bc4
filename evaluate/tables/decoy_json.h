// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/cloud_following.h"
#include "evaluate/statistics/decoy_figures.h"
#include "evaluate/tables/summary_json.h"

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// The figures of the decoys in the format of `evaluation.METHOD.json`, one object per kind and
/// distance.
Json decoys_json(std::span<const DecoyFigure> decoys);
/// Reads the output of decoys_json(). Throws std::invalid_argument "what: value; rule" for anything
/// else.
std::vector<DecoyFigure> parse_decoys(const Json& json);

/// The comparison with the same lines elsewhere; null if it was not made.
Json following_json(const std::optional<CloudFollowing>& following);
/// Reads the output of following_json(). Throws like parse_decoys().
std::optional<CloudFollowing> parse_following(const Json& json);

}  // namespace ridgeline::evaluate
