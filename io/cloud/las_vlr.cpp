// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_vlr.h"

#include "io/cloud/bytes.h"

#include <fmt/format.h>

#include <cstdint>

namespace ridgeline::io {

namespace {

struct VlrKind {
  const char* name;
  std::uint64_t header_size;
  bool has_long_length;
};
constexpr VlrKind kVlr{"VLR", 54, false};
constexpr VlrKind kEvlr{"EVLR", 60, true};

/// Reads up to `count` records from `position` on, none beyond `end`. The loop also stops at `end`,
/// so a garbage count costs nothing.
void append_records(std::span<const std::byte> file,
                    const VlrKind& kind,
                    std::uint64_t position,
                    std::uint64_t end,
                    std::uint64_t count,
                    LasHeader& header) {
  for (std::uint64_t i = 0; i < count; ++i) {
    const bool has_header = position <= end && end - position >= kind.header_size;
    std::uint64_t length = 0;
    if (has_header) {
      length = kind.has_long_length ? load<std::uint64_t>(&file[position + 20])
                                    : load<std::uint16_t>(&file[position + 20]);
    }
    if (!has_header || length > end - position - kind.header_size) {
      header.warnings.push_back(fmt::format(
          "{} {} of {} at byte {} extends beyond byte {}; only the {} before it are used",
          kind.name, i + 1, count, position, end, i));
      return;
    }
    header.vlrs.push_back({.user_id = load_text(file.subspan(position + 2, 16)),
                           .record_id = load<std::uint16_t>(&file[position + 18]),
                           .data_offset = position + kind.header_size,
                           .data_size = length});
    position += kind.header_size + length;
  }
}

}  // namespace

void collect_vlrs(std::span<const std::byte> file, LasHeader& header) {
  const auto n_vlrs = load<std::uint32_t>(&file[100]);
  append_records(file, kVlr, header.header_size, header.point_offset, n_vlrs, header);
  if (header.version_minor < 4) return;
  const auto first_evlr = load<std::uint64_t>(&file[235]);
  const auto n_evlrs = load<std::uint32_t>(&file[243]);
  append_records(file, kEvlr, first_evlr, file.size(), n_evlrs, header);
}

}  // namespace ridgeline::io
