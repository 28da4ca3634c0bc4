// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::test {

/// A file that the program reads, and the commands that read it. In a command `FILE` stands for its
/// name, `OUT` for the name of an output that is not there yet.
struct BaseFile {
  std::string name;  ///< within the folder
  std::vector<std::vector<std::string>> commands;
};

/// Writes a small valid file of every format that the program reads into a folder that holds a
/// simulated scene and, in `results`, what `run` made of it. `patch` is the id of its patch.
std::vector<BaseFile> write_base_files(const std::filesystem::path& folder,
                                       const std::string& patch);

}  // namespace ridgeline::test
