// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_records.h"

#include "io/cloud/bytes.h"
#include "reconstruct/geometry/check.h"

#include <cstdint>

namespace ridgeline::io {

namespace {

constexpr std::uint8_t kOldOverlapClass = 12;
constexpr unsigned kOverlapFlag = 0x08;

/// Transform by axis: x_in_local = scale * raw + offset.
struct RawTransform {
  double scale[3];
  double offset[3];
};

RawTransform local_from_raw(const LasHeader& header, const LocalFromFile& local_from_file) {
  RawTransform transform{};
  for (int axis = 0; axis < 3; ++axis) {
    const double unit_m = local_from_file.unit_m[axis];
    transform.scale[axis] = header.scale[axis] * unit_m;
    transform.offset[axis] = header.offset[axis] * unit_m - local_from_file.origin_m[axis];
  }
  return transform;
}

template <bool kIsExtended>
void decode_attributes(const std::byte* record, std::size_t source_id, CloudPoint& point) {
  const auto returns = load<std::uint8_t>(record + 14);
  const auto flags = load<std::uint8_t>(record + 15);
  point.intensity = load<std::uint16_t>(record + 12);
  point.source_id = load<std::uint16_t>(record + source_id);
  if constexpr (kIsExtended) {
    point.return_number = returns & 0x0FU;
    point.number_of_returns = static_cast<std::uint8_t>(returns >> 4U);
    point.flags = flags & 0x0FU;
    point.classification = load<std::uint8_t>(record + 16);
  } else {
    point.return_number = returns & 0x07U;
    point.number_of_returns = (returns >> 3U) & 0x07U;
    point.classification = flags & 0x1FU;
    const unsigned overlap = point.classification == kOldOverlapClass ? kOverlapFlag : 0U;
    point.flags = static_cast<std::uint8_t>((flags >> 5U) | overlap);
  }
}

template <bool kIsExtended>
void decode(std::span<const std::byte> records,
            const LasRecordLayout& layout,
            const RawTransform& transform,
            std::span<CloudPoint> points) {
  const std::byte* record = records.data();
  for (CloudPoint& point : points) {
    point.x = load<std::int32_t>(record) * transform.scale[0] + transform.offset[0];
    point.y = load<std::int32_t>(record + 4) * transform.scale[1] + transform.offset[1];
    point.z = load<std::int32_t>(record + 8) * transform.scale[2] + transform.offset[2];
    decode_attributes<kIsExtended>(record, layout.source_id, point);
    record += layout.record_length;
  }
}

}  // namespace

LasRecordLayout las_record_layout(const LasHeader& header) {
  const bool is_extended = header.point_format >= 6;
  return {.record_length = header.record_length,
          .source_id = is_extended ? 20U : 18U,
          .is_extended = is_extended};
}

void decode_las_records(std::span<const std::byte> records,
                        const LasHeader& header,
                        const LocalFromFile& local_from_file,
                        std::span<CloudPoint> points) {
  const LasRecordLayout layout = las_record_layout(header);
  check(records.size() == points.size() * layout.record_length,
        "decode_las_records: records = ", records.size(), " bytes, must be ", layout.record_length,
        " for each of ", points.size(), " points");
  const RawTransform transform = local_from_raw(header, local_from_file);
  if (layout.is_extended) {
    decode<true>(records, layout, transform, points);
  } else {
    decode<false>(records, layout, transform, points);
  }
}

}  // namespace ridgeline::io
