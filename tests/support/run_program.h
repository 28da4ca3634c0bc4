// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::test {

/// What a program left behind.
struct ProgramResult {
  int exit_code = 0;  ///< 128 + n if signal n ended it, as a shell says
  std::string out, err;
};

/// Runs `program` with `arguments` in `folder`, without a shell and with stdin at /dev/null, and
/// waits for its end. `environment` holds NAME=value pairs that are set on top of this process's.
/// Throws std::system_error if the program cannot be started.
ProgramResult run_program(const std::string& program,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder,
                          const std::vector<std::string>& environment = {});

}  // namespace ridgeline::test
