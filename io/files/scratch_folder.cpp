// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/scratch_folder.h"

#include "io/error.h"
#include "io/files/folder_lock.h"

#include <fmt/format.h>
#include <unistd.h>

namespace ridgeline::io {

ScratchFolder::ScratchFolder(const std::string& target)
    : target_(std::filesystem::absolute(target)) {
  std::error_code error;  // mkdtemp() reports a failure
  std::filesystem::create_directories(target_.parent_path(), error);
  // Named like a temporary file, so that FolderLock can find what a killed process has left.
  std::string pattern =
      (target_.parent_path() / fmt::format(".ridgeline.{}.0.tmp.XXXXXX", getpid())).string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw IoError(target, "cannot be written: its folder cannot be created or is not writable");
  }
  folder_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;  // a leftover folder is no reason to lose the result
  std::filesystem::remove_all(folder_, ignored);
}

std::string ScratchFolder::draft() const { return (folder_ / target_.filename()).string(); }

void ScratchFolder::publish() const {
  try {
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      const std::filesystem::path name = entry.path().filename();
      if (name == target_.filename()) continue;
      put_in_place(entry.path(), target_.parent_path() / name);
    }
    put_in_place(draft(), target_);
  } catch (const std::filesystem::filesystem_error& error) {
    throw IoError(target_.string(), "cannot be written: " + error.code().message());
  }
}

}  // namespace ridgeline::io
