// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/codec_error.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ridgeline::io::laz {

/// Reads the bytes of a file in order; every read is checked against their end.
class ByteStream {
 public:
  explicit ByteStream(std::span<const std::byte> bytes) : bytes_(bytes) {}

  /// The next byte. Throws CodecError if none is left.
  std::uint32_t next() {
    if (position_ == bytes_.size()) throw_end(1);
    return std::to_integer<std::uint32_t>(bytes_[position_++]);
  }

  /// The next `size` bytes. Throws CodecError if fewer are left.
  std::span<const std::byte> take(std::size_t size) {
    if (size > bytes_.size() - position_) throw_end(size);
    position_ += size;
    return bytes_.subspan(position_ - size, size);
  }

  [[nodiscard]] std::size_t position() const { return position_; }

 private:
  [[noreturn]] void throw_end(std::size_t needed) const;

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

}  // namespace ridgeline::io::laz
