// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/cloud_following.h"
#include "evaluate/statistics/decoy_figures.h"
#include "evaluate/tables/summary_json.h"

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// The figures of the decoys as `evaluation.METHOD.json` holds them, one object for each kind and
/// distance.
Json decoys_json(std::span<const DecoyFigure> decoys);
/// Reads what decoys_json() wrote. Throws std::invalid_argument "what: value; rule" for anything
/// else.
std::vector<DecoyFigure> parse_decoys(const Json& json);

/// The comparison with the same lines elsewhere; null if there is none.
Json following_json(const std::optional<CloudFollowing>& following);
/// Reads what following_json() wrote. Throws as parse_decoys().
std::optional<CloudFollowing> parse_following(const Json& json);

}  // namespace ridgeline::evaluate
