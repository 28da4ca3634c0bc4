// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ridgeline::results {

extern const char* const kVersion;
/// The commit that the program is built from; "unknown" outside a checkout. It is defined in a
/// separate source file, so that a new commit recompiles only that file.
extern const char* const kGitHash;

}  // namespace ridgeline::results
