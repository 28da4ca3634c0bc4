// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/info/info_warnings.h"

#include <string>

namespace ridgeline::apps {

/// The facts of an image, "970 x 977 px, 3 bands of 8 bit, GTiff", or "missing". Throws IoError
/// like io::image_facts().
std::string image_text(const std::string& path);

/// Prints the facts of an image, its radiometry and the sharpness at its centre. Throws IoError
/// like io::image_facts(); pixels that cannot be decoded give a warning.
void print_image(const std::string& path, InfoWarnings& warnings);

}  // namespace ridgeline::apps
