// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tbb/threads.h"

#include <iterator>

namespace tbb {

template <typename Range, typename F>
void parallel_for_each(Range&& range, const F& f) {
  races::for_each_index(static_cast<std::size_t>(std::size(range)), [&](std::size_t i) {
    f(*std::next(std::begin(range), static_cast<std::ptrdiff_t>(i)));
  });
}

}  // namespace tbb
