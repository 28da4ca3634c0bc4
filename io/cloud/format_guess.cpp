// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/format_guess.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace ridgeline::io {

namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view first_bytes;
  std::string_view name;
};

constexpr std::array kSignatures{
    Signature{"LASF"sv, "LAS or LAZ"sv},
    Signature{"ply\n"sv, "PLY"sv},
    Signature{"ply\r"sv, "PLY"sv},
    Signature{"# .PCD"sv, "PCD"sv},
    Signature{"VERSION"sv, "PCD"sv},
    Signature{"PK\x03\x04"sv, "a ZIP archive (unpack it first)"sv},
    Signature{"\x1f\x8b"sv, "gzip (unpack it first)"sv},
    Signature{"ASTM-E57"sv, "E57"sv},
    Signature{"\x89PNG"sv, "a PNG image"sv},
    Signature{"II*\0"sv, "a TIFF image"sv},
    Signature{"MM\0*"sv, "a TIFF image"sv},
    Signature{"<!DOCTYPE"sv, "a web page (a failed download?)"sv},
    Signature{"ncols"sv, "an ASCII grid (give its cells as x y z lines)"sv},
    Signature{"NCOLS"sv, "an ASCII grid (give its cells as x y z lines)"sv},
    Signature{"<html"sv, "a web page (a failed download?)"sv},
    Signature{"version https://git-lfs"sv,
              "a Git LFS pointer (fetch the file with git lfs pull)"sv},
};

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::string describe_first_bytes(std::span<const std::byte> file) {
  constexpr std::size_t kShown = 8;
  if (file.empty()) return "nothing (the file is empty)";
  const std::string_view start = as_text(file.first(std::min(kShown, file.size())));
  const bool printable =
      std::ranges::all_of(start, [](char c) { return c >= ' ' && c <= '~' && c != '"'; });
  if (printable) return fmt::format("\"{}\"", start);
  std::string hex = "bytes";
  for (const char c : start) hex += fmt::format(" {:02x}", static_cast<unsigned char>(c));
  return hex;
}

std::string guess_hint(std::span<const std::byte> file) {
  const std::string_view text = as_text(file);
  for (const Signature& signature : kSignatures) {
    if (text.starts_with(signature.first_bytes)) {
      return fmt::format("; it looks like {}", signature.name);
    }
  }
  return "";
}

}  // namespace ridgeline::io
