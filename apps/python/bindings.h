// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

// Parts of the extension module `ridgeline._core`. Its interface uses arrays, dicts and texts; the
// classes for users are defined in Python (folder ridgeline).
namespace ridgeline::python {

void add_exceptions(pybind11::module_& core);
void add_endings();
void add_clouds(pybind11::module_& core);
void add_lines(pybind11::module_& core);
void add_evaluation(pybind11::module_& core);
void add_edges(pybind11::module_& core);
void add_gates(pybind11::module_& core);
void add_reconstruction(pybind11::module_& core);

}  // namespace ridgeline::python
