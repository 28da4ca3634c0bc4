// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace ridgeline::reconstruct {

/// The curve of a normal distribution, 1 at z = 0.
inline double bell(double z) { return std::exp(-0.5 * z * z); }

}  // namespace ridgeline::reconstruct
