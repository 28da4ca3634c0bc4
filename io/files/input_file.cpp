// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/input_file.h"

#include "io/error.h"
#include "io/text/utf8.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

namespace ridgeline::io {
namespace {

/// Whether the path is a pipe that a shell has opened for the program. Such a pipe ends when its
/// writer does.
bool is_open_pipe(const std::string& path, const std::filesystem::file_status& status) {
  return std::filesystem::is_fifo(status) &&
         (path == "/dev/stdin" || path.starts_with("/dev/fd/") || path.starts_with("/proc/self/"));
}

std::filesystem::file_status status_of(const std::string& path, std::optional<FileGroup> expected) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw MissingFileError(path, "no such file");
  if (std::filesystem::is_directory(status)) {
    if (expected) require_kind(path, *expected);
    throw IoError(path, "is a folder, a file is expected");
  }
  return status;
}

[[noreturn]] void refuse_irregular(const std::string& path) {
  throw IoError(path, "is a device, pipe or socket; copy it into a file");
}

std::string read_at_most(const std::string& path,
                         std::optional<FileGroup> expected,
                         std::size_t most_bytes) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream.is_open()) {
    throw IoError(path, std::string("cannot be read: ") + std::strerror(errno));
  }
  std::string bytes;
  std::array<char, 65536> block{};
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    const bool is_first = bytes.empty();
    bytes.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (is_first && expected) require_kind(path, bytes, *expected);
    if (bytes.size() > most_bytes) {
      throw IoError(path, "the pipe delivers more than 64 MiB; copy its data into a file");
    }
  }
  if (stream.bad()) throw IoError(path, "cannot be read");
  bytes.erase(0, bytes.size() - without_byte_order_mark(bytes).size());
  return bytes;
}

}  // namespace

void require_regular_file(const std::string& path, std::optional<FileGroup> expected) {
  if (!std::filesystem::is_regular_file(status_of(path, expected))) refuse_irregular(path);
}

std::string read_input(const std::string& path, std::optional<FileGroup> expected) {
  constexpr std::size_t kMaxPipe_bytes = 64U << 20U;
  const std::filesystem::file_status status = status_of(path, expected);
  if (is_open_pipe(path, status)) return read_at_most(path, expected, kMaxPipe_bytes);
  if (!std::filesystem::is_regular_file(status)) refuse_irregular(path);
  return read_at_most(path, expected, std::numeric_limits<std::size_t>::max());
}

}  // namespace ridgeline::io
