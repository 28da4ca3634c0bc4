// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// What a reader takes.
enum class Expected : std::uint8_t {
  kLines,
  kCloud,
  kImage,
  kPatch,
  kGates,
  kConfig,
  kMatches,
  kReferenceMatches,
  kSegments,
  kResults
};

/// So much of a file tells what it is, comments at its head included.
inline constexpr std::size_t kTelling_bytes = 16384;

/// The beginning of a regular file; empty for all else, so that no pipe is opened.
std::string beginning_of(const std::string& path);

/// What a file is: by its beginning first, then by its name.
FileKind kind_of_content(std::string_view content, const std::string& path);
/// The same of a file or folder.
FileKind kind_of_path(const std::string& path);

/// "is a LAS point cloud, not a patch file (patch.yaml); give it as --cloud": what IoError says of it.
std::string refusal(const FileKind& kind, Expected expected);

/// Throws IoError if the content is known to be of another kind than is expected. What is unknown or empty is left to its
/// reader, which knows the rule that it breaks.
void refuse_other_kind(const std::string& path, std::string_view content, Expected expected);
/// The same of a file or folder, of which no more than the beginning is read.
void refuse_other_kind(const std::string& path, Expected expected);

}  // namespace ridgeline::io
