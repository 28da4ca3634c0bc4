// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ridgeline::apps {

/// A gates file to start from. It explains every key and every metric and proposes limits.
std::string gates_template();

}  // namespace ridgeline::apps
