// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ridgeline::io::laz {

/// How much of layered records (point formats 6 to 10) is decoded. Omitted parts cost no time:
/// their layers are skipped by size. Formats 0 to 5 are always decoded completely, because all
/// their parts share one stream.
enum class RecordParts {
  kAll,
  kCloudPoint,  ///< what a CloudPoint holds: no scan angle, user data, time, colour, extra bytes
};

}  // namespace ridgeline::io::laz
