// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_header.h"
#include "io/cloud/local_from_file.h"
#include "io/cloud/point_cloud.h"

#include <cstddef>
#include <span>

namespace ridgeline::io {

/// Byte offsets of the fields that are kept from a point record. X, Y, Z and the intensity are at
/// 0, 4, 8 and 12 in every format.
struct LasRecordLayout {
  std::size_t record_length = 20;  ///< step from record to record, including extra bytes
  std::size_t source_id = 18;
  /// Formats 6-10: returns in 4 + 4 bits, flags in a separate byte. Formats 0-5: returns in 3 + 3
  /// bits, flags in the upper bits of the class byte.
  bool is_extended = false;
};

LasRecordLayout las_record_layout(const LasHeader& header);

/// Decodes whole uncompressed records, one per point, in order. In formats 0-5, points of class 12
/// get the overlap flag. Throws std::invalid_argument unless `records` has record_length bytes for
/// each of `points`.
void decode_las_records(std::span<const std::byte> records,
                        const LasHeader& header,
                        const LocalFromFile& local_from_file,
                        std::span<CloudPoint> points);

}  // namespace ridgeline::io
