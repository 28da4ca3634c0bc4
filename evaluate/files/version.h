// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ridgeline::results {

extern const char* const kVersion;
/// The commit that the program is built from; "unknown" outside of a checkout. Its value is in a
/// source of its own, so that a commit makes no other source compile again.
extern const char* const kGitHash;

}  // namespace ridgeline::results
