// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>

namespace ridgeline::io {

/// The level of detail in which a building is read, of those that it has with faces. `wanted`: see
/// ReadModelOptions::lod. Nothing if the building has no such level. Of levels without a number the
/// last one is taken if there is no other.
std::optional<std::string> chosen_lod(const std::set<std::string>& lods, const std::string& wanted);

}  // namespace ridgeline::io
