// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/recognise.h"

#include "io/error.h"
#include "io/kinds/folder_kind.h"
#include "io/kinds/marks.h"
#include "io/kinds/text_kind.h"
#include "io/text/gzip.h"
#include "io/text/text.h"
#include "io/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace ridgeline::io {
namespace fs = std::filesystem;
namespace {

using enum FileGroup;

std::string extension_in(const std::string& path) {
  return lower_case(fs::path(path).extension().string());
}

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// Whether the file is the program's own report, which only a mark distinguishes from other web
/// pages.
bool is_report(std::string_view start) {
  return start.starts_with("<!doctype html>") && holds(start, "content=\"ridgeline\"");
}

FileKind kind_of_ply(std::string_view start) {
  const std::string_view header = start.substr(0, start.find("end_header"));
  const char* const what = holds(header, "element edge")   ? "lines (PLY)"
                           : holds(header, "element face") ? "a mesh (PLY)"
                                                           : "a PLY point cloud";
  return {.group = kPly, .what = what, .advice = info_of(kPly).advice, .ending = ".ply"};
}

bool is_laz(std::string_view start) {
  constexpr std::size_t kPointFormat = 104;  // LASzip sets the highest bit of this byte
  return start.starts_with("LASF") && start.size() > kPointFormat &&
         (static_cast<unsigned char>(start[kPointFormat]) & 0x80U) != 0;
}

FileKind kind_by_bytes(std::string_view start) {
  if (is_report(start)) {
    return {.group = kResult, .what = "a report (report.html)", .advice = "open it in a browser"};
  }
  if (start.starts_with("ply\n") || start.starts_with("ply\r")) return kind_of_ply(start);
  FileKind kind = kind_by_mark(start);
  if (kind.group == kCloud && kind.what == "a LAS point cloud" && is_laz(start)) {
    kind.what = "a LAZ point cloud";
  }
  return kind;
}

/// Lets the name decide where it is more specific: a Shapefile's index begins like a Shapefile, and
/// a sequence of JSON texts like GeoJSON.
FileKind with_name(const FileKind& kind, std::string_view extension) {
  constexpr std::array kExact{".shx", ".geojsonl", ".geojsons", ".ndjson", ".jsonl"};
  const bool is_exact = std::ranges::find(kExact, extension) != kExact.end();
  return kind.group == kLines && is_exact ? format_with_extension(extension) : kind;
}

/// The extension that represents all extensions of one reader, which distinguishes them by content.
std::string_view reader_ending(std::string_view extension) {
  if (extension == ".json") return ".geojson";
  return extension == ".wkt" || extension == ".txt" ? ".csv" : extension;
}

/// Throws IoError if the extension does not match the content, because the reader of lines is
/// chosen by extension.
void require_ending(const std::string& path, const FileKind& kind) {
  const std::string extension = extension_in(path);
  const bool fits = kind.ending.empty() || reader_ending(kind.ending) == reader_ending(extension);
  if (fits) return;
  throw IoError(path, fmt::format("is {}, but its name does not match; use a name that ends in {}",
                                  kind.what, kind.ending));
}

void require_group(const std::string& path, const FileKind& kind, FileGroup expected) {
  const auto& also = info_of(expected).also;
  const bool is_taken = kind.group == expected || std::ranges::count(also, kind.group) > 0;
  if (kind.is_known() && !is_taken) throw IoError(path, refusal(kind, expected));
  if (expected == kLines && kind.group != kModel) require_ending(path, kind);
}

/// Building models may also be compressed.
FileKind kind_in_gzip(std::string_view start) {
  const std::string text = inflated(start, kTelling_bytes).text;
  const FileKind kind = kind_of_text(text, false);
  return kind.group == kModel ? kind : kind_by_mark(start);
}

}  // namespace

std::string beginning_of(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return "";
  std::ifstream stream(path, std::ios::binary);
  std::string start(kTelling_bytes, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  return start;
}

FileKind kind_of_content(std::string_view content, const std::string& path) {
  if (content.empty()) return {.group = kEmpty, .what = "an empty file"};
  const std::string_view start = without_byte_order_mark(content.substr(0, kTelling_bytes));
  const bool is_whole = content.size() < kTelling_bytes;
  const std::string extension = extension_in(path);
  if (is_gzip(start)) return kind_in_gzip(start);
  if (const FileKind kind = kind_by_bytes(start); kind.is_known())
    return with_name(kind, extension);
  const bool is_text = start.find('\0') == std::string_view::npos;
  if (is_text) {
    if (const FileKind kind = kind_of_text(start, is_whole); kind.is_known()) {
      return with_name(kind, extension);
    }
  }
  return kind_by_extension(extension);
}

FileKind kind_of_path(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return kind_of_folder(path);
  if (!fs::is_regular_file(path, ignored)) return {};
  return kind_of_content(beginning_of(path), path);
}

std::string refusal(const FileKind& kind, FileGroup expected) {
  const GroupInfo& reader = info_of(expected);
  if (kind.by_name || kind.group == kOther || kind.group == kFolder) {
    const std::string advice = kind.advice.empty() ? "" : ", " + kind.advice;
    const std::string rule =
        *reader.rule != '\0' ? reader.rule : std::string(reader.takes) + " is expected";
    return fmt::format("is {}{}{}; {}", kind.by_name ? "named as " : "", kind.what, advice, rule);
  }
  return fmt::format("is {}, not {}; {}", kind.what, reader.takes, kind.advice);
}

void require_kind(const std::string& path, std::string_view content, FileGroup expected) {
  require_group(path, kind_of_content(content, path), expected);
}

void require_kind(const std::string& path, FileGroup expected) {
  require_group(path, kind_of_path(path), expected);
}

}  // namespace ridgeline::io
