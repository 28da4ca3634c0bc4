// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/block/write_block_report.h"

#include "apps/report/block/block_json.h"
#include "apps/report/page.h"
#include "apps/report/path_shortener.h"
#include "evaluate/files/output_folder.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <tbb/parallel_for.h>

#include <set>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPagesFolder = "pages";

/// Bytes that are not UTF-8 (file names, ids) become U+FFFD.
std::string text_of(const evaluate::Json& json) {
  return json.dump(-1, ' ', false, evaluate::Json::error_handler_t::replace);
}

std::string page_name(const std::string& patch) {
  return fmt::format("{}/{}.html", kPagesFolder, patch);
}

/// Removes pages that the program wrote and whose names are not among `kept`.
void remove_pages_but(const results::OutputFolder& out, const std::set<std::string>& kept) {
  for (const std::string& page : out.own_files_in(kPagesFolder))
    if (!kept.contains(page)) out.remove(page);
}

BlockCloud cloud_of(BlockFolder& block) {
  if (block.clouds.empty()) {
    block.notes.emplace_back("no LIDAR: lines are shown but not judged");
    return {};
  }
  try {
    return read_block_cloud(block);
  } catch (const std::exception& error) {
    std::string note = fmt::format("LIDAR is not shown: {}", error.what());
    PathShortener(transformed(block.clouds, &JudgingCloud::path)).shorten(note);
    spdlog::warn("{}", note);
    block.notes.push_back(std::move(note));
    return {};
  }
}

void write_pages(const results::OutputFolder& out,
                 const BlockFolder& block,
                 const BlockCloud& cloud) {
  const PatchPages pages(block, cloud);
  tbb::parallel_for(std::size_t{0}, block.patches.size(), [&](std::size_t i) {
    const std::string& id = block.patches[i].id;
    out.write(page_name(id), report_page(fmt::format("Patch {} of block {}", id, block.name),
                                         text_of(pages.json_of(i)), block_front_end()));
  });
  std::set<std::string> names;
  for (const ShownPatch& patch : block.patches) names.insert(page_name(patch.id));
  remove_pages_but(out, names);
}

}  // namespace

std::string write_block_report(const fs::path& folder,
                               const std::optional<evaluate::GateReport>& gates,
                               const evaluate::Json& page) {
  BlockFolder block = read_block_folder(folder);
  block.run["page"].update(page);
  const results::OutputFolder out(folder, block.input_paths);
  constexpr const char* kReport = "report.html";
  (void)out.path(kReport);
  for (const ShownPatch& patch : block.patches) (void)out.path(page_name(patch.id));
  const BlockCloud cloud = cloud_of(block);
  write_pages(out, block, cloud);
  out.write(kReport, report_page(fmt::format("Ridgeline report: block {}", block.name),
                                 text_of(block_json(block, cloud, gates)), block_front_end()));
  return out.path(kReport);
}

void remove_patch_pages(const results::OutputFolder& out, const fs::path& folder) {
  remove_pages_but(out, {});
  std::error_code none;
  fs::remove(folder / kPagesFolder, none);  // stays if it contains other files
}

}  // namespace ridgeline::apps
