// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/block/block_folder.h"

#include "apps/report/path_shortener.h"
#include "evaluate/files/judged_map.h"
#include "evaluate/files/result_folder_reader.h"
#include "evaluate/statistics/product_method.h"
#include "io/error.h"
#include "io/files/csv_table.h"
#include "io/files/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <unordered_map>

namespace ridgeline::apps {
namespace fs = std::filesystem;
using evaluate::Json;
namespace {

using PatchNumbers = std::unordered_map<std::string, std::uint32_t>;

Eigen::AlignedBox2d box_of(const Json& numbers) {
  return {Eigen::Vector2d(numbers.at(0).get<double>(), numbers.at(1).get<double>()),
          Eigen::Vector2d(numbers.at(2).get<double>(), numbers.at(3).get<double>())};
}

ShownPatch patch_of(const Json& entry) {
  ShownPatch patch;
  patch.id = entry.at("id").get<std::string>();
  patch.square = entry.at("square").get<std::array<std::int64_t, 2>>();
  patch.core_m = box_of(entry.at("core_m"));
  patch.area_m = box_of(entry.at("area_m"));
  patch.height_range_m = entry.at("height_range_m").get<std::array<double, 2>>();
  patch.images = entry.at("images").get<std::vector<std::string>>();
  patch.estimated_s = entry.at("estimated_s").get<double>();
  patch.estimated_mib = entry.at("estimated_mib").get<double>();
  return patch;
}

void take_plan(const Json& plan, BlockFolder& block) {
  block.name = plan.at("plan").get<std::string>();
  block.crs = plan.at("crs").get<std::string>();
  block.patch_size_m = plan.at("patch_size_m").get<double>();
  block.overlap_m = plan.at("overlap_m").get<double>();
  block.n_without_views = plan.at("n_squares_without_views").get<std::size_t>();
  block.notes = plan.at("warnings").get<std::vector<std::string>>();
  for (const Json& corner : plan.at("area_m"))
    block.area_m.emplace_back(corner.at(0).get<double>(), corner.at(1).get<double>());
  Eigen::AlignedBox2d all;
  for (const Json& entry : plan.at("patches"))
    all.extend(block.patches.emplace_back(patch_of(entry)).core_m);
  if (!all.isEmpty()) block.origin_m = all.min().array().floor();
}

/// The rows of patches.csv, which are grouped by method.
class PatchRows {
 public:
  explicit PatchRows(const std::string& path) : table_(path) {}

  void read(const PatchNumbers& number_of, BlockFolder& block) {
    for (std::size_t row = 0; row < table_.size(); ++row) {
      const std::string method(text(row, "method"));
      if (block.methods.empty() || block.methods.back().method != method)
        block.methods.emplace_back().method = method;
      const auto found = number_of.find(std::string(text(row, "patch")));
      if (found == number_of.end()) {
        throw io::IoError(table_.place_of(row),
                          "belongs to a patch that is not in plan.json; merge the block again");
      }
      ShownPatch& patch = block.patches[found->second];
      patch.reason = text(row, "reason");
      patch.figures.push_back(figures_of(row));
    }
    for (const ShownPatch& patch : block.patches) {
      if (patch.figures.size() == block.methods.size()) continue;
      throw io::IoError(table_.place_of(0),
                        "patches of plan.json are missing; merge the block again");
    }
  }

 private:
  [[nodiscard]] std::string_view text(std::size_t row, std::string_view column) const {
    return table_.text(row, table_.column(column));
  }
  [[nodiscard]] std::size_t count(std::size_t row, std::string_view column) const {
    return static_cast<std::size_t>(table_.index(row, table_.column(column)));
  }
  [[nodiscard]] std::optional<double> figure(std::size_t row, std::string_view column) const {
    if (text(row, column).empty()) return std::nullopt;
    return table_.number(row, table_.column(column));
  }
  [[nodiscard]] PatchFigures figures_of(std::size_t row) const {
    return {.n_lines = count(row, "n_lines"),
            .n_evaluated = count(row, "n_evaluated"),
            .rms_m = figure(row, "rms_m"),
            .median_m = figure(row, "median_m"),
            .max_m = figure(row, "max_m"),
            .n_reference_lines = count(row, "n_reference_lines"),
            .n_reference_found = count(row, "n_reference_found")};
  }

  io::CsvTable table_;
};

void put_product_first(BlockFolder& block) {
  const std::size_t product = evaluate::product_index(block.methods, &ShownLines::method);
  const auto to_front = [&](auto& list) {
    std::rotate(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(product),
                list.begin() + static_cast<std::ptrdiff_t>(product) + 1);
  };
  if (block.methods.empty()) return;
  to_front(block.methods);
  for (ShownPatch& patch : block.patches) to_front(patch.figures);
}

void read_table2(const fs::path& file, const PatchNumbers& number_of, BlockFolder& block) {
  Json table = Json::parse(io::read_text_file(file.string()));
  block.table2_footnote = table.at("footnote");
  for (Json& row : table.at("rows")) {
    const auto patch = number_of.find(row.at("patch").get<std::string>());
    Json& rows =
        patch == number_of.end() ? block.table2_rows : block.patches[patch->second].table2_rows;
    rows.push_back(std::move(row));
  }
}

void read_lines(const fs::path& folder, const PatchNumbers& number_of, BlockFolder& block) {
  const bool is_judged = block.run.contains("cloud");
  for (ShownLines& method : block.methods) {
    const std::string name =
        is_judged ? results::map_name(method.method) : fmt::format("lines.{}.gpkg", method.method);
    method = read_shown_lines((folder / name).string(), method.method, block.origin_m, number_of);
  }
}

void read_inputs(BlockFolder& block) {
  for (const Json& input : block.run.value("inputs", Json::array())) {
    const auto path = input.at("path").get<std::string>();
    block.input_paths.push_back(path);
    if (input.at("role") == "cloud")
      block.clouds.push_back({path, input.at("bytes").get<std::uint64_t>()});
  }
}

/// Reasons and warnings name files, the location of which concerns only the sender.
void shorten_paths(const fs::path& folder, const std::string& block_file, BlockFolder& block) {
  std::vector<std::string> paths = block.input_paths;
  paths.push_back(block_file);
  paths.push_back((folder / "run.json").string());
  const PathShortener shortener(paths);
  shortener.shorten(block.run);
  for (std::string& note : block.notes) shortener.shorten(note);
  for (ShownPatch& patch : block.patches) shortener.shorten(patch.reason);
}

BlockFolder read_folder(const fs::path& folder) {
  BlockFolder block;
  block.run = results::read_run_json(folder);
  const Json plan = Json::parse(io::read_text_file((folder / "plan.json").string()));
  take_plan(plan, block);
  PatchNumbers number_of;
  for (const ShownPatch& patch : block.patches)
    number_of.emplace(patch.id, static_cast<std::uint32_t>(number_of.size()));
  PatchRows((folder / "patches.csv").string()).read(number_of, block);
  put_product_first(block);
  read_lines(folder, number_of, block);
  if (block.run.contains("cloud")) read_table2(folder / "table2.json", number_of, block);
  read_inputs(block);
  shorten_paths(folder, plan.at("block_file").get<std::string>(), block);
  return block;
}

}  // namespace

bool is_block_folder(const fs::path& folder) {
  return fs::exists(folder / "plan.json") && fs::exists(folder / "run.json") &&
         results::read_run_json(folder).value("command", "") == "block";
}

BlockFolder read_block_folder(const fs::path& folder) {
  try {
    return read_folder(fs::absolute(folder).lexically_normal());
  } catch (const Json::exception& error) {
    throw io::IoError(folder.string(), fmt::format("a results file is damaged: {}", error.what()));
  }
}

}  // namespace ridgeline::apps
