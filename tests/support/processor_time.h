// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>

namespace ridgeline::test {

/// The processor time of this process so far, which other programs on the machine hardly change.
inline double processor_s() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

}  // namespace ridgeline::test
