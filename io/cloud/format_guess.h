// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace ridgeline::io {

/// The first bytes as quoted text where they are printable, else in hexadecimal; "nothing (the
/// file is empty)" for an empty file.
std::string describe_first_bytes(std::span<const std::byte> file);

/// "; it looks like NAME" for a file format with known first bytes, else empty.
std::string guess_hint(std::span<const std::byte> file);

}  // namespace ridgeline::io
