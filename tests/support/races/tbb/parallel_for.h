// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tbb/blocked_range.h"
#include "tbb/threads.h"

#include <concepts>

namespace tbb {

template <std::integral Index, typename F>
void parallel_for(Index begin, Index end, const F& f) {
  if (begin >= end) return;
  races::for_each_index(static_cast<std::size_t>(end - begin), [&](std::size_t i) {
    f(static_cast<Index>(begin + static_cast<Index>(i)));
  });
}

template <typename Index, typename F>
void parallel_for(const blocked_range<Index>& range, const F& f) {
  races::for_each_index(range.n_pieces(), [&](std::size_t i) { f(range.piece(i)); });
}

}  // namespace tbb
