// SPDX-License-Identifier: BSD-3-Clause
// Paths of what tests use but do not make themselves. One source knows these paths, so that the
// objects of all others are the same in every checkout and a compiler cache serves them.
#pragma once

#include <string>

namespace ridgeline::test {

std::string source_dir();       ///< the checkout
std::string shared_data_dir();  ///< real data beside the checkout; a test skips with a message
                                ///< where it is absent
std::string program();          ///< the built `ridgeline`

}  // namespace ridgeline::test
