// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace ridgeline::io {

/// The name in `known` that becomes `name` by the fewest insertions, deletions, replacements or
/// swaps of adjacent letters; the first one in a tie. Throws std::invalid_argument if `known` is
/// empty.
std::string_view nearest_name(std::string_view name, const std::vector<std::string_view>& known);

}  // namespace ridgeline::io
