// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/cloud_options.h"
#include "apps/common/command.h"
#include "apps/common/option_flags.h"
#include "apps/common/progress.h"
#include "apps/common/say.h"
#include "apps/common/shared_options.h"
#include "apps/edges/edges_page.h"
#include "evaluate/files/cloud_name.h"
#include "evaluate/files/output_folder.h"
#include "evaluate/files/plan_scale.h"
#include "evaluate/files/scan_cells.h"
#include "evaluate/files/scan_lines.h"
#include "evaluate/scan/edge_kinds.h"
#include "evaluate/tables/format.h"
#include "evaluate/tables/text_table.h"
#include "io/files/atomic_file.h"
#include "io/files/expand_patterns.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ridgeline::apps {
namespace {

struct EdgesArguments {
  CloudArguments cloud;
  std::string out, format;
  double min_length_m = 1.0;
  bool only_roofs = false, report = true, overwrite = false, local_origin = false;
};

/// Reads the cloud and finds its edges, with a progress bar.
results::EdgesOfCloud find_all_edges(io::CloudFiles& cloud, const EdgesArguments& a) {
  Progress progress(1);
  return results::edges_of_cloud(
      cloud, {}, a.cloud.cloud_memory_mib << 20U,
      [&](std::size_t n_done, std::size_t n_total) {
        progress.show(n_done, n_total, "cells of the map");
      },
      {.only_roofs = a.only_roofs || results::keeps_only_buildings(read_options(a.cloud))});
}

/// The page of the file: edges.html for edges.gpkg; empty for none.
std::string page_of(const EdgesArguments& a, io::LineFormat format) {
  if (!a.report) return "";
  std::string_view name = a.out;
  for (const io::LineFormatInfo& info : io::line_formats()) {
    if (info.format == format && name.ends_with(info.extension)) {
      name.remove_suffix(info.extension.size());
      return std::string(name) + ".html";
    }
  }
  return std::filesystem::path(a.out).replace_extension(".html").string();
}

std::string table_of(const evaluate::ScanEdges& edges) {
  evaluate::PrintedTable table({"kind", "edges:", "length m:", "sigma m:"});
  for (const evaluate::EdgesOfKind& row : evaluate::by_kind(edges.edges)) {
    table.add(
        row.kind, row.n, evaluate::fixed(row.length_m, 1),
        row.n == 0 ? std::string(evaluate::kNoValue) : evaluate::fixed(row.median_sigma_m, 3));
  }
  return evaluate::captioned("Edges of the cloud", table, evaluate::Markup::kPlain);
}

int run_edges(const EdgesArguments& a) {
  const io::LineFormat format = line_format_of(a.out, a.format);
  io::require_writable(format);
  const std::string page = page_of(a, format);
  std::vector<std::string> others = io::expand_patterns(a.cloud.clouds);
  results::check_output_file(a.out, others, a.overwrite);
  others.push_back(a.out);
  results::check_output_file(page, others, a.overwrite);
  io::CloudFiles cloud(a.cloud.clouds, read_options(a.cloud));
  std::vector<std::string> warnings;
  results::set_plan_scale(a.cloud.scale_to_ground, cloud, warnings);
  results::EdgesOfCloud found = find_all_edges(cloud, a);
  warn_of(warnings);
  warn_of(found.readings.cloud.warnings);
  require_points(found.readings, cloud);
  results::drop_short_edges(a.min_length_m, found.edges);
  results::write_scan_edges(a.out, found.edges, cloud, format, {.local_origin = a.local_origin});
  if (!page.empty()) {
    io::write_file(page, edges_page(results::cloud_name(a.cloud.clouds), found.edges, cloud));
  }
  say("{}\n", table_of(found.edges));
  say("{}: {} edges of {} roof planes\n", a.out, found.edges.edges.size(),
      std::ranges::count(found.edges.planes, true, &evaluate::ScanPlane::is_roof));
  if (!page.empty()) say("Page: {}\n", page);
  return kDone;
}

}  // namespace

Run add_edges(CLI::App& subcommand) {
  auto a = std::make_shared<EdgesArguments>();
  add_cloud_option(subcommand, a->cloud)->required();
  subcommand
      .add_option("--out", a->out,
                  "file for the 3D lines; a GeoPackage also has the roof planes and a style")
      ->required();
  add_line_format_option(subcommand, a->format);
  subcommand.add_option("--min-length-m", a->min_length_m, "shortest edge to write, m")
      ->check(in_range(0.0, 1e6))
      ->capture_default_str();
  subcommand.add_flag("--only-roofs", a->only_roofs,
                      "the points are those of roofs alone, as with --classes 6: a roof then ends "
                      "where the points end");
  add_assume_crs_option(subcommand, a->cloud);
  add_scale_to_ground_flag(subcommand, a->cloud);
  subcommand.add_flag("!--no-report", a->report,
                      "do not write the page, an .html next to --out with plan and sections");
  add_overwrite_flag(subcommand, a->overwrite);
  add_local_origin_flag(subcommand, a->local_origin);
  add_cloud_filters(subcommand, a->cloud);
  return [a] { return run_edges(*a); };
}

}  // namespace ridgeline::apps
