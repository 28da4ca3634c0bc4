// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ridgeline::evaluate {

/// Silences PCL as long as an object of this class exists, in any thread: PCL reports every
/// degenerate sample on stderr and has a single verbosity level for all threads. All code that
/// calls PCL holds such an object; the objects may be nested. The original level is restored when
/// the last one is destroyed.
class QuietPcl {
 public:
  QuietPcl();
  ~QuietPcl();
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;
};

}  // namespace ridgeline::evaluate
