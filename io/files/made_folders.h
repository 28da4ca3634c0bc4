// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace ridgeline::io {

/// Creates a folder and its missing parents. The destructor removes the created folders that are
/// empty, so that a failed command leaves no trace.
class MadeFolders {
 public:
  /// Throws IoError if the folder cannot be created or is a file. An empty path creates nothing.
  explicit MadeFolders(const std::filesystem::path& folder);
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< deepest first
};

}  // namespace ridgeline::io
