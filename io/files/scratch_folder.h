// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace ridgeline::io {

/// A temporary folder for formats with several files, or for libraries that need the final name. It
/// is created next to the target, on the same disk, so that finished files can be renamed into
/// place. The destructor removes it with any remaining files. For a single file that we write
/// ourselves, AtomicFile is sufficient.
class ScratchFolder {
 public:
  /// Creates missing folders. Throws IoError naming `target` if that fails or writing is not
  /// permitted.
  explicit ScratchFolder(const std::string& target);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// The path to write to; publish() moves it to `target`.
  [[nodiscard]] std::string draft() const;

  /// Moves all files of the folder to the target's folder, replacing existing ones. The target
  /// itself is moved last, so that once it exists, all files are complete. Throws IoError.
  void publish() const;

 private:
  std::filesystem::path target_;
  std::filesystem::path folder_;
};

}  // namespace ridgeline::io
