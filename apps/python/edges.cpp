// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/bindings.h"
#include "apps/python/clouds.h"
#include "apps/python/entries.h"
#include "apps/python/interruptible.h"
#include "apps/python/lines.h"
#include "evaluate/files/plan_scale.h"
#include "evaluate/files/scan_cells.h"
#include "evaluate/files/scan_lines.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace ridgeline::python {
namespace py = pybind11;
namespace {

/// The edges of a cloud as a dict of lines, see dict_of().
py::dict edges_of(const py::object& cloud, const py::dict& entries) {
  const io::ReadOptions options = read_options(entries);
  bool scale_to_ground = false;
  std::uint64_t cloud_memory_mib = 512;
  double min_length_m = 0.0;
  evaluate::ScanOptions scan;
  take(entries, "scale_to_ground", scale_to_ground);
  take(entries, "cloud_memory_mib", cloud_memory_mib);
  take(entries, "min_length_m", min_length_m);
  take(entries, "only_roofs", scan.only_roofs);
  scan.only_roofs = scan.only_roofs || results::keeps_only_buildings(options);
  const CloudInput input = cloud_input(cloud, entries);
  return dict_of(interruptibly([&] {
    io::CloudFiles files = input.open(options);
    std::vector<std::string> warnings;
    results::set_plan_scale(scale_to_ground, files, warnings);
    results::EdgesOfCloud found =
        results::edges_of_cloud(files, {}, cloud_memory_mib << 20U, {}, scan);
    require_points(found.readings, files);
    results::drop_short_edges(min_length_m, found.edges);
    io::LineSet lines = results::lines_of_scan(found.edges, files);
    lines.warnings = std::move(warnings);
    std::ranges::move(found.readings.cloud.warnings, std::back_inserter(lines.warnings));
    return lines;
  }));
}

}  // namespace

void add_edges(py::module_& core) {
  core.def("edges", &edges_of, py::arg("cloud"), py::arg("options"));
}

}  // namespace ridgeline::python
