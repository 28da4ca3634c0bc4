// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>

namespace ridgeline::test {

/// The processor time used by this process so far; other programs on the machine hardly affect it.
inline double processor_s() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

}  // namespace ridgeline::test
