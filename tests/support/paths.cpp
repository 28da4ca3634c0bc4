// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/paths.h"

namespace ridgeline::test {

std::string source_dir() { return RIDGELINE_SOURCE_DIR; }
std::string shared_data_dir() { return source_dir() + "/../shared/data"; }
std::string program() { return RIDGELINE_BINARY; }

}  // namespace ridgeline::test
