// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/check_pair.h"
#include "apps/common/parameters.h"
#include "apps/common/patch_matchers.h"
#include "apps/common/patch_views.h"
#include "apps/common/reconstructed_lines.h"
#include "apps/python/arrays.h"
#include "apps/python/bindings.h"
#include "apps/python/entries.h"
#include "apps/python/interruptible.h"
#include "apps/python/lines.h"
#include "io/patch.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/reconstruct.h"

#include <pybind11/stl.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::python {
namespace py = pybind11;
namespace {

using reconstruct::View;

reconstruct::Options options_of(const py::dict& entries) {
  apps::ParameterArguments arguments;
  take(entries, "preset", arguments.preset);
  take(entries, "config", arguments.config);
  take(entries, "config_text", arguments.config_text);
  check(arguments.preset == "default" || arguments.preset == "published",
        "preset: ", arguments.preset, "; must be default or published");
  reconstruct::Options options = read_parameters(arguments).method;
  std::string method = name(options.estimation.lines.method);
  take(entries, "method", method);
  options.estimation.lines.method = apps::method_named(method);
  apps::check_preset(arguments, {options.estimation.lines.method});
  std::vector<std::string> matchers{"pairwise"};
  take(entries, "matchers", matchers);
  options.matching.matchers = apps::matchers_named(matchers);
  return options;
}

/// The pixels of an array (height, width) or (height, width, bands) of uint8 or uint16, which must outlive it.
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

py::dict lines_of(std::span<const View> views,
                  const std::array<double, 2>& height_range_m,
                  const reconstruct::Options& options,
                  const io::Crs& crs) {
  return dict_of(interruptibly([&] {
    const reconstruct::Reconstruction found =
        reconstruct::reconstruct(views, height_range_m, options);
    return apps::line_set_of(found.pairs.front().lines, found.frame, crs,
                             options.estimation.lines.method);
  }));
}

/// `views`: tuples (id, image, 3x4 matrix), the images contiguous.
py::dict reconstruct_views(const py::list& views,
                           const std::array<double, 2>& height_range_m,
                           const std::string& crs,
                           const py::dict& entries) {
  std::vector<View> all;
  for (const py::handle& item : views) {
    const auto [id, image, matrix] = item.cast<std::tuple<std::string, py::array, Array<double>>>();
    check(matrix.ndim() == 2 && matrix.shape(0) == 3 && matrix.shape(1) == 4, "matrix of ", id,
          ": the shape is ", shape_text(matrix), "; must be (3, 4)");
    all.push_back({id, image_of(image, id), Eigen::Map<const RowMajor<3, 4>>{matrix.data()}, {}});
  }
  return lines_of(all, height_range_m, options_of(entries), {crs});
}

py::dict reconstruct_patch(const std::string& path, const py::dict& entries) {
  const reconstruct::Options options = options_of(entries);
  const io::PatchFile patch = io::read_patch(path);
  const std::vector<View> views = interruptibly([&] {
    apps::check_patch(patch);
    const std::array<cv::Mat, 2> images = apps::patch_images(patch);
    apps::check_pair(patch, images, apps::kDefaultMaxYParallax_px);
    return apps::patch_views(patch, images);
  });
  return lines_of(views, patch.height_range_m, options, patch.crs);
}

}  // namespace

void add_reconstruction(py::module_& core) {
  core.def("reconstruct_views", &reconstruct_views, py::arg("views"), py::arg("height_range_m"),
           py::arg("crs"), py::arg("options"));
  core.def("reconstruct_patch", &reconstruct_patch, py::arg("path"), py::arg("options"));
}

}  // namespace ridgeline::python
