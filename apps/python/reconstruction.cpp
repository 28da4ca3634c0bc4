// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/check_pair.h"
#include "apps/pipeline/open_patch.h"
#include "apps/pipeline/parameters.h"
#include "apps/pipeline/patch_scene.h"
#include "apps/pipeline/reconstructed_lines.h"
#include "apps/python/bindings.h"
#include "apps/python/entries.h"
#include "apps/python/interruptible.h"
#include "apps/python/lines.h"
#include "apps/python/views.h"
#include "io/project/patch.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/reconstruct.h"
#include "reconstruct/scene/normalised_image.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::python {
namespace py = pybind11;
namespace {

reconstruct::Options options_of(const py::dict& entries) {
  apps::ParameterArguments arguments;
  take(entries, "preset", arguments.preset);
  take(entries, "config", arguments.config);
  take(entries, "config_text", arguments.config_text);
  check(arguments.preset == "default" || arguments.preset == "published",
        "preset: ", arguments.preset, "; must be default or published");
  reconstruct::Options options = read_parameters(arguments).method;
  std::string method = apps::default_methods(arguments).back();
  take(entries, "method", method);
  options.estimation.lines.method = apps::method_named(method);
  apps::check_preset(arguments, {options.estimation.lines.method});
  std::string matcher = "pairwise";
  take(entries, "matcher", matcher);
  options.matching.matcher = apps::matcher_named(matcher);
  return options;
}

/// Reconstructs the lines of a patch. `read` returns the normalised images, which are checked
/// against their cameras.
template <typename Read>
py::dict lines_of(const io::Patch& patch, const reconstruct::Options& options, const Read& read) {
  return dict_of(interruptibly([&] {
    reconstruct::Scene scene = in_local_frame(apps::patch_scene(patch, read()));
    std::vector<std::string> doubts =
        apps::check_matched_pairs(patch, scene, options, apps::kDefaultMaxYParallax_px);
    const reconstruct::Reconstruction found = reconstruct::reconstruct(std::move(scene), options);
    io::LineSet set =
        apps::line_set_of(found.lines, found.scene, patch.crs, options.estimation.lines.method,
                          options.estimation.lines.max_aligned_angle_deg);
    std::ranges::move(apps::notes_on(patch), std::back_inserter(set.warnings));
    std::ranges::move(doubts, std::back_inserter(set.warnings));
    std::ranges::move(apps::image_warnings(patch, found.scene), std::back_inserter(set.warnings));
    return set;
  }));
}

/// Reconstructs the lines from views in memory. `entries`: those of patch_of_views() and `images`,
/// a list of contiguous arrays.
py::dict reconstruct_views(const py::dict& entries) {
  const io::Patch patch = patch_of_views(entries);
  const auto arrays = entries["images"].cast<std::vector<py::array>>();
  std::vector<cv::Mat> raw;
  for (std::size_t i = 0; i < patch.images.size(); ++i)
    raw.push_back(image_of(arrays.at(i), patch.images[i].id));
  return lines_of(patch, options_of(entries), [&] {
    return transformed(raw, [](const cv::Mat& image) {
      return apps::PatchPicture{reconstruct::normalised_image(image), {}};
    });
  });
}

py::dict reconstruct_patch(const std::string& path, const py::dict& entries) {
  const io::Patch patch = apps::open_patch(path);
  return lines_of(patch, options_of(entries), [&] { return apps::patch_images(patch); });
}

}  // namespace

void add_reconstruction(py::module_& core) {
  core.def("reconstruct_views", &reconstruct_views, py::arg("options"));
  core.def("reconstruct_patch", &reconstruct_patch, py::arg("path"), py::arg("options"));
}

}  // namespace ridgeline::python
