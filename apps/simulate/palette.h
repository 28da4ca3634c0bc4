// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/appearance.h"

namespace ridgeline::simulate {

/// Diffuse reflectance of a material; `key` selects one of the variants common in a village.
Spectrum base_reflectance(Material material, bool flat_roof, std::uint32_t key);

}  // namespace ridgeline::simulate
