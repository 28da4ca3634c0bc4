// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace ridgeline::io {

/// A whole file as read-only bytes, memory-mapped so that the system's page cache is the only copy.
/// An empty file gives an empty span.
class MappedFile {
 public:
  /// Throws IoError unless `path` is a readable regular file.
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(MappedFile&&) noexcept;
  MappedFile& operator=(MappedFile&&) noexcept;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

  /// Tells the system that the pages lying entirely within `part` of bytes() are not needed for
  /// now: they no longer count towards this program's memory and are reloaded from the page cache
  /// or disk when next read.
  static void release(std::span<const std::byte> part);

 private:
  struct Mapping;
  std::unique_ptr<Mapping> mapping_;
  std::span<const std::byte> bytes_;
};

/// Gives the system a madvise(2) hint for the pages that lie entirely within a memory range. No
/// byte changes, whether the system follows the hint or not.
void advise_whole_pages(std::span<const std::byte> range, int advice);

}  // namespace ridgeline::io
