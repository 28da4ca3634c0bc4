// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::simulate {

enum class ViewGroupKind : std::uint8_t {
  kStrip,    ///< vertical views of a strip flown along x
  kCross,    ///< vertical views of a strip flown along y
  kOblique,  ///< tilted views from all sides, aimed at the middle of the plan
};

/// The name of the kind in --views and in view ids: `strip`, `cross`, `oblique`.
const char* name(ViewGroupKind kind);

/// Views of the same kind.
struct ViewGroup {
  ViewGroupKind kind = ViewGroupKind::kStrip;
  int num_views = 2;
};

/// Parses a list of groups such as `strip:3,cross:2`. Throws std::invalid_argument for any other
/// text, and under the same conditions as check_view_groups().
std::vector<ViewGroup> parse_view_groups(std::string_view text);

/// Throws std::invalid_argument for a group without views, a kind that occurs twice, fewer than 2
/// views and more than 30.
void check_view_groups(std::span<const ViewGroup> groups);

}  // namespace ridgeline::simulate
