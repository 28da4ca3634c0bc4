// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tbb/blocked_range.h"
#include "tbb/threads.h"

#include <vector>

namespace tbb {

template <typename Index, typename Value, typename Add, typename Join>
Value parallel_reduce(const blocked_range<Index>& range,
                      const Value& identity,
                      const Add& add,
                      const Join& join) {
  std::vector<Value> parts(range.n_pieces(), identity);
  races::for_each_index(parts.size(),
                        [&](std::size_t i) { parts[i] = add(range.piece(i), identity); });
  Value sum = identity;
  for (const Value& part : parts) sum = join(sum, part);
  return sum;
}

}  // namespace tbb
