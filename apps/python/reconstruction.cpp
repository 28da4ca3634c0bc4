// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/check_pair.h"
#include "apps/common/parameters.h"
#include "apps/common/patch_matchers.h"
#include "apps/common/patch_views.h"
#include "apps/common/reconstructed_lines.h"
#include "apps/python/bindings.h"
#include "apps/python/entries.h"
#include "apps/python/interruptible.h"
#include "apps/python/lines.h"
#include "apps/python/views.h"
#include "io/patch.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/reconstruct.h"
#include "reconstruct/views/normalised_image.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
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

py::dict lines_of(std::span<const View> views,
                  const std::array<double, 2>& height_range_m,
                  const reconstruct::Options& options,
                  const io::Crs& crs,
                  const std::optional<std::string>& warning = {}) {
  return dict_of(interruptibly([&] {
    const reconstruct::Reconstruction found =
        reconstruct::reconstruct(views, height_range_m, options);
    io::LineSet set = apps::line_set_of(found.pairs.front().lines, found.frame, crs,
                                        options.estimation.lines.method);
    if (warning) set.warnings.push_back(*warning);
    return set;
  }));
}

/// The images of a patch are checked against its cameras.
py::dict lines_of_patch(const io::PatchFile& patch,
                        const std::array<cv::Mat, 2>& images,
                        const reconstruct::Options& options) {
  std::optional<std::string> warning;
  const std::vector<View> views = interruptibly([&] {
    warning = apps::check_pair(patch, images, apps::kDefaultMaxYParallax_px);
    return apps::patch_views(patch, images);
  });
  return lines_of(views, patch.height_range_m, options, patch.crs, warning);
}

/// `entries`: those of patch_of_views(), and `images`, a list of contiguous arrays.
py::dict reconstruct_views(const py::dict& entries) {
  const io::PatchFile patch = patch_of_views(entries);
  const reconstruct::Options options = options_of(entries);
  const auto arrays = entries["images"].cast<std::vector<py::array>>();
  std::array<cv::Mat, 2> images;
  for (std::size_t i = 0; i < images.size(); ++i) {
    images[i] = reconstruct::normalised_image(image_of(arrays.at(i), patch.images[i].id));
  }
  return lines_of_patch(patch, images, options);
}

py::dict reconstruct_patch(const std::string& path, const py::dict& entries) {
  const reconstruct::Options options = options_of(entries);
  const io::PatchFile patch = io::read_patch(path);
  return lines_of_patch(patch, interruptibly([&] {
                          apps::check_patch(patch);
                          return apps::patch_images(patch);
                        }),
                        options);
}

}  // namespace

void add_reconstruction(py::module_& core) {
  core.def("reconstruct_views", &reconstruct_views, py::arg("options"));
  core.def("reconstruct_patch", &reconstruct_patch, py::arg("path"), py::arg("options"));
}

}  // namespace ridgeline::python
