// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string_view>

namespace ridgeline::evaluate {

inline constexpr std::string_view kLinesMethod = "lines";
inline constexpr std::string_view kPlanesMethod = "planes";
/// The reconstruction methods, best first.
inline constexpr std::array<std::string_view, 5> kMethodsByRank{kLinesMethod, "network", "joint",
                                                                "direct", kPlanesMethod};

/// Whether a line is one that has no visible edge, where two planes of the surface derived from the
/// images meet: "p7", in a block "PATCH/p7". Its number depends on all other lines of the run and
/// has no meaning in another one.
inline bool is_of_planes(std::string_view method, std::string_view id) {
  id.remove_prefix(id.rfind('/') + 1);  // npos + 1 is 0
  return (method == kLinesMethod || method == kPlanesMethod) && id.size() > 1 && id[0] == 'p' &&
         id.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

/// The index of the product among the methods of a run, i.e. of the method whose lines are the
/// purpose of the run; the others are baselines. It is the best one: `lines`, `network`, `joint`,
/// `direct`, `planes`, then any other. 0 if there are none.
/// @param name  gives the name of a method, as invoked by std::invoke()
template <typename Methods, typename Projection = std::identity>
std::size_t product_index(const Methods& methods, Projection name = {}) {
  const auto rank = [&](const auto& method) {
    return std::ranges::find(kMethodsByRank, std::string_view(std::invoke(name, method))) -
           kMethodsByRank.begin();
  };
  return static_cast<std::size_t>(std::ranges::min_element(methods, {}, rank) - methods.begin());
}

}  // namespace ridgeline::evaluate
