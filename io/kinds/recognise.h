// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// Number of bytes by which a file is recognised; leaves room for comments at its head.
inline constexpr std::size_t kTelling_bytes = 16384;

/// The beginning of a regular file; empty for anything else, so that no pipe is opened.
std::string beginning_of(const std::string& path);

/// Identifies a file by its beginning, and if that is not enough, by its name.
FileKind kind_of_content(std::string_view content, const std::string& path);
/// Identifies a file or folder by its content and name.
FileKind kind_of_path(const std::string& path);

/// The text of the IoError for such a file: "is a LAS point cloud, not a patch file (patch.yaml);
/// give it as `cloud`".
std::string refusal(const FileKind& kind, FileGroup expected);

/// Throws IoError if the content is recognised as a kind other than the expected one. Unknown or
/// empty content is left to the reader, which can name the violated rule.
void require_kind(const std::string& path, std::string_view content, FileGroup expected);
/// Throws IoError if a file or folder is recognised as a kind other than the expected one. Only the
/// beginning of the file is read.
void require_kind(const std::string& path, FileGroup expected);

}  // namespace ridgeline::io
