// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/faces/face.h"

#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// The kind of surface that a name of faces states: kRoof for "RoofSurface", "Roof.001",
/// "house_1 roof" or "Dach". kUnknown if it states none; the last one if it states several.
FaceKind surface_kind_in(std::string_view name);

/// The words of a name of faces without kinds of surface: "house_1" for "house_1_RoofSurface". A
/// word is left out if the rest of it has no letter, as that of "Roof.001".
std::vector<std::string> words_without_surfaces(std::string_view name);

}  // namespace ridgeline::io
