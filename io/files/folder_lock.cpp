// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/folder_lock.h"

#include "io/error.h"
#include "io/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <map>
#include <mutex>
#include <system_error>

namespace ridgeline::io {
namespace fs = std::filesystem;
namespace {

std::string owner_text() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return fmt::format("process {} on {}", getpid(), host.data());
}

std::string content_of(int descriptor) {
  std::array<char, 512> text{};
  const ssize_t n = pread(descriptor, text.data(), text.size(), 0);
  return n > 0 ? std::string(text.data(), static_cast<std::size_t>(n)) : "another process";
}

/// Whether the path still names the open file. Its last owner may have removed the file after it was opened here.
bool is_in_place(int descriptor, const fs::path& file) {
  struct stat open_file {};
  struct stat named {};
  return fstat(descriptor, &open_file) == 0 && stat(file.c_str(), &named) == 0 &&
         open_file.st_dev == named.st_dev && open_file.st_ino == named.st_ino;
}

/// Opens the lock file, locks it and returns its descriptor. Throws IoError if another process holds the lock, or if
/// the file cannot be opened.
int locked_file(const fs::path& folder, const fs::path& file) {
  constexpr int kMostAttempts = 100;  // a file system may never tell that two names are one file
  for (int attempt = 1;; ++attempt) {
    const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (descriptor < 0) {
      throw IoError(folder.string(),
                    "cannot be written to: " + std::generic_category().message(errno));
    }
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      const std::string owner = content_of(descriptor);
      close(descriptor);
      throw IoError(folder.string(), fmt::format("{} is writing results there; wait for its end or "
                                                 "choose another folder",
                                                 owner));
    }
    // On a file system without locks flock() fails with another error. Results are written there all the same.
    if (is_in_place(descriptor, file) || attempt == kMostAttempts) return descriptor;
    close(descriptor);
  }
}

void remove_left_files(const fs::path& folder) {
  std::error_code error;
  for (auto it = fs::recursive_directory_iterator(folder, error); it != fs::end(it);
       it.increment(error)) {
    constexpr int kDeepest = 1;  // the deepest files are FOLDER/PATCH/FILE
    if (it.depth() >= kDeepest) it.disable_recursion_pending();
    if (is_left_by_dead_process(it->path().filename().string())) {
      it.disable_recursion_pending();
      fs::remove_all(it->path(), error);
    }
    if (error) break;
  }
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder)
    : file_(folder / ".ridgeline.lock"), descriptor_(locked_file(folder, file_)) {
  const std::string owner = owner_text();
  if (ftruncate(descriptor_, 0) == 0) {
    // Only the messages of other processes need the name of the owner, so a failed write is ignored.
    (void)!pwrite(descriptor_, owner.data(), owner.size(), 0);
  }
  remove_left_files(folder);
}

FolderLock::~FolderLock() {
  std::error_code ignored;
  fs::remove(file_, ignored);
  close(descriptor_);
}

std::shared_ptr<FolderLock> FolderLock::of(const fs::path& folder) {
  static std::mutex mutex;
  static std::map<fs::path, std::weak_ptr<FolderLock>> locks;
  const std::scoped_lock guard(mutex);
  std::weak_ptr<FolderLock>& known = locks[fs::canonical(folder)];
  std::shared_ptr<FolderLock> lock = known.lock();
  if (!lock) {
    lock.reset(new FolderLock(folder));  // the constructor is private
    known = lock;
  }
  return lock;
}

}  // namespace ridgeline::io
