// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ridgeline::results {

/// A gates file to start from: every key and every metric explained, limits proposed.
std::string gates_template();

}  // namespace ridgeline::results
