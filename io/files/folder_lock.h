// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/files/own_files.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace ridgeline::io {

/// Reserves a results folder for one process: `.ridgeline.lock` in it names the process and its
/// computer. The kernel releases the lock when the process ends, however it ends, so that locks are
/// never stale. The last owner in a process removes the file.
///
/// The lock keeps track of the files in the folder that the program wrote: those listed under the
/// key `files` in a record (`run.json`, `simulate.json`, `compare.json`), and those written since.
/// Files that are not yet listed in a record are noted in the lock file, where they remain if a run
/// fails or is killed.
class FolderLock {
 public:
  /// The lock of an existing folder, shared by all its users in this process. Removes temporary
  /// files and folders left in it by killed processes. Throws IoError, naming the owner, if another
  /// process holds the lock, and if the folder cannot be written to.
  static std::shared_ptr<FolderLock> of(const std::filesystem::path& folder);

  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Throws IoError if the file exists but was not written by the program or was changed since.
  /// `name` is relative to the folder. Like the functions below, it is safe to call from several
  /// threads.
  void require_own(const std::string& name) const;
  /// Removes a file if the program wrote it.
  void remove(const std::string& name);

  /// The files that the program wrote, for the key `files` of a record.
  [[nodiscard]] nlohmann::ordered_json own_files() const;
  /// Whether there are changes that are not yet listed in a record.
  [[nodiscard]] bool has_unlisted() const;
  /// Declares that all changes are listed in a record.
  void set_listed();

 private:
  friend void put_in_place(const std::filesystem::path& from, const std::filesystem::path& to);

  explicit FolderLock(const std::filesystem::path& folder);
  /// The lock that this process holds on a folder above a file; null if there is none.
  static std::shared_ptr<FolderLock> above(const std::filesystem::path& file);
  void note(const std::string& name, const std::filesystem::path& content);
  [[nodiscard]] bool is_own(const std::string& name) const;

  std::filesystem::path folder_;
  std::filesystem::path file_;
  int descriptor_ = -1;
  mutable std::mutex mutex_;
  OwnFiles own_;
  bool has_list_ = false;  ///< whether any list of files was found; older versions kept none
  bool has_unlisted_ = false;
};

/// Whether the file is a record of this program. Records may always be replaced, because they
/// cannot list themselves.
bool is_record(const std::filesystem::path& file);

/// Renames a finished file to its final name. If this process holds the lock on its folder, the
/// file is first noted as one of the program's, so that it is recognised even if the process is
/// killed. Throws IoError if that fails, and filesystem_error if the file cannot be renamed.
void put_in_place(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace ridgeline::io
