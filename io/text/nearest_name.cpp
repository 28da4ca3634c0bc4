// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/nearest_name.h"

#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

namespace ridgeline::io {
namespace {

/// Optimal string alignment distance (Damerau 1964, Levenshtein 1966), row by row.
std::size_t letters_to_change(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t> row(b.size() + 1);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool is_swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = std::move(last);
    last = std::move(row);
  }
  return last.back();
}

}  // namespace

std::string_view nearest_name(std::string_view name, const std::vector<std::string_view>& known) {
  check(!known.empty(), "known names: none");
  std::string_view nearest;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const std::string_view candidate : known) {
    const std::size_t n = letters_to_change(name, candidate);
    if (n >= fewest) continue;
    fewest = n;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace ridgeline::io
