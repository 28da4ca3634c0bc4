// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/support/random.h"

#include <string>

namespace ridgeline::test {

/// A damaged copy of a file's content, as disks, transfers, programs and attackers damage files:
/// bytes flipped, the end cut off, a part left out or repeated, a number of the header at its
/// extremes, a number of a text huge, tiny, missing or no number at all. Which damage and where
/// follows from `random`.
std::string mutated(std::string content, Random& random);

}  // namespace ridgeline::test
