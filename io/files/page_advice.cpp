// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/page_advice.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace ridgeline::io {

void advise_whole_pages(std::span<const std::byte> range, int advice) {
  static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const auto begin = reinterpret_cast<std::uintptr_t>(range.data());
  const std::size_t skipped = (page - begin % page) % page;
  if (range.size() < skipped + page) return;
  const std::size_t size = (range.size() - skipped) / page * page;
  // madvise() takes a pointer that is not const, but does not change the bytes.
  (void)madvise(const_cast<std::byte*>(range.data() + skipped), size, advice);
}

}  // namespace ridgeline::io
