// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/orientation_text.h"

#include "io/error.h"
#include "io/files/input_file.h"
#include "io/text/utf8.h"

#include <fmt/format.h>

#include <filesystem>

namespace ridgeline::io {
namespace fs = std::filesystem;
namespace {

constexpr double kMebibyte = 1 << 20U;

void require_size(const std::string& path, std::uint64_t most_bytes) {
  require_regular_file(path);
  const std::uint64_t size = fs::file_size(path);
  if (size == 0) throw IoError(path, "is empty");
  if (size <= most_bytes) return;
  throw IoError(path, fmt::format("has {:.0f} MiB; the limit for an orientation is {:.0f} MiB",
                                  static_cast<double>(size) / kMebibyte,
                                  static_cast<double>(most_bytes) / kMebibyte));
}

}  // namespace

std::string read_orientation_text(const std::string& path, std::uint64_t most_bytes) {
  require_size(path, most_bytes);
  std::string text = read_input(path);
  if (const std::size_t at = text.find('\0'); at != std::string::npos) {
    throw IoError(
        path,
        fmt::format("has a zero byte at {} and is not text; the file is damaged or of another kind",
                    at));
  }
  return is_utf8(text) ? text : as_utf8(text);
}

std::string text_beside(const std::string& path, std::string_view name, Orientation& orientation) {
  const fs::path file = (fs::path(path).parent_path() / name).lexically_normal();
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored) || fs::file_size(file, ignored) == 0) return "";
  std::string text = read_orientation_text(file.string());
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  orientation.files_beside.push_back(file.string());
  return text;
}

}  // namespace ridgeline::io
