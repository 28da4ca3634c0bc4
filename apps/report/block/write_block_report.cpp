// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/block/write_block_report.h"

#include "apps/report/block/block_json.h"
#include "apps/report/page.h"
#include "apps/report/path_shortener.h"
#include "io/results/output_folder.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPagesFolder = "pages";

/// Bytes that are not UTF-8 (file names, ids) become U+FFFD.
std::string text_of(const evaluate::Json& json) {
  return json.dump(-1, ' ', false, evaluate::Json::error_handler_t::replace);
}

std::string page_name(const std::string& patch) { return patch + ".html"; }

/// Removes pages whose names are not among `kept`.
void remove_pages_but(const fs::path& pages, const std::set<std::string>& kept) {
  if (!fs::is_directory(fs::symlink_status(pages))) return;
  std::vector<fs::path> gone;
  for (const auto& entry : fs::directory_iterator(pages)) {
    const bool is_page = entry.path().extension() == ".html" && entry.is_regular_file();
    if (is_page && kept.count(entry.path().filename().string()) == 0) gone.push_back(entry.path());
  }
  for (const fs::path& page : gone) fs::remove(page);
}

BlockCloud cloud_of(BlockFolder& block) {
  if (block.clouds.empty()) {
    block.notes.emplace_back("no LIDAR: lines are shown, but not judged");
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

/// The inputs that lie in a folder. Each page is compared with them before it is written, and a block has thousands of both.
std::vector<std::string> inputs_in(const fs::path& folder, const BlockFolder& block) {
  const fs::path canonical = fs::weakly_canonical(folder);
  std::vector<std::string> inputs;
  for (const std::string& path : block.input_paths)
    if (fs::weakly_canonical(path).parent_path() == canonical) inputs.push_back(path);
  return inputs;
}

void write_pages(const fs::path& folder, const BlockFolder& block, const BlockCloud& cloud) {
  const results::OutputFolder out(folder, inputs_in(folder, block));
  const PatchPages pages(block, cloud);
  tbb::parallel_for(std::size_t{0}, block.patches.size(), [&](std::size_t i) {
    const std::string& id = block.patches[i].id;
    out.write(page_name(id), report_page(fmt::format("Patch {} of block {}", id, block.name),
                                         text_of(pages.json_of(i)), block_front_end()));
  });
  std::set<std::string> names;
  for (const ShownPatch& patch : block.patches) names.insert(page_name(patch.id));
  remove_pages_but(folder, names);
}

}  // namespace

std::string write_block_report(const fs::path& folder,
                               const std::optional<evaluate::GateReport>& gates) {
  BlockFolder block = read_block_folder(folder);
  const results::OutputFolder out(folder, block.input_paths);
  (void)out.path(fmt::format("{}/index.html", kPagesFolder));  // refuses a link
  const BlockCloud cloud = cloud_of(block);
  write_pages(folder / kPagesFolder, block, cloud);
  constexpr const char* kReport = "report.html";
  out.write(kReport, report_page(fmt::format("Ridgeline report: block {}", block.name),
                                 text_of(block_json(block, cloud, gates)), block_front_end()));
  return out.path(kReport);
}

void remove_patch_pages(const fs::path& folder) {
  remove_pages_but(folder / kPagesFolder, {});
  std::error_code none;
  fs::remove(folder / kPagesFolder, none);  // stays if something of the user's is there
}

}  // namespace ridgeline::apps
