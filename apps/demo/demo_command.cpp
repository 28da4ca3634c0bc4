// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/exit_code.h"
#include "apps/common/output_folder.h"
#include "apps/common/sample_data.h"
#include "apps/evaluate/judge_files.h"
#include "apps/evaluate/write_results.h"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

/// The lines of three quality grades of a sample patch against its LIDAR.
JudgeFilesOptions options_of(const fs::path& patch) {
  JudgeFilesOptions options;
  for (const char* grade : {"good", "fair", "poor"}) {
    options.line_paths.push_back((patch / fmt::format("lines.{}.geojson", grade)).string());
  }
  options.cloud_paths = {(patch / "lidar.las").string()};
  options.reference_lines = (patch / "truth.geojson").string();
  options.patch_name = patch.filename().string();
  return options;
}

int run_demo(const std::string& folder) {
  RunRecord record("demo");
  const OutputFolder out(folder, {});
  std::vector<evaluate::Evaluation> all;
  std::vector<TruthRows> truth;
  for (const fs::path& patch : sample_patches()) {
    const JudgeFilesOptions options = options_of(patch);
    JudgedFiles judged = judge_files(options, record);
    for (evaluate::Evaluation& e : judged.evaluations) {
      e.method = fs::path(e.method).extension().string().substr(1);  // lines.good -> good
    }
    truth.insert(truth.end(), judged.truth.begin(), judged.truth.end());
    write_evaluations(judged.evaluations, out, options.patch_name + "/");
    for (const std::string& path : options.line_paths) record.add_input("lines", path);
    record.add_input("cloud", options.cloud_paths.front());
    all.insert(all.end(), judged.evaluations.begin(), judged.evaluations.end());
  }
  write_truth(truth, out);
  fmt::print("{}", write_table2(all, out));
  out.write("run.json", record.to_json());
  fmt::print("\nResults: {}\n", fs::absolute(folder).lexically_normal().string());
  return kDone;
}

}  // namespace

Run add_demo(CLI::App& subcommand) {
  auto out = std::make_shared<std::string>("ridgeline_demo");
  subcommand.add_option("--out", *out, "folder for the results")->capture_default_str();
  return [out] { return run_demo(*out); };
}

}  // namespace ridgeline::apps
