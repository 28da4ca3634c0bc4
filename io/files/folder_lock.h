// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

namespace ridgeline::io {

/// Keeps a folder of results for one process: `.ridgeline.lock` in it names the process and its computer. The
/// kernel gives the lock back when the process ends, however it ends, so that none is ever stale. The last
/// owner in a process removes the file.
class FolderLock {
 public:
  /// The lock of an existing folder, shared by all that ask for it in this process. Removes the temporary files and
  /// folders in it that killed processes have left. Throws IoError if another process holds the lock, which it names, or
  /// if the folder cannot be written to.
  static std::shared_ptr<FolderLock> of(const std::filesystem::path& folder);

  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  explicit FolderLock(const std::filesystem::path& folder);

  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace ridgeline::io
