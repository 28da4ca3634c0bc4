// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::io {

/// Unpacks LZF data into exactly `unpacked_size` bytes. Returns std::nullopt if the data are
/// damaged: a reference before the start, or more or fewer bytes than stated. A size that LZF
/// cannot reach is rejected before memory is allocated.
/// Source: M. Lehmann, LibLZF 3.6, lzf_d.c (format).
std::optional<std::vector<std::byte>> unpack_lzf(std::span<const std::byte> packed,
                                                 std::size_t unpacked_size);

}  // namespace ridgeline::io
