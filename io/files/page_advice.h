// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

namespace ridgeline::io {

/// Gives the system one of madvise(2)'s hints for the pages that lie whole in a range of memory. The hint changes no
/// byte, whether the system takes it or not.
void advise_whole_pages(std::span<const std::byte> range, int advice);

}  // namespace ridgeline::io
