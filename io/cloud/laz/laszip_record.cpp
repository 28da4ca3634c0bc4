// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/laszip_record.h"

#include "io/cloud/bytes.h"
#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace ridgeline::io::laz {
namespace {

constexpr std::size_t kFixedSize = 34;
constexpr std::size_t kItemSize = 6;
// Each extra byte has models of its own, about 1.5 KiB; real files have about ten such bytes.
constexpr std::uint16_t kMaxExtraBytes = 8192;

struct ItemRule {
  ItemType type;
  const char* name;
  std::uint16_t size;  // 0: any
  std::uint16_t min_version, max_version;
};

constexpr std::array<ItemRule, 10> kItemRules{{
    {ItemType::kByte, "BYTE", 0, 1, 2},
    {ItemType::kPoint10, "POINT10", 20, 1, 2},
    {ItemType::kGpsTime11, "GPSTIME11", 8, 1, 2},
    {ItemType::kRgb12, "RGB12", 6, 1, 2},
    {ItemType::kWavePacket13, "WAVEPACKET13", 29, 1, 1},
    {ItemType::kPoint14, "POINT14", 30, 3, 4},
    {ItemType::kRgb14, "RGB14", 6, 3, 4},
    {ItemType::kRgbNir14, "RGBNIR14", 8, 3, 4},
    {ItemType::kWavePacket14, "WAVEPACKET14", 29, 3, 4},
    {ItemType::kByte14, "BYTE14", 0, 3, 4},
}};

const ItemRule& rule_of(ItemType type) {
  return *std::ranges::find(kItemRules, type, &ItemRule::type);
}

Item read_item(const std::byte* entry, std::size_t index, const std::string& path) {
  const auto number = load<std::uint16_t>(entry);
  const auto* const rule =
      std::ranges::find(kItemRules, static_cast<ItemType>(number), &ItemRule::type);
  if (rule == kItemRules.end()) {
    throw IoError(
        path, fmt::format("LASzip item {} has type {}; must be 0 or 6 to 14", index + 1, number));
  }
  const Item item{.type = rule->type,
                  .size = load<std::uint16_t>(entry + 2),
                  .version = load<std::uint16_t>(entry + 4)};
  if (item.size == 0 || (rule->size != 0 && item.size != rule->size)) {
    throw IoError(path, fmt::format("LASzip item {} has size {}; must be {}", rule->name, item.size,
                                    rule->size == 0 ? "above 0" : std::to_string(rule->size)));
  }
  if (rule->size == 0 && item.size > kMaxExtraBytes) {
    throw IoError(path, fmt::format("LASzip item {} has size {}; at most {} extra bytes are read",
                                    rule->name, item.size, kMaxExtraBytes));
  }
  if (item.version < rule->min_version || item.version > rule->max_version) {
    throw IoError(path,
                  fmt::format("LASzip item {} has version {}; supported are {} to {}", rule->name,
                              item.version, rule->min_version, rule->max_version));
  }
  return item;
}

std::vector<ItemType> items_of_format(std::uint8_t point_format) {
  using enum ItemType;
  switch (point_format) {
    case 0:
      return {kPoint10};
    case 1:
      return {kPoint10, kGpsTime11};
    case 2:
      return {kPoint10, kRgb12};
    case 3:
      return {kPoint10, kGpsTime11, kRgb12};
    case 4:
      return {kPoint10, kGpsTime11, kWavePacket13};
    case 5:
      return {kPoint10, kGpsTime11, kRgb12, kWavePacket13};
    case 6:
      return {kPoint14};
    case 7:
      return {kPoint14, kRgb14};
    case 8:
      return {kPoint14, kRgbNir14};
    case 9:
      return {kPoint14, kWavePacket14};
    default:
      return {kPoint14, kRgbNir14, kWavePacket14};
  }
}

void check_items(const LaszipRecord& laszip, const LasHeader& header, const std::string& path) {
  std::size_t size = 0;
  std::string names;
  std::vector<ItemType> types;
  for (const Item& item : laszip.items) {
    size += item.size;
    types.push_back(item.type);
    if (!names.empty()) names += ' ';
    names += rule_of(item.type).name;
  }
  std::vector<ItemType> expected = items_of_format(header.point_format);
  if (header.record_length > las_record_size(header.point_format)) {
    expected.push_back(header.point_format >= 6 ? ItemType::kByte14 : ItemType::kByte);
  }
  if (size != header.record_length || types != expected) {
    throw IoError(
        path,
        fmt::format("LASzip items are {} ({} bytes); they must match point format {} ({} bytes)",
                    names, size, header.point_format, header.record_length));
  }
  const bool layered = laszip.compressor == Compressor::kLayered;
  if (layered != (header.point_format >= 6)) {
    throw IoError(path, fmt::format("LASzip compressor {} cannot hold point format {}; must be 1 "
                                    "or 2 for formats 0 to 5 and 3 for formats 6 to 10",
                                    static_cast<int>(laszip.compressor), header.point_format));
  }
}

std::span<const std::byte> find_payload(std::span<const std::byte> file,
                                        const LasHeader& header,
                                        const std::string& path) {
  const std::optional<LasVlr> vlr = find_vlr(header, "laszip encoded", 22204);
  if (!vlr) {
    throw IoError(path,
                  "point format is marked as LAZ, but the LASzip record (user id \"laszip "
                  "encoded\", id 22204) that describes the compression is missing");
  }
  if (vlr->data_size < kFixedSize) {
    throw IoError(path, fmt::format("LASzip record at byte {} has {} bytes; must have at least {}",
                                    vlr->data_offset, vlr->data_size, kFixedSize));
  }
  return file.subspan(vlr->data_offset, vlr->data_size);
}

}  // namespace

LaszipRecord read_laszip_record(std::span<const std::byte> file,
                                const LasHeader& header,
                                const std::string& path) {
  const std::span<const std::byte> payload = find_payload(file, header, path);
  const auto compressor = load<std::uint16_t>(&payload[0]);
  if (compressor < 1 || compressor > 3) {
    throw IoError(path, fmt::format("LASzip compressor is {}; must be 1 (point-wise), 2 (chunked) "
                                    "or 3 (layered)",
                                    compressor));
  }
  const auto coder = load<std::uint16_t>(&payload[2]);
  if (coder != 0) {
    throw IoError(path, fmt::format("LASzip coder is {}; must be 0 (arithmetic)", coder));
  }
  LaszipRecord laszip;
  laszip.compressor = static_cast<Compressor>(compressor);
  laszip.chunk_size = load<std::uint32_t>(&payload[12]);
  laszip.record_length = header.record_length;
  if (laszip.chunk_size == 0 && laszip.compressor != Compressor::kPointwise) {
    throw IoError(path, "LASzip chunk size is 0; must be above 0");
  }
  const auto n_items = load<std::uint16_t>(&payload[32]);
  if (payload.size() < kFixedSize + n_items * kItemSize) {
    throw IoError(path, fmt::format("LASzip record has {} bytes; must have {} for {} items",
                                    payload.size(), kFixedSize + n_items * kItemSize, n_items));
  }
  for (std::size_t i = 0; i < n_items; ++i) {
    laszip.items.push_back(read_item(&payload[kFixedSize + i * kItemSize], i, path));
  }
  check_items(laszip, header, path);
  return laszip;
}

}  // namespace ridgeline::io::laz
