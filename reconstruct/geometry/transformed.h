// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <ranges>
#include <type_traits>
#include <vector>

namespace ridgeline {

/// The values of `f` (a function or a pointer to a member) for the elements of a range, in order.
template <std::ranges::sized_range Range, typename F>
auto transformed(const Range& range, F f) {
  using Value = std::invoke_result_t<F&, std::ranges::range_reference_t<const Range>>;
  std::vector<std::remove_cvref_t<Value>> values;
  values.reserve(std::ranges::size(range));
  std::ranges::transform(range, std::back_inserter(values), std::move(f));
  return values;
}

}  // namespace ridgeline
