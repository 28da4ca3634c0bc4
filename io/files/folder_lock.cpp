// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/folder_lock.h"

#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/files/text_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <map>
#include <sstream>
#include <system_error>
#include <vector>

namespace ridgeline::io {
namespace fs = std::filesystem;
namespace {

std::string owner_text() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return fmt::format("process {} on {}", getpid(), host.data());
}

/// The lines of the open lock file: the owner and the owner's notes.
std::vector<std::string> lines_of(int descriptor) {
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t n = 0;
       (n = pread(descriptor, part.data(), part.size(), static_cast<off_t>(text.size()))) > 0;)
    text.append(part.data(), static_cast<std::size_t>(n));
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string owner_of(int descriptor) {
  const std::vector<std::string> lines = lines_of(descriptor);
  return lines.empty() ? "another process" : lines.front();
}

/// Whether the path still refers to the open file. Its last owner may have removed the file after
/// it was opened here.
bool is_in_place(int descriptor, const fs::path& file) {
  struct stat open_file {};
  struct stat named {};
  return fstat(descriptor, &open_file) == 0 && stat(file.c_str(), &named) == 0 &&
         open_file.st_dev == named.st_dev && open_file.st_ino == named.st_ino;
}

/// Opens the lock file, locks it and returns its descriptor. Throws IoError if another process
/// holds the lock, or if the file cannot be opened.
int locked_file(const fs::path& folder, const fs::path& file) {
  constexpr int kMaxAttempts = 100;  // some file systems never report two names as one file
  for (int attempt = 1;; ++attempt) {
    const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (descriptor < 0) {
      throw IoError(folder.string(),
                    "cannot be written to: " + std::generic_category().message(errno));
    }
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      const std::string owner = owner_of(descriptor);
      close(descriptor);
      throw IoError(
          folder.string(),
          fmt::format("{} is writing results there; wait until it ends or choose another folder",
                      owner));
    }
    // On a file system without locks, flock() fails with a different error. Results are written
    // nevertheless.
    if (is_in_place(descriptor, file) || attempt == kMaxAttempts) return descriptor;
    close(descriptor);
  }
}

void remove_left_files(const fs::path& folder) {
  std::error_code error;
  for (auto it = fs::recursive_directory_iterator(folder, error); it != fs::end(it);
       it.increment(error)) {
    constexpr int kMaxDepth = 1;  // the deepest files are FOLDER/PATCH/FILE
    if (it.depth() >= kMaxDepth) it.disable_recursion_pending();
    if (is_left_by_dead_process(it->path().filename().string())) {
      it.disable_recursion_pending();
      fs::remove_all(it->path(), error);
    }
    if (error) break;
  }
}

/// The locks of this process, by canonical folder.
struct Registry {
  std::mutex mutex;
  std::map<fs::path, std::weak_ptr<FolderLock>> locks;
};

Registry& registry() {
  static Registry of_process;
  return of_process;
}

constexpr std::array kRecords{"run.json", "simulate.json", "compare.json"};

bool is_record_name(const std::string& name) {
  return std::ranges::find(kRecords, name) != kRecords.end();
}

nlohmann::json parsed(const fs::path& file) {
  return nlohmann::json::parse(read_text_file(file.string()), nullptr, false);
}

}  // namespace

bool is_record(const fs::path& file) {
  if (!fs::is_regular_file(fs::symlink_status(file))) return false;
  const nlohmann::json record = parsed(file);
  const nlohmann::json::json_pointer version("/versions/ridgeline");
  return record.is_object() && record.contains(version);
}

FolderLock::FolderLock(const fs::path& folder)
    : folder_(folder),
      file_(folder / ".ridgeline.lock"),
      descriptor_(locked_file(folder, file_)),
      own_(folder) {
  for (const char* name : kRecords) {
    if (!is_record(folder_ / name)) continue;
    const nlohmann::json record = parsed(folder_ / name);
    if (!record.contains("files")) continue;
    has_list_ = true;
    own_.add(record["files"]);
  }
  const std::vector<std::string> lines = lines_of(descriptor_);
  std::string text = owner_text() + "\n";
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const nlohmann::json entry = nlohmann::json::parse(lines[i], nullptr, false);
    if (!entry.is_object()) continue;  // truncated by a kill
    has_list_ = has_unlisted_ = true;
    own_.add(nlohmann::json::array({entry}));
    text += lines[i] + "\n";
  }
  // The file is truncated last, so that a kill in between loses no line.
  const auto written = pwrite(descriptor_, text.data(), text.size(), 0);
  if (written == static_cast<ssize_t>(text.size()))
    (void)!ftruncate(descriptor_, static_cast<off_t>(text.size()));
  remove_left_files(folder);
}

FolderLock::~FolderLock() {
  std::error_code ignored;
  if (!has_unlisted_) fs::remove(file_, ignored);
  close(descriptor_);
}

std::shared_ptr<FolderLock> FolderLock::of(const fs::path& folder) {
  const std::scoped_lock guard(registry().mutex);
  std::weak_ptr<FolderLock>& known = registry().locks[fs::canonical(folder)];
  std::shared_ptr<FolderLock> lock = known.lock();
  if (!lock) {
    lock.reset(new FolderLock(folder));  // the constructor is private
    known = lock;
  }
  return lock;
}

std::shared_ptr<FolderLock> FolderLock::above(const fs::path& file) {
  const std::scoped_lock guard(registry().mutex);
  if (registry().locks.empty()) return nullptr;
  fs::path folder = fs::weakly_canonical(file).parent_path();
  for (;; folder = folder.parent_path()) {
    const auto known = registry().locks.find(folder);
    if (known != registry().locks.end()) {
      if (auto lock = known->second.lock()) return lock;
    }
    if (!folder.has_relative_path()) return nullptr;
  }
}

bool FolderLock::is_own(const std::string& name) const {
  if (is_record_name(name)) return is_record(folder_ / name);
  return own_.holds(name);
}

void FolderLock::require_own(const std::string& name) const {
  const fs::path file = folder_ / name;
  const std::scoped_lock guard(mutex_);
  if (!fs::exists(fs::symlink_status(file)) || is_own(name)) return;
  const bool is_of_older_version = !has_list_ && is_record(folder_ / kRecords[0]);
  throw IoError(file.string(),
                is_of_older_version
                    ? "is in a folder written by an older version, which kept no list of its "
                      "files; choose another folder"
                    : "was not written by ridgeline or has changed since, and would be "
                      "overwritten; move it away or choose another folder");
}

void FolderLock::remove(const std::string& name) {
  const std::scoped_lock guard(mutex_);
  if (!is_own(name)) return;
  fs::remove(folder_ / name);
  own_.forget(name);
  has_unlisted_ = true;
}

nlohmann::ordered_json FolderLock::own_files() const {
  const std::scoped_lock guard(mutex_);
  return own_.to_json();
}

bool FolderLock::has_unlisted() const {
  const std::scoped_lock guard(mutex_);
  return has_unlisted_;
}

void FolderLock::set_listed() {
  const std::scoped_lock guard(mutex_);
  has_list_ = true;
  has_unlisted_ = false;
  const std::string owner = owner_text() + "\n";
  (void)!ftruncate(descriptor_, static_cast<off_t>(owner.size()));
}

void FolderLock::note(const std::string& name, const fs::path& content) {
  if (is_record_name(name)) return;
  const nlohmann::json entry = OwnFiles::entry_of(name, content);
  const std::string line =
      entry.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  const std::scoped_lock guard(mutex_);
  own_.add(nlohmann::json::array({entry}));
  has_unlisted_ = true;
  lseek(descriptor_, 0, SEEK_END);
  if (::write(descriptor_, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    throw IoError(file_.string(), "cannot be written; is the disk full?");
}

void put_in_place(const fs::path& from, const fs::path& to) {
  if (const auto lock = FolderLock::above(to)) {
    const fs::path folder = fs::canonical(lock->folder_);
    const fs::path place = fs::canonical(to.parent_path().empty() ? "." : to.parent_path());
    lock->note((place / to.filename()).lexically_relative(folder).generic_string(), from);
  }
  fs::rename(from, to);
}

}  // namespace ridgeline::io
