// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/atomic_file.h"

#include "io/error.h"
#include "io/files/folder_lock.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <regex>
#include <system_error>

namespace ridgeline::io {

namespace fs = std::filesystem;

namespace {

/// A name in the folder of `path`. The extension of `path` is kept, because some libraries choose
/// the format by it.
std::string temporary_name(const fs::path& path) {
  static std::atomic<unsigned> counter{0};  // distinguishes the writers of this process
  const std::string name = fmt::format(".{}.{}.{}.tmp{}", path.stem().string(), getpid(),
                                       counter.fetch_add(1), path.extension().string());
  return (path.parent_path() / name).string();
}

/// The path next to which the temporary file is created. For a device, it is in the system's folder
/// for temporary files, because a device's folder is not meant for files.
fs::path beside(const fs::path& path, bool is_device) {
  return is_device ? fs::temp_directory_path() / path.filename() : path;
}

}  // namespace

bool is_device(const std::string& path) {
  std::error_code ignored;  // a path that does not exist is not a device
  const bool is_of_system = path.starts_with("/dev/") || path.starts_with("/proc/");
  return fs::is_other(path, ignored) || (is_of_system && fs::is_symlink(path, ignored));
}

AtomicFile::AtomicFile(const std::string& path)
    : path_(path),
      is_device_(is_device(path)),
      temporary_path_(temporary_name(beside(path, is_device_))),
      folders_(fs::path(temporary_path_).parent_path()) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw IoError(path, "is a folder; must be a file");
  stream_.open(temporary_path_, std::ios::binary | std::ios::trunc);
  if (!stream_) throw IoError(path, "cannot be written; check the folder's permissions");
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  stream_.close();
  std::error_code ignored;  // a destructor cannot report errors
  fs::remove(temporary_path_, ignored);
}

void AtomicFile::commit() {
  stream_.close();
  if (!stream_) throw IoError(path_, "could not be written completely; is the disk full?");
  if (is_device_) return send_to_device();
  try {
    put_in_place(temporary_path_, path_);
  } catch (const fs::filesystem_error& error) {
    throw IoError(path_, "cannot be moved into place: " + error.code().message());
  }
  committed_ = true;
}

void AtomicFile::send_to_device() {
  std::ifstream from(temporary_path_, std::ios::binary);
  // a shell may have opened a file for appending
  std::ofstream to(path_, std::ios::binary | std::ios::app);
  if (fs::file_size(temporary_path_) > 0) to << from.rdbuf();
  to.close();
  if (!to) throw IoError(path_, "could not be written completely");
}

bool is_left_by_dead_process(const std::string& file_name) {
  static const std::regex pattern(R"(\..*\.([0-9]{1,10})\.[0-9]{1,10}\.tmp(\..*)?)");
  std::smatch match;
  if (!std::regex_match(file_name, match, pattern)) return false;
  const long process = std::stol(match[1]);
  return kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

void write_file(const std::string& path, std::string_view content) {
  AtomicFile file(path);
  file.stream().write(content.data(), static_cast<std::streamsize>(content.size()));
  file.commit();
}

}  // namespace ridgeline::io
