// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/block/block_json.h"

#include "apps/report/base64.h"
#include "evaluate/gates/gate_report.h"
#include "evaluate/tables/table2.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>

namespace ridgeline::apps {
using evaluate::Json;
using evaluate::number_json;
namespace {

constexpr int kBlockSchema = 1;

double to_digits(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

Json distance_json(const std::optional<float>& value) {
  return value ? Json(to_digits(*value, 4)) : Json(nullptr);
}

Json box_json(const Eigen::AlignedBox2d& box, const Eigen::Vector2d& origin_m) {
  const Eigen::Vector2d low = box.min() - origin_m, high = box.max() - origin_m;
  return {to_digits(low.x(), 3), to_digits(low.y(), 3), to_digits(high.x(), 3),
          to_digits(high.y(), 3)};
}

/// Coordinates as 16-bit numbers of steps within their range.
class Steps {
 public:
  static constexpr double kMaxSteps = std::numeric_limits<std::uint16_t>::max();

  void take(const Eigen::Vector2d& x) { box_.extend(x); }
  [[nodiscard]] std::uint16_t step_of(const Eigen::Vector2d& x, Eigen::Index axis) const {
    return static_cast<std::uint16_t>(std::lround((x[axis] - box_.min()[axis]) / step_m()[axis]));
  }
  [[nodiscard]] Json json() const {
    if (box_.isEmpty()) return {0.0, 0.0, 1.0, 1.0};
    return {box_.min().x(), box_.min().y(), step_m().x(), step_m().y()};
  }

 private:
  [[nodiscard]] Eigen::Vector2d step_m() const { return (box_.sizes() / kMaxSteps).cwiseMax(1e-9); }
  Eigen::AlignedBox2d box_;
};

/// Points in plan, with heights as 256 grey levels between the 2nd and the 98th percentile; null if
/// there are none.
Json relief_json(const BlockCloud& cloud,
                 const std::vector<std::uint32_t>& numbers,
                 const Eigen::Vector2d& shift_m) {
  if (numbers.empty()) return nullptr;
  Steps steps;
  std::vector<double> heights;
  for (const std::uint32_t i : numbers) {
    steps.take(cloud.x_m[i].head<2>() + shift_m);
    heights.push_back(cloud.x_m[i].z());
  }
  std::ranges::sort(heights);
  const double low = heights[heights.size() * 2 / 100];
  const double high = std::max(heights[heights.size() * 98 / 100], low + 0.01);
  std::vector<std::uint16_t> places;
  std::vector<std::uint8_t> greys;
  for (const std::uint32_t i : numbers) {
    const Eigen::Vector2d x = cloud.x_m[i].head<2>() + shift_m;
    places.push_back(steps.step_of(x, 0));
    places.push_back(steps.step_of(x, 1));
    const double share = std::clamp((cloud.x_m[i].z() - low) / (high - low), 0.0, 1.0);
    greys.push_back(static_cast<std::uint8_t>(std::lround(255.0 * share)));
  }
  return {{"n_shown", numbers.size()},  {"steps", steps.json()},        {"places", base64(places)},
          {"low_m", to_digits(low, 2)}, {"high_m", to_digits(high, 2)}, {"greys", base64(greys)}};
}

/// The ends of lines in plan, and their distances in millimetres; 65535 for a line that was not
/// judged.
Json plan_lines_json(const ShownLines& method, std::size_t n_most) {
  constexpr std::uint16_t kNotJudged = 65535;
  const std::vector<std::size_t> shown = thinned_lines(method.lines, n_most);
  Steps steps;
  for (const std::size_t i : shown) {
    const Segment3& s = method.lines[i].segment_m;
    for (const Eigen::Vector3d& x : {s.start, s.end}) steps.take(x.head<2>());
  }
  std::vector<std::uint16_t> ends, distances_mm;
  for (const std::size_t i : shown) {
    const ShownLine& line = method.lines[i];
    for (const Eigen::Vector3d& x : {line.segment_m.start, line.segment_m.end})
      for (const Eigen::Index axis : {0, 1}) ends.push_back(steps.step_of(x.head<2>(), axis));
    // rounded up, so that no line gets the colour of a smaller distance
    distances_mm.push_back(!line.mean_m ? kNotJudged
                                        : static_cast<std::uint16_t>(std::min(
                                              std::ceil(1000.0 * *line.mean_m - 1e-3), 65534.0)));
  }
  return {{"n_all", method.lines.size()},
          {"n_shown", shown.size()},
          {"steps", steps.json()},
          {"ends", base64(ends)},
          {"distances_mm", base64(distances_mm)}};
}

Json worst_lines_json(const BlockFolder& block, const ShownLines& method) {
  Json json = Json::array();
  for (const std::size_t i : worst_lines(method.lines, kMaxWorstLines)) {
    const ShownLine& line = method.lines[i];
    json.push_back({{"id", line.id},
                    {"patch", block.patches[line.patch].id},
                    {"class", method.words[line.line_class]},
                    {"kind", method.words[line.kind]},
                    {"status", method.words[line.status]},
                    {"length_m", to_digits(line.length_m, 2)},
                    {"mean_m", distance_json(line.mean_m)},
                    {"max_m", distance_json(line.max_m)},
                    {"n_images", line.n_images}});
  }
  return json;
}

Json figures_json(const PatchFigures& figures) {
  return {{"n_lines", figures.n_lines},
          {"n_evaluated", figures.n_evaluated},
          {"rms_m", number_json(figures.rms_m)},
          {"median_m", number_json(figures.median_m)},
          {"max_m", number_json(figures.max_m)},
          {"n_reference_lines", figures.n_reference_lines},
          {"n_reference_found", figures.n_reference_found}};
}

Json all_figures_json(const ShownPatch& patch) {
  Json json = Json::array();
  for (const PatchFigures& figures : patch.figures) json.push_back(figures_json(figures));
  return json;
}

Json patch_row_json(const BlockFolder& block, const ShownPatch& patch) {
  return {{"id", patch.id},
          {"square", patch.square},
          {"core", box_json(patch.core_m, block.origin_m)},
          {"n_images", patch.images.size()},
          {"reason", patch.reason},
          {"figures", all_figures_json(patch)}};
}

/// The part of run.json that the page shows, without times, so that identical results give
/// identical reports.
Json run_part_json(const Json& run) {
  Json json = Json::object();
  for (const char* key : {"command", "versions", "inputs", "page", "warnings"})
    if (run.contains(key)) json[key] = run[key];
  for (Json& input : json["inputs"])
    input["path"] = std::filesystem::path(input.value("path", "")).filename().string();
  return json;
}

Json area_json(const BlockFolder& block) {
  Json json = Json::array();
  for (const Eigen::Vector2d& x : block.area_m)
    json.push_back(
        {to_digits(x.x() - block.origin_m.x(), 3), to_digits(x.y() - block.origin_m.y(), 3)});
  return json;
}

Json cloud_part_json(const BlockCloud& cloud) {
  std::vector<std::uint32_t> all(cloud.x_m.size());
  std::iota(all.begin(), all.end(), 0U);
  Json json = relief_json(cloud, every_kth(all, kMaxPlanPoints), Eigen::Vector2d::Zero());
  if (json.is_null()) return json;
  json["n_read"] = cloud.n_read;
  json["n_all"] = cloud.n_all;
  return json;
}

}  // namespace

Json block_json(const BlockFolder& block,
                const BlockCloud& cloud,
                const std::optional<evaluate::GateReport>& gates) {
  Json patches = Json::array();
  for (const ShownPatch& patch : block.patches) patches.push_back(patch_row_json(block, patch));
  Json methods = Json::array();
  for (const ShownLines& method : block.methods) {
    methods.push_back({{"name", method.method},
                       {"lines", plan_lines_json(method, kMaxPlanLines / block.methods.size())},
                       {"worst", worst_lines_json(block, method)}});
  }
  return {{"schema", kBlockSchema},
          {"page", "block"},
          {"note", evaluate::kFixedSentence},
          {"name", block.name},
          {"crs", block.crs},
          {"origin_m", {block.origin_m.x(), block.origin_m.y()}},
          {"patch_size_m", block.patch_size_m},
          {"overlap_m", block.overlap_m},
          {"area", area_json(block)},
          {"n_without_views", block.n_without_views},
          {"notes", block.notes},
          {"run", run_part_json(block.run)},
          {"gates", gates ? Json::parse(evaluate::to_json(*gates)) : Json(nullptr)},
          {"table2", block.table2_rows},
          {"table2_footnote", block.table2_footnote},
          {"methods", std::move(methods)},
          {"patches", std::move(patches)},
          {"points", cloud_part_json(cloud)}};
}

PatchPages::PatchPages(const BlockFolder& block, const BlockCloud& cloud)
    : block_(block), cloud_(cloud), lines_of_(block.methods.size()) {
  for (std::size_t m = 0; m < lines_of_.size(); ++m) {
    lines_of_[m].resize(block.patches.size());
    const std::vector<ShownLine>& lines = block.methods[m].lines;
    for (std::size_t i = 0; i < lines.size(); ++i)
      lines_of_[m][lines[i].patch].push_back(static_cast<std::uint32_t>(i));
  }
  for (std::size_t i = 0; i < block.patches.size(); ++i)
    patch_of_square_[block.patches[i].square] = i;
}

/// Each line as [id, class, kind, status, length, mean, max, images, x, y, z, x, y, z].
Json PatchPages::lines_json(std::size_t method,
                            const ShownPatch& patch,
                            const std::vector<std::uint32_t>& lines) const {
  const ShownLines& all = block_.methods[method];
  const Eigen::Vector2d shift_m = block_.origin_m - patch.core_m.min();
  Json json = Json::array();
  for (const std::uint32_t i : lines) {
    const ShownLine& line = all.lines[i];
    Json row{line.id,
             all.words[line.line_class],
             all.words[line.kind],
             all.words[line.status],
             to_digits(line.length_m, 2),
             distance_json(line.mean_m),
             distance_json(line.max_m),
             line.n_images};
    for (const Eigen::Vector3d& x : {line.segment_m.start, line.segment_m.end}) {
      row.push_back(to_digits(x.x() + shift_m.x(), 2));
      row.push_back(to_digits(x.y() + shift_m.y(), 2));
      row.push_back(to_digits(x.z(), 2));
    }
    json.push_back(std::move(row));
  }
  return json;
}

Json PatchPages::neighbours_json(const ShownPatch& patch) const {
  struct Side {
    const char* name;
    std::int64_t column, row;
  };
  Json json = Json::object();
  for (const auto& [name, column, row] :
       {Side{"north", 0, 1}, Side{"east", 1, 0}, Side{"south", 0, -1}, Side{"west", -1, 0}}) {
    const auto found = patch_of_square_.find({patch.square[0] + column, patch.square[1] + row});
    if (found != patch_of_square_.end()) json[name] = block_.patches[found->second].id;
  }
  return json;
}

Json PatchPages::json_of(std::size_t i) const {
  const ShownPatch& patch = block_.patches[i];
  Json methods = Json::array();
  for (std::size_t m = 0; m < block_.methods.size(); ++m) {
    methods.push_back({{"name", block_.methods[m].method},
                       {"figures", figures_json(patch.figures[m])},
                       {"lines", lines_json(m, patch, lines_of_[m][i])}});
  }
  Json points = nullptr;
  if (i < cloud_.of_patch.size()) {
    const std::vector<std::uint32_t>& all = cloud_.of_patch[i];
    points =
        relief_json(cloud_, every_kth(all, kMaxPatchPoints), block_.origin_m - patch.core_m.min());
  }
  const Eigen::Vector2d corner_m = patch.core_m.min();
  return {{"schema", kBlockSchema},
          {"page", "patch"},
          {"note", evaluate::kFixedSentence},
          {"block", block_.name},
          {"id", patch.id},
          {"crs", block_.crs},
          {"origin_m", {corner_m.x(), corner_m.y()}},
          {"core", box_json(patch.core_m, corner_m)},
          {"area", box_json(patch.area_m, corner_m)},
          {"height_range_m", patch.height_range_m},
          {"images", patch.images},
          {"estimated_s", to_digits(patch.estimated_s, 1)},
          {"estimated_mib", to_digits(patch.estimated_mib, 0)},
          {"reason", patch.reason},
          {"neighbours", neighbours_json(patch)},
          {"table2", patch.table2_rows},
          {"methods", std::move(methods)},
          {"points", std::move(points)}};
}

}  // namespace ridgeline::apps
