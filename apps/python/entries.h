// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace ridgeline::python {

/// Sets `value` if the dict has an entry of that name other than None. Throws TypeError for another type.
template <typename T>
void take(const pybind11::dict& entries, const char* name, T& value) {
  if (!entries.contains(name) || entries[name].is_none()) return;
  try {
    value = entries[name].cast<T>();
  } catch (const pybind11::cast_error&) {
    throw pybind11::type_error(std::string(name) + ": " +
                               pybind11::repr(entries[name]).cast<std::string>() +
                               ", is of another type");
  }
}

}  // namespace ridgeline::python
