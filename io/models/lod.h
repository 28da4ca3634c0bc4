// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>

namespace ridgeline::io {

/// The level of detail in which a building is read, out of those in which it has faces. `wanted`:
/// see ReadModelOptions::lod. Returns std::nullopt if the building has no such level. Levels
/// without a number rank as 1; among equal ranks, the last one is taken.
std::optional<std::string> chosen_lod(const std::set<std::string>& lods, const std::string& wanted);

}  // namespace ridgeline::io
