// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ridgeline::evaluate {

/// Silences PCL as long as one exists, in any thread: PCL prints every degenerate sample to stderr,
/// and has one level for all threads. Whatever calls PCL holds one; they may be nested. The level
/// before the first one comes back after the last.
class QuietPcl {
 public:
  QuietPcl();
  ~QuietPcl();
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;
};

}  // namespace ridgeline::evaluate
