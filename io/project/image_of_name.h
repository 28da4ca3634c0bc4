// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"

#include <cstddef>
#include <optional>
#include <string>

namespace ridgeline::io {

/// The number in Orientation::images of the image that `name` means, or nothing if there is none: the one of this name; else the one with its last
/// part, behind folders; else the one with its last part without the extension, as many programs leave that out.
/// Throws std::invalid_argument, which names images of the orientation, if several are meant.
std::optional<std::size_t> find_image(const Orientation& orientation, const std::string& name);

/// find_image(); throws std::invalid_argument, which names the nearest images of the orientation, if there is none.
std::size_t image_of_name(const Orientation& orientation, const std::string& name);

}  // namespace ridgeline::io
