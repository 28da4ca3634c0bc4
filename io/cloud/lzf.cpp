// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/lzf.h"

#include <algorithm>

namespace ridgeline::io {

namespace {

constexpr std::size_t kMaxCopy_bytes = 264;  // the most bytes that a 3-byte reference can copy

/// Reads a packed stream; every step returns whether the bytes that it needs were available.
class Unpacker {
 public:
  Unpacker(std::span<const std::byte> packed, std::size_t unpacked_size) : packed_(packed) {
    unpacked_.reserve(unpacked_size);
  }

  bool step() {
    const auto control = std::to_integer<std::size_t>(take());
    return control < 32 ? copy_literals(control + 1) : copy_reference(control);
  }

  [[nodiscard]] bool at_end() const { return packed_.empty(); }
  [[nodiscard]] std::vector<std::byte>& unpacked() { return unpacked_; }

 private:
  std::byte take() {
    const std::byte first = packed_.front();
    packed_ = packed_.subspan(1);
    return first;
  }

  [[nodiscard]] bool has_room(std::size_t count) const {
    return count <= unpacked_.capacity() - unpacked_.size();
  }

  bool copy_literals(std::size_t count) {
    if (count > packed_.size() || !has_room(count)) return false;
    unpacked_.insert(unpacked_.end(), packed_.begin(),
                     packed_.begin() + static_cast<std::ptrdiff_t>(count));
    packed_ = packed_.subspan(count);
    return true;
  }

  bool copy_reference(std::size_t control) {
    constexpr std::size_t kLongLength = 7;
    std::size_t length = control >> 5U;
    if (packed_.size() < (length == kLongLength ? 2U : 1U)) return false;
    if (length == kLongLength) length += std::to_integer<std::size_t>(take());
    length += 2;
    const std::size_t distance =
        ((control & 0x1FU) << 8U | std::to_integer<std::size_t>(take())) + 1;
    if (distance > unpacked_.size() || !has_room(length)) return false;
    // Bytes are copied one by one because source and target may overlap, which repeats a pattern.
    for (std::size_t i = 0; i < length; ++i) {
      unpacked_.push_back(unpacked_[unpacked_.size() - distance]);
    }
    return true;
  }

  std::span<const std::byte> packed_;
  std::vector<std::byte> unpacked_;
};

}  // namespace

std::optional<std::vector<std::byte>> unpack_lzf(std::span<const std::byte> packed,
                                                 std::size_t unpacked_size) {
  if (unpacked_size / kMaxCopy_bytes > packed.size()) return std::nullopt;
  Unpacker unpacker(packed, unpacked_size);
  while (!unpacker.at_end()) {
    if (!unpacker.step()) return std::nullopt;
  }
  if (unpacker.unpacked().size() != unpacked_size) return std::nullopt;
  return std::move(unpacker.unpacked());
}

}  // namespace ridgeline::io
