// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace ridgeline::io {

/// The name in `known` that becomes `name` by the fewest letters put in, left out, replaced or
/// swapped with their neighbour; if several do, the first of them. Throws std::invalid_argument if
/// `known` is empty.
std::string_view nearest_name(std::string_view name, const std::vector<std::string_view>& known);

}  // namespace ridgeline::io
