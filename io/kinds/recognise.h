// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// This many bytes of a file tell what it is, comments at its head included.
inline constexpr std::size_t kTelling_bytes = 16384;

/// The beginning of a regular file; empty for all else, so that no pipe is opened.
std::string beginning_of(const std::string& path);

/// What a file is, told by its beginning first, then by its name.
FileKind kind_of_content(std::string_view content, const std::string& path);
/// What a file or folder is, told by its content and name.
FileKind kind_of_path(const std::string& path);

/// The text of the IoError for such a file: "is a LAS point cloud, not a patch file (patch.yaml);
/// give it as `cloud`".
std::string refusal(const FileKind& kind, FileGroup expected);

/// Throws IoError if the content is known to be of another kind than is expected. What is unknown
/// or empty is left to its reader, which knows the rule that it breaks.
void require_kind(const std::string& path, std::string_view content, FileGroup expected);
/// Throws IoError if a file or folder is known to be of another kind than is expected. No more than
/// its beginning is read.
void require_kind(const std::string& path, FileGroup expected);

}  // namespace ridgeline::io
