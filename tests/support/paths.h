// SPDX-License-Identifier: BSD-3-Clause
// Paths of files that tests use but do not create. Only one source file contains these paths, so
// the object files of all others are the same in every checkout and a compiler cache can serve
// them.
#pragma once

#include <string>

namespace ridgeline::test {

std::string source_dir();       ///< the checkout
std::string shared_data_dir();  ///< real data next to the checkout; if it is missing, a test is
                                ///< skipped with a message
std::string program();          ///< the built `ridgeline`

}  // namespace ridgeline::test
