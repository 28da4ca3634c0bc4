// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <pybind11/numpy.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace ridgeline::python {

template <typename T>
using Array = pybind11::array_t<T, pybind11::array::c_style | pybind11::array::forcecast>;

/// A matrix with the memory layout of a C-ordered array.
template <int R, int C>
using RowMajor = Eigen::Matrix<double, R, C, Eigen::RowMajor>;

/// An array of doubles of this shape, filled with NaN.
pybind11::array_t<double> nan_array(std::vector<pybind11::ssize_t> shape);

/// Converts text from a file to a Python string; invalid UTF-8 bytes are replaced.
pybind11::str python_text(const std::string& text);

/// A list of value_of(row) for every row; texts are converted with python_text().
template <typename Rows, typename ValueOf>
pybind11::list list_of(const Rows& rows, const ValueOf& value_of) {
  pybind11::list list;
  for (const auto& row : rows) {
    if constexpr (std::is_convertible_v<decltype(value_of(row)), std::string>) {
      list.append(python_text(value_of(row)));
    } else {
      list.append(value_of(row));
    }
  }
  return list;
}

/// An array of number(row), or of the data member `number`, for every row; missing numbers are NaN.
template <typename Rows, typename Number>
pybind11::array_t<double> number_array(const Rows& rows, const Number& number) {
  pybind11::array_t<double> array = nan_array({static_cast<pybind11::ssize_t>(rows.size())});
  auto out = array.mutable_unchecked<1>();
  pybind11::ssize_t i = 0;
  for (const auto& row : rows) {
    if (const std::optional<double> value = std::invoke(number, row)) out(i) = *value;
    ++i;
  }
  return array;
}

/// An array (n, R, C) of matrix_of(row), an optional matrix, for every row; missing ones are NaN.
template <int R, int C, typename Rows, typename MatrixOf>
pybind11::array_t<double> matrix_array(const Rows& rows, const MatrixOf& matrix_of) {
  pybind11::array_t<double> array = nan_array({static_cast<pybind11::ssize_t>(rows.size()), R, C});
  double* out = array.mutable_data();
  for (const auto& row : rows) {
    const std::optional<Eigen::Matrix<double, R, C>> matrix = matrix_of(row);
    if (matrix) Eigen::Map<RowMajor<R, C>>{out} = *matrix;
    out += std::ptrdiff_t{R} * C;
  }
  return array;
}

/// The i-th matrix of an array (n, R, C); std::nullopt if its first element is NaN.
template <int R, int C>
std::optional<Eigen::Matrix<double, R, C>> matrix_at(const Array<double>& array, std::size_t i) {
  const double* in = array.data() + static_cast<std::ptrdiff_t>(i) * R * C;
  if (std::isnan(*in)) return std::nullopt;
  return Eigen::Map<const RowMajor<R, C>>{in};
}

/// An entry of a dict of arrays as an array of that shape (-1: any length); std::nullopt for None
/// and a missing key. Throws std::invalid_argument naming the entry for a different shape.
std::optional<Array<double>> find_array(const pybind11::dict& entries,
                                        const char* name,
                                        const std::vector<pybind11::ssize_t>& shape);

/// The shape of an array as text: "(3, 2)".
std::string shape_text(const pybind11::array& array);

}  // namespace ridgeline::python
