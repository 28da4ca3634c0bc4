// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/files/made_folders.h"

#include <fstream>
#include <ostream>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// An output file that is written completely or not at all: bytes go to a temporary file in the
/// same folder, which commit() renames to `path`. Without commit() nothing is left behind and an
/// existing file at `path` is kept. Missing folders are created. A symbolic link is replaced; the
/// file that it points to is not changed. Devices and pipes such as /dev/stdout are never replaced:
/// commit() appends the bytes to them.
class AtomicFile {
 public:
  /// Throws IoError if the folder cannot be created or written to.
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Binary stream to write to. Failed writes are reported by commit().
  [[nodiscard]] std::ostream& stream() { return stream_; }

  /// For libraries that need a file name: the file to write instead of using stream().
  [[nodiscard]] const std::string& temporary_path() const { return temporary_path_; }

  /// Throws IoError if a write (for example, on a full disk) or the rename failed; `path` is then
  /// unchanged.
  void commit();

 private:
  void send_to_device();

  std::string path_;
  bool is_device_;
  std::string temporary_path_;
  MadeFolders folders_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Whether the path is not a file of its own: a device, a pipe, or a link such as /dev/stdout to
/// something that a shell has opened.
bool is_device(const std::string& path);

/// Whether this is the name of a temporary file of AtomicFile or of a ScratchFolder whose process,
/// on this computer, has ended.
bool is_left_by_dead_process(const std::string& file_name);

/// Writes `content` to `path`, completely or not at all. Throws IoError under the same conditions
/// as AtomicFile.
void write_file(const std::string& path, std::string_view content);

}  // namespace ridgeline::io
