// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/files/own_files.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace ridgeline::io {

/// Keeps a folder of results for one process: `.ridgeline.lock` in it names the process and its
/// computer. The kernel gives the lock back when the process ends, however it ends, so that none is
/// ever stale. The last owner in a process removes the file.
///
/// It knows which files of the folder the program wrote: those that a record there lists
/// (`run.json`, `simulate.json`, `compare.json`: the key `files`), and those written since. What no
/// record lists yet is in the lock file, and stays there after a run that failed or was killed.
class FolderLock {
 public:
  /// The lock of an existing folder, shared by all that ask for it in this process. Removes the
  /// temporary files and folders in it that killed processes have left. Throws IoError if another
  /// process holds the lock, which it names, or if the folder cannot be written to.
  static std::shared_ptr<FolderLock> of(const std::filesystem::path& folder);

  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Throws IoError if somebody else wrote or changed the file. `name` is relative to the folder.
  /// May be called by several threads, as all that follows.
  void require_own(const std::string& name) const;
  /// Removes a file of the program.
  void remove(const std::string& name);

  /// The program's files, for the key `files` of a record.
  [[nodiscard]] nlohmann::ordered_json own_files() const;
  /// Whether there are changes that no record lists.
  [[nodiscard]] bool has_unlisted() const;
  /// Says that a record lists all.
  void set_listed();

 private:
  friend void put_in_place(const std::filesystem::path& from, const std::filesystem::path& to);

  explicit FolderLock(const std::filesystem::path& folder);
  /// The lock that this process holds of a folder above a file; nothing if there is none.
  static std::shared_ptr<FolderLock> above(const std::filesystem::path& file);
  void note(const std::string& name, const std::filesystem::path& content);
  [[nodiscard]] bool is_own(const std::string& name) const;

  std::filesystem::path folder_;
  std::filesystem::path file_;
  int descriptor_ = -1;
  mutable std::mutex mutex_;
  OwnFiles own_;
  bool has_list_ = false;  ///< whether a record lists files; those of older versions do not
  bool has_unlisted_ = false;
};

/// Whether the file is a record of this program, which may be replaced whatever it holds: it cannot
/// list itself.
bool is_record(const std::filesystem::path& file);

/// Renames a finished file onto its place. In a folder that this process holds the lock of, it is
/// noted before as one of the program's, so that it is known after a kill. Throws IoError, and
/// filesystem_error if the file cannot be renamed.
void put_in_place(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace ridgeline::io
