// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/write_report.h"

#include "apps/common/say.h"
#include "apps/report/block/block_folder.h"
#include "apps/report/block/write_block_report.h"
#include "apps/report/figures.h"
#include "apps/report/page.h"
#include "evaluate/files/output_folder.h"
#include "io/error.h"
#include "io/images/png_writer.h"

#include <fmt/core.h>
#include <spdlog/spdlog.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <filesystem>
#include <functional>

namespace ridgeline::apps {
namespace {

struct ReportFigure {
  std::string name;
  std::function<cv::Mat()> draw;
};

std::vector<ReportFigure> figures_of(const ReportPatch& patch, const ShownScene& scene) {
  std::vector<ReportFigure> figures;
  if (patch.images && !patch.images->segments[0].empty()) {
    figures.push_back({patch.subfolder + "fig1.png", [&patch] { return figure1(patch); }});
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string& id = patch.patch->images[i].id;
      figures.push_back({fmt::format("{}fig7.{}.png", patch.subfolder, id),
                         [&patch, i] { return figure7(patch, i); }});
    }
  }
  for (std::size_t m = 0; m < patch.methods.size(); ++m) {
    figures.push_back(
        {fmt::format("{}fig8.{}.png", patch.subfolder, patch.methods[m].evaluation.method),
         [&patch, &scene, m] { return figure8(patch, scene, m); }});
  }
  return figures;
}

std::string title_of(const ReportInput& input) {
  std::string title = "Ridgeline report:";
  for (std::size_t i = 0; i < input.patches.size(); ++i) {
    title += (i == 0 ? " " : ", ") + input.patches[i].id;
  }
  return title;
}

constexpr const char* kReportFile = "report.html";

/// Prints the warnings of the page, except those that the run has already printed.
void warn_as_the_page(const ReportInput& input, const std::optional<evaluate::GateReport>& gates) {
  const auto said = input.run.value("warnings", std::vector<std::string>());
  for (const ReportPatch& patch : input.patches) {
    for (const std::string& note : patch.notes) {
      if (std::ranges::find(said, note) == said.end()) spdlog::warn("{}", note);
    }
  }
  if (!gates) return;
  for (const std::string& warning : gates->warnings) spdlog::warn("{}", warning);
}

std::string write_report_of(const ReportInput& input,
                            const std::string& folder,
                            const std::optional<evaluate::GateReport>& gates) {
  warn_as_the_page(input, gates);
  const results::OutputFolder out(folder, input.input_paths);
  (void)out.path(
      kReportFile);  // rejects a report written by somebody else before the figures are drawn
  std::vector<ShownScene> scenes(input.patches.size());
  tbb::parallel_for(std::size_t{0}, scenes.size(),
                    [&](std::size_t i) { scenes[i] = shown_scene(input.patches[i]); });
  std::vector<ReportFigure> figures;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    for (ReportFigure& figure : figures_of(input.patches[i], scenes[i])) {
      figures.push_back(std::move(figure));
    }
  }
  tbb::parallel_for(std::size_t{0}, figures.size(), [&](std::size_t i) {
    io::write_png(out.path(figures[i].name), figures[i].draw());
  });
  // bytes that are not UTF-8 (file names, ids) become U+FFFD
  const std::string data = report_json(input, scenes, gates)
                               .dump(-1, ' ', false, evaluate::Json::error_handler_t::replace);
  out.write(kReportFile, report_page(title_of(input), data, run_front_end()));
  return out.path(kReportFile);
}

}  // namespace

void add_report_flag(CLI::App& app, bool& report) {
  app.add_flag("!--no-report", report, "do not write report.html and its figures");
}

std::string write_report(const std::string& folder,
                         const std::optional<evaluate::GateReport>& gates,
                         const evaluate::Json& page) {
  if (is_block_folder(folder)) return write_block_report(folder, gates, page);
  try {
    ReportInput input = read_report_input(folder);
    input.run["page"].update(page);
    return write_report_of(input, folder, gates);
  } catch (const evaluate::Json::exception& error) {
    throw io::IoError(folder, std::string("a results file is damaged: ") + error.what());
  }
}

void write_report_of_run(const std::string& folder, bool is_wanted) {
  if (is_wanted) {
    try {
      say("Report: {}\n", write_report(folder));
      return;
    } catch (const std::exception& error) {
      spdlog::warn("the results are complete, but the report could not be written: {}",
                   error.what());
    }
  }
  try {
    const results::OutputFolder out(folder, {});
    remove_patch_pages(out, folder);
    out.remove(kReportFile);
  } catch (const std::exception& error) {
    spdlog::warn("the report of an earlier run could not be removed: {}", error.what());
  }
}

}  // namespace ridgeline::apps
