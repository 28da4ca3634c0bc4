// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_header.h"

#include "io/cloud/bytes.h"
#include "io/cloud/las_vlr.h"
#include "io/error.h"
#include "io/files/mapped_file.h"
#include "io/kinds/marks.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace ridgeline::io {

namespace {

using Bytes = std::span<const std::byte>;

constexpr std::array<std::uint16_t, 11> kRecordSizes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
// Sizes of the header by minor version, 0 to 5.
constexpr std::array<std::uint16_t, 6> kHeaderSizes{227, 227, 227, 235, 375, 393};
// Writers leave +-DBL_MAX as bounds until they finish; no map coordinate comes close.
constexpr double kUnsetBound = 1e300;

template <typename Value>
[[noreturn]] void throw_field(
    const std::string& path, const char* name, int byte, const Value& value, const char* rule) {
  throw IoError(path, fmt::format("field {} at byte {} is {}; {}", name, byte, value, rule));
}

Eigen::Vector3d load_vector(const std::byte* source) {
  return {load<double>(source), load<double>(source + 8), load<double>(source + 16)};
}

/// The first bytes of a file for a message, quoted if they are printable, else in hexadecimal.
std::string describe_first_bytes(std::string_view content) {
  constexpr std::size_t kShown = 8;
  if (content.empty()) return "nothing (the file is empty)";
  const std::string_view start = content.substr(0, kShown);
  const bool printable =
      std::ranges::all_of(start, [](char c) { return c >= ' ' && c <= '~' && c != '"'; });
  if (printable) return fmt::format("\"{}\"", start);
  std::string hex = "bytes";
  for (const char c : start) hex += fmt::format(" {:02x}", static_cast<unsigned char>(c));
  return hex;
}

void check_signature(Bytes file, const std::string& path) {
  constexpr std::string_view kSignature = "LASF";
  const std::string_view content(reinterpret_cast<const char*>(file.data()), file.size());
  if (content.starts_with(kSignature)) return;
  const FileKind kind = kind_by_mark(content);
  throw IoError(path, fmt::format("is not a LAS file: starts with {}; must start with \"LASF\"{}",
                                  describe_first_bytes(content),
                                  kind.is_known() ? "; it is " + kind.what : ""));
}

void read_version(Bytes file, const std::string& path, LasHeader& header) {
  if (file.size() < kHeaderSizes[0]) {
    throw IoError(path, fmt::format("header is truncated: {} bytes; LAS needs at least {}",
                                    file.size(), kHeaderSizes[0]));
  }
  const int major = load<std::uint8_t>(&file[24]);
  header.version_minor = load<std::uint8_t>(&file[25]);
  if (major != 1 || header.version_minor > 5) {
    throw_field(path, "version", 24, fmt::format("{}.{}", major, header.version_minor),
                "must be 1.0 to 1.5");
  }
}

void read_sizes(Bytes file, const std::string& path, LasHeader& header) {
  header.global_encoding = load<std::uint16_t>(&file[6]);
  header.header_size = load<std::uint16_t>(&file[94]);
  header.point_offset = load<std::uint32_t>(&file[96]);
  if (header.header_size == 0) {
    throw_field(path, "header_size", 94, 0, "the writer did not finish this file");
  }
  if (header.point_offset == 0) {
    throw_field(path, "point_offset", 96, 0, "the writer did not finish this file");
  }
  const std::uint16_t least = kHeaderSizes[static_cast<std::size_t>(header.version_minor)];
  if (header.header_size < least) {
    throw_field(path, "header_size", 94, header.header_size,
                fmt::format("LAS 1.{} needs at least {}", header.version_minor, least).c_str());
  }
  if (file.size() < header.header_size) {
    throw_field(path, "header_size", 94, header.header_size,
                fmt::format("the file has only {} bytes", file.size()).c_str());
  }
  if (header.point_offset < header.header_size || header.point_offset > file.size()) {
    throw_field(path, "point_offset", 96, header.point_offset,
                fmt::format("must lie between the header's end {} and the file's end {}",
                            header.header_size, file.size())
                    .c_str());
  }
}

void read_point_format(Bytes file, const std::string& path, LasHeader& header) {
  header.raw_point_format = load<std::uint8_t>(&file[104]);
  header.point_format = header.raw_point_format & 0x3FU;
  header.record_length = load<std::uint16_t>(&file[105]);
  if (header.point_format >= kRecordSizes.size()) {
    throw_field(path, "point_format", 104, header.point_format, "must be 0 to 10");
  }
  const std::uint16_t least = las_record_size(header.point_format);
  if (header.record_length < least) {
    throw_field(
        path, "record_length", 105, header.record_length,
        fmt::format("point format {} needs at least {}", header.point_format, least).c_str());
  }
}

void read_transform(Bytes file, const std::string& path, LasHeader& header) {
  header.scale = load_vector(&file[131]);
  header.offset = load_vector(&file[155]);
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(header.scale[axis]) || header.scale[axis] == 0.0) {
      throw_field(path, "scale", 131 + 8 * axis, header.scale[axis], "must be finite and not 0");
    }
    if (!std::isfinite(header.offset[axis])) {
      throw_field(path, "offset", 155 + 8 * axis, header.offset[axis], "must be finite");
    }
  }
}

void read_bounds(Bytes file, LasHeader& header) {
  for (int axis = 0; axis < 3; ++axis) {
    header.stated_max[axis] = load<double>(&file[179 + 16 * static_cast<std::size_t>(axis)]);
    header.stated_min[axis] = load<double>(&file[187 + 16 * static_cast<std::size_t>(axis)]);
  }
}

void read_claimed_count(Bytes file, LasHeader& header) {
  const std::uint64_t legacy = load<std::uint32_t>(&file[107]);
  header.n_points_claimed = legacy;
  if (header.version_minor < 4) return;
  const auto count = load<std::uint64_t>(&file[247]);
  if (count == 0) return;  // some 1.4 writers fill in only the legacy field
  header.n_points_claimed = count;
  if (legacy != 0 && legacy != count) {
    header.warnings.push_back(
        fmt::format("field legacy_point_count at byte 107 is {} but point_count at byte 247 is "
                    "{}; the latter is used",
                    legacy, count));
  }
}

/// Bytes from the first record to whatever follows the records.
std::uint64_t room_for_records(Bytes file, const LasHeader& header) {
  std::uint64_t end = file.size();
  if (header.version_minor >= 4 && load<std::uint32_t>(&file[243]) > 0) {
    const auto first_evlr = load<std::uint64_t>(&file[235]);
    if (first_evlr >= header.point_offset) end = std::min(end, first_evlr);
  }
  return end - header.point_offset;
}

void resolve_count(Bytes file,
                   const std::string& path,
                   const LasHeaderOptions& options,
                   LasHeader& header) {
  header.n_points = header.n_points_claimed;
  const bool bounds_unset = !(header.stated_min.array().abs() < kUnsetBound).all() ||
                            !(header.stated_max.array().abs() < kUnsetBound).all();
  const std::uint64_t room = room_for_records(file, header) / header.record_length;
  const bool unfinished =
      header.n_points_claimed == 0 && (bounds_unset || (room > 0 && !header.is_compressed()));
  if (unfinished && (!options.salvage || header.is_compressed())) {
    throw IoError(
        path, fmt::format(
                  "field point_count at byte 107 is 0 but the header is followed by {} more bytes; "
                  "the writer did not finish this file (`salvage` reads the existing records)",
                  file.size() - header.point_offset));
  }
  if (header.is_compressed() || (!unfinished && header.n_points_claimed <= room)) return;
  if (!options.salvage) {
    throw IoError(path, fmt::format("field point_count at byte {} is {}; the file has room for {} "
                                    "records of {} bytes (`salvage` reads those)",
                                    header.version_minor >= 4 ? 247 : 107, header.n_points_claimed,
                                    room, header.record_length));
  }
  header.n_points = room;
  header.warnings.push_back(
      fmt::format("salvaged {} of {} declared records", room, header.n_points_claimed));
}

}  // namespace

std::uint16_t las_record_size(std::uint8_t point_format) {
  check(point_format < kRecordSizes.size(), "las_record_size: point_format = ", +point_format,
        ", must be 0 to 10");
  return kRecordSizes[point_format];
}

LasHeader parse_las_header(std::span<const std::byte> file,
                           const std::string& path,
                           const LasHeaderOptions& options) {
  LasHeader header;
  header.file_size = file.size();
  check_signature(file, path);
  read_version(file, path, header);
  read_sizes(file, path, header);
  read_point_format(file, path, header);
  read_transform(file, path, header);
  read_bounds(file, header);
  read_claimed_count(file, header);
  resolve_count(file, path, options, header);
  collect_vlrs(file, header);
  return header;
}

LasHeader read_las_header(const std::string& path, const LasHeaderOptions& options) {
  const MappedFile file(path);
  return parse_las_header(file.bytes(), path, options);
}

std::optional<LasVlr> find_vlr(const LasHeader& header,
                               std::string_view user_id,
                               std::uint16_t record_id) {
  const auto found = std::ranges::find_if(header.vlrs, [&](const LasVlr& vlr) {
    return vlr.user_id == user_id && vlr.record_id == record_id;
  });
  if (found == header.vlrs.end()) return std::nullopt;
  return *found;
}

}  // namespace ridgeline::io
