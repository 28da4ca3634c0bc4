// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as one chunk of every point format; the first byte chooses the items of a record and
// their version.
#include "io/cloud/laz/codec_error.h"
#include "io/cloud/laz/record_decoder.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace {

using namespace ridgeline::io::laz;

// Which items a record has, and how they are coded; bits of the first byte.
constexpr unsigned kLayered = 0x01, kNewer = 0x02, kTime = 0x04, kColour = 0x08, kInfrared = 0x10,
                   kWave = 0x20, kExtra = 0x40;

LaszipRecord pointwise_record(unsigned choice) {
  const std::uint16_t version = (choice & kNewer) != 0 ? 2 : 1;
  LaszipRecord laszip;
  laszip.items = {{ItemType::kPoint10, 20, version}};
  if ((choice & kTime) != 0) laszip.items.push_back({ItemType::kGpsTime11, 8, version});
  if ((choice & kColour) != 0) laszip.items.push_back({ItemType::kRgb12, 6, version});
  if ((choice & kWave) != 0) laszip.items.push_back({ItemType::kWavePacket13, 29, 1});
  if ((choice & kExtra) != 0) laszip.items.push_back({ItemType::kByte, 3, version});
  return laszip;
}

LaszipRecord layered_record(unsigned choice) {
  const std::uint16_t version = (choice & kNewer) != 0 ? 4 : 3;
  LaszipRecord laszip;
  laszip.compressor = Compressor::kLayered;
  laszip.items = {{ItemType::kPoint14, 30, version}};
  if ((choice & kInfrared) != 0) {
    laszip.items.push_back({ItemType::kRgbNir14, 8, version});
  } else if ((choice & kColour) != 0) {
    laszip.items.push_back({ItemType::kRgb14, 6, version});
  }
  if ((choice & kWave) != 0) laszip.items.push_back({ItemType::kWavePacket14, 29, version});
  if ((choice & kExtra) != 0) laszip.items.push_back({ItemType::kByte14, 3, version});
  return laszip;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int kMaxPoints = 5'000;  // a stream of repetitions is small and long at once
  if (size == 0) return 0;
  LaszipRecord laszip =
      (data[0] & kLayered) != 0 ? layered_record(data[0]) : pointwise_record(data[0]);
  for (const Item& item : laszip.items) {
    laszip.record_length = static_cast<std::uint16_t>(laszip.record_length + item.size);
  }
  std::vector<std::byte> record(laszip.record_length);
  try {
    const auto decoder = make_record_decoder(laszip, std::as_bytes(std::span(data + 1, size - 1)),
                                             RecordParts::kAll);
    for (int i = 0; i < kMaxPoints; ++i) decoder->next(record.data());
  } catch (const CodecError&) {
  }
  return 0;
}
