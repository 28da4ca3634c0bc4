// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/block/block_cloud.h"
#include "apps/report/block/block_folder.h"
#include "evaluate/gates/gate.h"
#include "evaluate/tables/summary_json.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace ridgeline::apps {

/// Maximum number of lines on the plan of a block, for all methods together.
inline constexpr std::size_t kMaxPlanLines = 200'000;
/// Maximum number of points drawn under the plan of a block.
inline constexpr std::size_t kMaxPlanPoints = 200'000;
/// Maximum number of rows in the table of worst lines.
inline constexpr std::size_t kMaxWorstLines = 100;

/// The data of a block's report, as declared in apps/report/web/src/block/schema.ts. Lengths are in
/// metres; coordinates are relative to `origin_m`; binary arrays are base64 of little-endian
/// values.
evaluate::Json block_json(const BlockFolder& block,
                          const BlockCloud& cloud,
                          const std::optional<evaluate::GateReport>& gates);

/// The data of the pages of individual patches.
class PatchPages {
 public:
  PatchPages(const BlockFolder& block, const BlockCloud& cloud);

  /// The data of the page of a patch; coordinates are relative to the corner of its square.
  [[nodiscard]] evaluate::Json json_of(std::size_t patch) const;

 private:
  [[nodiscard]] evaluate::Json lines_json(std::size_t method,
                                          const ShownPatch& patch,
                                          const std::vector<std::uint32_t>& lines) const;
  [[nodiscard]] evaluate::Json neighbours_json(const ShownPatch& patch) const;

  const BlockFolder& block_;
  const BlockCloud& cloud_;
  std::vector<std::vector<std::vector<std::uint32_t>>> lines_of_;  ///< by method and patch
  std::map<std::array<std::int64_t, 2>, std::size_t> patch_of_square_;
};

}  // namespace ridgeline::apps
