// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/chio_wang2000/extensions.h"

namespace ridgeline::test {

/// What goes beyond the paper, but the appearance of candidates as it is.
inline const reconstruct::ChioExtensions kOurExtensions{
    {}, reconstruct::NoiseAllowance{}, reconstruct::ChoiceByAppearance{}};

}  // namespace ridgeline::test
