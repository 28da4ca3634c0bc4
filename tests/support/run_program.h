// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RIDGELINE_IS_SANITIZED true
#endif
#endif
#ifndef RIDGELINE_IS_SANITIZED
#define RIDGELINE_IS_SANITIZED false
#endif
/// Whether the programs are built with the address sanitizer, whose own memory use exceeds memory
/// limits.
inline constexpr bool kIsSanitized = RIDGELINE_IS_SANITIZED;

/// The outcome of a program that has ended.
struct ProgramResult {
  int exit_code = 0;  ///< 128 + n if signal n ended it, as in a shell
  std::string out, err;
  double processor_s = 0.0;  ///< of all threads; other programs on the machine hardly affect it
  double peak_memory_mib = 0.0;
};

/// Runs `program` with `arguments` in `folder`, without a shell and with stdin at /dev/null, and
/// waits until it ends. `environment` holds NAME=value pairs that are set in addition to the
/// environment of this process. With a `processor_limit_s` above 0, SIGXCPU ends the program once
/// its threads together have used that time, however busy the machine is, and SIGALRM ends it if it
/// waits for much longer. Throws std::system_error if the program cannot be started.
ProgramResult run_program(const std::string& program,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder,
                          const std::vector<std::string>& environment = {},
                          unsigned processor_limit_s = 0);

}  // namespace ridgeline::test
