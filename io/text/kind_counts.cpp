// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/kind_counts.h"

#include <fmt/format.h>

namespace ridgeline::io {

void KindCounts::add(const LeftOutKind& kind, std::size_t n) {
  if (n == 0) return;
  KindCount& count = counts_[std::string(kind.several)];
  count.one = kind.one;
  count.n += n;
}

void KindCounts::add(const KindCounts& others) {
  for (const auto& [several, count] : others.counts_) add({count.one, several}, count.n);
}

std::string KindCounts::text() const {
  std::string text;
  for (const auto& [several, count] : counts_) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count.n,
                        count.n == 1 ? count.one : several);
  }
  return text;
}

}  // namespace ridgeline::io
