// SPDX-License-Identifier: BSD-3-Clause
#include "io/atomic_file.h"

#include "io/error.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <system_error>

namespace ridgeline::io {

namespace fs = std::filesystem;

namespace {

/// The ending of `path` is kept, since some libraries choose a format by it.
std::string temporary_name(const fs::path& path) {
  static std::atomic<unsigned> counter{0};  // apart from other writers of this process
  const std::string name = fmt::format(".{}.{}.{}.tmp{}", path.stem().string(), getpid(),
                                       counter.fetch_add(1), path.extension().string());
  return (path.parent_path() / name).string();
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
  std::error_code ignored;  // nothing there
  is_device_ = fs::is_other(path, ignored);
  if (fs::is_symlink(path, ignored) && !is_device_) path_ = fs::weakly_canonical(path).string();
  // a device's folder is no place for files
  temporary_path_ = temporary_name(
      is_device_ ? fs::temp_directory_path() / fs::path(path).filename() : fs::path(path_));
  std::error_code error;
  const fs::path folder = fs::path(temporary_path_).parent_path();
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) throw IoError(path, "folder cannot be made: " + error.message());
  if (fs::is_directory(path, error)) throw IoError(path, "is a folder; must be a file to write");
  stream_.open(temporary_path_, std::ios::binary | std::ios::trunc);
  if (!stream_) throw IoError(path, "cannot be written; check the folder's permissions");
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  stream_.close();
  std::error_code ignored;  // a destructor has nobody to tell
  fs::remove(temporary_path_, ignored);
}

void AtomicFile::commit() {
  stream_.close();
  if (!stream_) throw IoError(path_, "could not be written whole; is the disk full?");
  if (is_device_) return send_to_device();
  std::error_code error;
  fs::rename(temporary_path_, path_, error);
  if (error) throw IoError(path_, "cannot be put in place: " + error.message());
  committed_ = true;
}

void AtomicFile::send_to_device() {
  std::ifstream from(temporary_path_, std::ios::binary);
  std::ofstream to(path_, std::ios::binary);
  if (fs::file_size(temporary_path_) > 0) to << from.rdbuf();
  to.close();
  if (!to) throw IoError(path_, "could not be written whole");
}

void write_file(const std::string& path, std::string_view content) {
  AtomicFile file(path);
  file.stream().write(content.data(), static_cast<std::streamsize>(content.size()));
  file.commit();
}

}  // namespace ridgeline::io
