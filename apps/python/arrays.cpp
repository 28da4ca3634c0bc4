// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/arrays.h"

#include "reconstruct/geometry/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace ridgeline::python {
namespace py = pybind11;

py::array_t<double> nan_array(std::vector<py::ssize_t> shape) {
  py::array_t<double> array(std::move(shape));
  std::fill_n(array.mutable_data(), array.size(), std::numeric_limits<double>::quiet_NaN());
  return array;
}

py::str python_text(const std::string& text) {
  PyObject* decoded =
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace");
  if (decoded == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

std::string shape_text(const py::array& array) {
  return fmt::format(
      "({})", fmt::join(std::span(array.shape(), static_cast<std::size_t>(array.ndim())), ", "));
}

std::optional<Array<double>> find_array(const py::dict& entries,
                                        const char* name,
                                        const std::vector<py::ssize_t>& shape) {
  if (!entries.contains(name) || entries[name].is_none()) return std::nullopt;
  const auto array = Array<double>::ensure(entries[name]);
  check(static_cast<bool>(array), name, ": must be an array of numbers");
  const auto fits = [&] {
    if (array.ndim() != static_cast<py::ssize_t>(shape.size())) return false;
    for (std::size_t d = 0; d < shape.size(); ++d) {
      if (shape[d] >= 0 && array.shape(static_cast<py::ssize_t>(d)) != shape[d]) return false;
    }
    return true;
  };
  std::vector<std::string> expected;
  expected.reserve(shape.size());
  for (const py::ssize_t size : shape) expected.push_back(size < 0 ? "n" : std::to_string(size));
  check(fits(), name, ": the shape is ", shape_text(array), "; must be ",
        fmt::format("({})", fmt::join(expected, ", ")));
  return array;
}

}  // namespace ridgeline::python
