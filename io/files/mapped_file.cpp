// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/mapped_file.h"

#include "io/error.h"

#include <boost/interprocess/exceptions.hpp>
#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace ridgeline::io {

namespace bip = boost::interprocess;

struct MappedFile::Mapping {
  bip::mapped_region region;
};

MappedFile::MappedFile(const std::string& path) : mapping_(std::make_unique<Mapping>()) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw MissingFileError(path, "does not exist");
  if (!std::filesystem::is_regular_file(status)) throw IoError(path, "is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw IoError(path, "cannot be read: " + error.message());
  if (size == 0) return;  // an empty range cannot be mapped
  try {
    const bip::file_mapping file(path.c_str(), bip::read_only);
    mapping_->region = bip::mapped_region(file, bip::read_only);
  } catch (const bip::interprocess_exception& failure) {
    throw IoError(path, std::string("cannot be read: ") + failure.what());
  }
  bytes_ = {static_cast<const std::byte*>(mapping_->region.get_address()),
            mapping_->region.get_size()};
}

void MappedFile::release(std::span<const std::byte> part) {
  advise_whole_pages(part, MADV_DONTNEED);
}

MappedFile::~MappedFile() = default;
MappedFile::MappedFile(MappedFile&&) noexcept = default;
MappedFile& MappedFile::operator=(MappedFile&&) noexcept = default;

void advise_whole_pages(std::span<const std::byte> range, int advice) {
  static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const auto begin = reinterpret_cast<std::uintptr_t>(range.data());
  const std::size_t skipped = (page - begin % page) % page;
  if (range.size() < skipped + page) return;
  const std::size_t size = (range.size() - skipped) / page * page;
  // madvise() takes a non-const pointer, but does not change the bytes.
  (void)madvise(const_cast<std::byte*>(range.data() + skipped), size, advice);
}

}  // namespace ridgeline::io
