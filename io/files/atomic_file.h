// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/files/made_folders.h"

#include <fstream>
#include <ostream>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// An output file that appears whole or not at all: bytes go to a temporary file in the same
/// folder, commit() renames it onto `path`. Without commit() nothing is left and what stood at
/// `path` stays. Missing folders are made. A symbolic link is replaced, and the file that it names
/// stays as it is. What is no file, as /dev/stdout or a pipe, is never replaced: commit() appends
/// the bytes there.
class AtomicFile {
 public:
  /// Throws IoError if the folder cannot be made or written to.
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// For writing; binary. Failed writes show in commit().
  [[nodiscard]] std::ostream& stream() { return stream_; }

  /// For a library that writes by name: the file to write in place of stream().
  [[nodiscard]] const std::string& temporary_path() const { return temporary_path_; }

  /// Throws IoError if a write failed (a full disk) or the rename does; `path` is untouched then.
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

/// Whether the path is no file of its own: a device, a pipe, or a link such as /dev/stdout to what
/// a shell has opened.
bool is_device(const std::string& path);

/// Whether a name is that of an AtomicFile's temporary file or of a ScratchFolder whose process, on
/// this computer, has ended.
bool is_left_by_dead_process(const std::string& file_name);

/// Writes `content` to `path`, whole or not at all. Throws IoError as AtomicFile.
void write_file(const std::string& path, std::string_view content);

}  // namespace ridgeline::io
