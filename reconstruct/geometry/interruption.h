// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <stdexcept>

namespace ridgeline {

/// Thrown by a computation that was asked to stop. The computation then has no result, not even a
/// partial one.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Stops the long computations of this process, for programs that must respond to their user
/// meanwhile (Ctrl-C in Python). The loops of these computations call check(); a request remains in
/// force until it is cleared.
class Interruption {
 public:
  static void request() { is_requested = true; }
  static void clear() { is_requested = false; }
  [[nodiscard]] static bool is_standing() { return is_requested; }
  /// Throws Interrupted if a request is in force. Any thread may call it; it costs only one memory
  /// read.
  static void check() {
    if (is_requested.load(std::memory_order_relaxed)) throw Interrupted();
  }

 private:
  static inline std::atomic<bool> is_requested = false;
};

}  // namespace ridgeline
