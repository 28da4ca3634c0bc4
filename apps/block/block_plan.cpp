// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/block_plan.h"

#include "io/error.h"
#include "io/files/text_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ridgeline::apps {
using nlohmann::ordered_json;
namespace {

ordered_json json_of(const Eigen::AlignedBox2d& box) {
  return {box.min().x(), box.min().y(), box.max().x(), box.max().y()};
}

Eigen::AlignedBox2d box_of(const nlohmann::json& numbers) {
  return {Eigen::Vector2d(numbers.at(0), numbers.at(1)),
          Eigen::Vector2d(numbers.at(2), numbers.at(3))};
}

ordered_json json_of(const FileState& file) {
  return {{"role", file.role},
          {"path", file.path},
          {"bytes", file.bytes},
          {"modified_ns", file.modified_ns},
          {"sha256", file.sha256}};
}

FileState file_of(const nlohmann::json& entry) {
  return {entry.at("role"), entry.at("path"), entry.at("bytes"), entry.at("modified_ns"),
          entry.at("sha256")};
}

ordered_json json_of(const PlannedFrame& frame) {
  ordered_json entry{{"id", frame.id}};
  entry.update(json_of(frame.file));
  entry["radiometry"] = frame.radiometry;
  return entry;
}

ordered_json json_of(const PlannedPatch& patch) {
  return {{"id", patch.id},
          {"square", {patch.cell.column, patch.cell.row}},
          {"core_m", json_of(patch.core_m)},
          {"area_m", json_of(patch.area_m)},
          {"height_range_m", patch.height_range_m},
          {"images", patch.images},
          {"windows_mpx", patch.windows_mpx},
          {"estimated_s", patch.estimated_s},
          {"estimated_mib", patch.estimated_mib}};
}

PlannedPatch patch_of(const nlohmann::json& entry) {
  PlannedPatch patch;
  patch.id = entry.at("id");
  patch.cell = {entry.at("square").at(0), entry.at("square").at(1)};
  patch.core_m = box_of(entry.at("core_m"));
  patch.area_m = box_of(entry.at("area_m"));
  patch.height_range_m = entry.at("height_range_m");
  patch.images = entry.at("images").get<std::vector<std::string>>();
  patch.windows_mpx = entry.at("windows_mpx");
  patch.estimated_s = entry.at("estimated_s");
  patch.estimated_mib = entry.at("estimated_mib");
  return patch;
}

template <typename Item, typename ToJson>
ordered_json list_of(const std::vector<Item>& items, const ToJson& to_json) {
  ordered_json list = ordered_json::array();
  for (const Item& item : items) list.push_back(to_json(item));
  return list;
}

BlockPlan plan_of(const nlohmann::json& document) {
  BlockPlan plan;
  plan.block = document.at("plan");
  plan.block_file = document.at("block_file");
  plan.key = document.at("key");
  plan.crs = document.at("crs");
  plan.patch_size_m = document.at("patch_size_m");
  plan.overlap_m = document.at("overlap_m");
  for (const nlohmann::json& corner : document.at("area_m"))
    plan.area_m.emplace_back(corner.at(0), corner.at(1));
  for (const nlohmann::json& entry : document.at("inputs")) plan.inputs.push_back(file_of(entry));
  for (const nlohmann::json& entry : document.at("frames")) {
    plan.frames.push_back({file_of(entry), entry.at("id"), entry.at("radiometry")});
  }
  for (const nlohmann::json& entry : document.at("patches"))
    plan.patches.push_back(patch_of(entry));
  plan.extent_m = box_of(document.at("extent_m"));
  plan.n_without_views = document.at("n_squares_without_views");
  plan.warnings = document.at("warnings").get<std::vector<std::string>>();
  return plan;
}

}  // namespace

reconstruct::PatchGrid grid_of(const BlockPlan& plan) {
  return {plan.patch_size_m, plan.extent_m, plan.overlap_m};
}

std::string to_json(const BlockPlan& plan) {
  ordered_json document{
      {"plan", plan.block}, {"block_file", plan.block_file},     {"key", plan.key},
      {"crs", plan.crs},    {"patch_size_m", plan.patch_size_m}, {"overlap_m", plan.overlap_m}};
  document["extent_m"] = json_of(plan.extent_m);
  document["area_m"] = list_of(plan.area_m, [](const Eigen::Vector2d& x) {
    return ordered_json{x.x(), x.y()};
  });
  const auto json_of_any = [](const auto& item) { return json_of(item); };
  document["inputs"] = list_of(plan.inputs, json_of_any);
  document["frames"] = list_of(plan.frames, json_of_any);
  document["patches"] = list_of(plan.patches, json_of_any);
  document["n_squares_without_views"] = plan.n_without_views;
  document["warnings"] = plan.warnings;
  return document.dump(1) + "\n";
}

BlockPlan read_block_plan(const std::string& path) {
  try {
    return plan_of(nlohmann::json::parse(io::read_text_file(path)));
  } catch (const nlohmann::json::exception& error) {
    throw io::IoError(
        path, fmt::format("is not a block plan ({}); remove it and plan again", error.what()));
  }
}

void require_unchanged(const FileState& file) {
  if (is_unchanged(file)) return;
  throw io::IoError(file.path,
                    "has changed since the block was planned; restore it, or remove plan.json to "
                    "plan again (patches that do not depend on it keep their results)");
}

}  // namespace ridgeline::apps
