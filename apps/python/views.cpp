// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/views.h"

#include "apps/python/arrays.h"
#include "apps/python/entries.h"
#include "apps/python/in_memory.h"
#include "reconstruct/geometry/check.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <tuple>
#include <vector>

namespace ridgeline::python {
namespace py = pybind11;

io::Patch patch_of_views(const py::dict& entries) {
  io::Patch patch;
  patch.path = kViewsInMemory;
  patch.id = kViewsInMemory;
  take(entries, "crs", patch.crs.definition);
  (void)io::describe(patch.crs);
  std::vector<double> heights_m;
  take(entries, "height_range_m", heights_m);
  check(heights_m.size() == 2, "height_range_m: ", heights_m.size(),
        " numbers; must be the lowest and the highest height");
  patch.height_range_m = {heights_m[0], heights_m[1]};
  for (const py::handle& view : entries["views"]) {
    const auto [id, matrix] = view.cast<std::tuple<std::string, Array<double>>>();
    check(matrix.ndim() == 2 && matrix.shape(0) == 3 && matrix.shape(1) == 4, "matrix of ", id,
          ": the shape is ", shape_text(matrix), "; must be (3, 4)");
    io::PatchImage& image = patch.images.emplace_back();
    image.id = id;
    image.path = id;
    image.image_from_world = Eigen::Map<const RowMajor<3, 4>>{matrix.data()};
  }
  check(patch.images.size() >= 2, "views: ", patch.images.size(), ", must be two or more");
  return patch;
}

cv::Mat image_of(const py::array& array, const std::string& id) {
  const bool is_byte = py::isinstance<py::array_t<std::uint8_t>>(array);
  check(is_byte || py::isinstance<py::array_t<std::uint16_t>>(array), "image of ", id, ": type ",
        py::str(array.dtype()).cast<std::string>(), "; must be uint8 or uint16");
  const bool has_bands = array.ndim() == 3;
  const int n_bands = has_bands ? static_cast<int>(array.shape(2)) : 1;
  check((array.ndim() == 2 || has_bands) && n_bands >= 1 && n_bands <= 4, "image of ", id,
        ": the shape is ", shape_text(array),
        "; must be (height, width), or (height, width, bands) with 1 to 4 bands");
  return {static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)),
          CV_MAKETYPE(is_byte ? CV_8U : CV_16U, n_bands), const_cast<void*>(array.data())};
}

}  // namespace ridgeline::python
