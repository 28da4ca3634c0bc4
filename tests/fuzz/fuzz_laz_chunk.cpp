// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as one chunk of every point format; the first byte chooses format and item version.
#include "io/cloud/laz/codec_error.h"
#include "io/cloud/laz/record_decoder.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace {

using namespace ridgeline::io::laz;

LaszipRecord pointwise_record(std::uint16_t version) {
  LaszipRecord laszip;
  laszip.items = {{ItemType::kPoint10, 20, version},
                  {ItemType::kGpsTime11, 8, version},
                  {ItemType::kRgb12, 6, version},
                  {ItemType::kWavePacket13, 29, 1},
                  {ItemType::kByte, 3, version}};
  return laszip;
}

LaszipRecord layered_record(std::uint16_t version, bool has_infrared) {
  LaszipRecord laszip;
  laszip.compressor = Compressor::kLayered;
  laszip.items = {
      {ItemType::kPoint14, 30, version},
      has_infrared ? Item{ItemType::kRgbNir14, 8, version} : Item{ItemType::kRgb14, 6, version},
      {ItemType::kWavePacket14, 29, version},
      {ItemType::kByte14, 3, version}};
  return laszip;
}

const std::array<LaszipRecord, 6> kRecords{pointwise_record(1),      pointwise_record(2),
                                           layered_record(3, false), layered_record(4, false),
                                           layered_record(3, true),  layered_record(4, true)};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int kMaxPoints = 5'000;  // a stream of repetitions is small and long at once
  if (size == 0) return 0;
  LaszipRecord laszip = kRecords[data[0] % kRecords.size()];
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
