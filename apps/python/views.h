// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <opencv2/core/mat.hpp>
#include <pybind11/numpy.h>

#include <string>

namespace ridgeline::python {

/// A patch without files from oriented images in memory. Entries: `views`, a list of tuples (id,
/// 3x4 matrix), `height_range_m` and `crs`. Throws std::invalid_argument for invalid values.
io::Patch patch_of_views(const pybind11::dict& entries);

/// An image that refers to the pixels of an array (height, width) or (height, width, bands) of
/// uint8 or uint16; the array must outlive it. Throws std::invalid_argument naming `id` for any
/// other array.
cv::Mat image_of(const pybind11::array& array, const std::string& id);

}  // namespace ridgeline::python
