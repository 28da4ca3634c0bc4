// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace ridgeline::io {

/// A whole file as read-only bytes, mapped and not copied, so that the system's page cache is the
/// only copy. Empty files give an empty span.
class MappedFile {
 public:
  /// Throws IoError unless `path` is a regular file that can be read.
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(MappedFile&&) noexcept;
  MappedFile& operator=(MappedFile&&) noexcept;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

  /// Says that the whole pages of a part of bytes() are not needed for now: they no longer count as
  /// this program's memory, and come back from the page cache or the disk when they are read.
  static void release(std::span<const std::byte> part);

 private:
  struct Mapping;
  std::unique_ptr<Mapping> mapping_;
  std::span<const std::byte> bytes_;
};

/// Gives the system one of madvise(2)'s hints for the pages that lie whole in a range of memory.
/// The hint changes no byte, whether the system takes it or not.
void advise_whole_pages(std::span<const std::byte> range, int advice);

}  // namespace ridgeline::io
