// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/sample_data.h"
#include "apps/report/write_report.h"
#include "apps/run/run_patches.h"

#include <memory>

namespace ridgeline::apps {
namespace {

int run_demo(const std::string& folder, const RunOptions& options) {
  std::vector<std::string> patch_files;
  for (const std::filesystem::path& patch : sample_patches()) {
    patch_files.push_back((patch / "patch.yaml").string());
  }
  run_patches("demo", patch_files, options, folder);
  return kDone;
}

}  // namespace

Run add_demo(CLI::App& subcommand) {
  struct DemoArguments {
    std::string out = "ridgeline_demo";
    RunOptions options;
  };
  auto a = std::make_shared<DemoArguments>();
  // the papers' Table 2, next to the default result of a run
  a->options.methods = {reconstruct::Method::kDirect, reconstruct::Method::kJoint,
                        reconstruct::Method::kLines};
  subcommand.add_option("--out", a->out, "folder for the results")->capture_default_str();
  add_report_flag(subcommand, a->options.report);
  return [a] { return run_demo(a->out, a->options); };
}

}  // namespace ridgeline::apps
