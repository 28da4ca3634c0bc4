// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/view_groups.h"

#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace ridgeline::simulate {
namespace {

constexpr std::array kKinds{ViewGroupKind::kStrip, ViewGroupKind::kCross, ViewGroupKind::kOblique};

ViewGroup parse_group(std::string_view text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const auto* const kind = std::ranges::find_if(
      kKinds, [&](ViewGroupKind k) { return text.substr(0, colon) == name(k); });
  const char* const end = text.data() + text.size();
  const char* const digits = std::min(text.data() + colon + 1, end);
  ViewGroup group;
  const auto [parsed_to, error] = std::from_chars(digits, end, group.num_views);
  check(kind != kKinds.end() && error == std::errc() && parsed_to == end, "'", text,
        "', must be strip:N, cross:N or oblique:N with a number of views, or several of them with "
        "commas between");
  group.kind = *kind;
  return group;
}

}  // namespace

const char* name(ViewGroupKind kind) {
  switch (kind) {
    case ViewGroupKind::kStrip:
      return "strip";
    case ViewGroupKind::kCross:
      return "cross";
    case ViewGroupKind::kOblique:
      return "oblique";
  }
  return "";
}

std::vector<ViewGroup> parse_view_groups(std::string_view text) {
  std::vector<ViewGroup> groups;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    groups.push_back(parse_group(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  check_view_groups(groups);
  return groups;
}

void check_view_groups(std::span<const ViewGroup> groups) {
  constexpr int kMinViews = 2;
  constexpr int kMaxViews = 30;
  int num_views = 0;
  for (const ViewGroup& group : groups) {
    check(group.num_views >= 1 && group.num_views <= kMaxViews, name(group.kind), ":",
          group.num_views, ", must have 1 to ", kMaxViews, " views");
    check(std::ranges::count(groups, group.kind, &ViewGroup::kind) == 1, name(group.kind),
          " is there more than once; each group must be named once");
    num_views += group.num_views;
  }
  check(num_views >= kMinViews && num_views <= kMaxViews, "views in all = ", num_views,
        ", must be ", kMinViews, " to ", kMaxViews);
}

}  // namespace ridgeline::simulate
