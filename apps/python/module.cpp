// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/bindings.h"
#include "evaluate/files/version.h"

PYBIND11_MODULE(_core, core) {
  using namespace ridgeline;
  core.attr("version") = results::kVersion;
  python::add_exceptions(core);
  python::add_endings();
  python::add_clouds(core);
  python::add_lines(core);
  python::add_evaluation(core);
  python::add_edges(core);
  python::add_gates(core);
  python::add_reconstruction(core);
}
