// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>
#include <type_traits>

namespace ridgeline::python {

/// The name of the type in messages.
template <typename T>
constexpr const char* name_of_type() {
  if constexpr (std::is_same_v<T, bool>) return "True or False";
  if constexpr (std::is_integral_v<T>) return "a whole number";
  if constexpr (std::is_floating_point_v<T>) return "a number";
  if constexpr (std::is_same_v<T, std::string>) return "a text";
  return "a list of numbers or strings";
}

/// Sets `value` if the dict has an entry of that name other than None. Throws std::invalid_argument
/// for an integer out of the type's range, TypeError for a value of another type.
template <typename T>
void take(const pybind11::dict& entries, const char* name, T& value) {
  if (!entries.contains(name) || entries[name].is_none()) return;
  try {
    value = entries[name].cast<T>();
  } catch (const pybind11::cast_error&) {
    const std::string given =
        std::string(name) + " = " + pybind11::repr(entries[name]).cast<std::string>();
    if (std::is_integral_v<T> && pybind11::isinstance<pybind11::int_>(entries[name])) {
      throw std::invalid_argument(given + ", must be neither negative nor huge");
    }
    throw pybind11::type_error(given + ", must be " + name_of_type<T>());
  }
}

}  // namespace ridgeline::python
