// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <stdexcept>

namespace ridgeline {

/// Throws std::invalid_argument with the streamed parts unless `condition` holds. Use it only for
/// errors of the caller; the parts are name, value and rule.
template <typename... Parts>
void check(bool condition, const Parts&... parts) {
  if (condition) return;
  std::ostringstream message;
  (message << ... << parts);
  throw std::invalid_argument(message.str());
}

}  // namespace ridgeline
